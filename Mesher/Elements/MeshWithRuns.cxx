#include "Elements/MeshWithRuns.h"

#include "Octree/RefinedGrid.h"

#include <algorithm>

namespace vfm
{
namespace
{

Index IdOfNode(const CartesianGrid& grid, const Index3& node)
{
  return HexIds.PointSlots * grid.NodeKey(node) + 1;
}

Index IdOfCell(const CartesianGrid& grid, const Index3& cell)
{
  return HexIds.ElementSlots * grid.CellKey(cell) + 1;
}

} // namespace

MeshWithRuns::MeshWithRuns(const Mesh& mesh, const CellRuns& runs) :
  TheMesh(mesh), Grid(mesh.Levels->Finest()), Runs(runs)
{
  this->FindNodes();
  this->FindElements();
  this->Numbers.resize(mesh.PointIds.size());
  Index number = 0;
  this->ForPoints(
    [&](Index first, Index last)
    {
      for (Index p = first; p < last; ++p)
      {
        this->Numbers[p] = number++;
      }
    },
    [&](const NodeRun& run) { number += run.Count; });
}

/// A point that the mesh does not hold has only cells of runs around it, so it is the lowest corner
/// of one of them.
void MeshWithRuns::FindNodes()
{
  const Buffer<Index>& ids = this->TheMesh.PointIds;
  const Index* next = ids.begin();
  Index number = 0;
  for (const CellRuns::Run& run : this->Runs.Runs)
  {
    const Index first = IdOfNode(this->Grid, run.First);
    const auto add = [&](Index begin, Index stop)
    {
      if (begin < stop)
      {
        Index3 node = run.First;
        node[0] += begin;
        const Index before = next - ids.begin();
        this->NodeRuns.push_back(
          { node, stop - begin, run.Material, run.Fragment, before, number + before });
        number += stop - begin;
      }
    };
    next = std::lower_bound(next, ids.end(), first);
    Index begin = 0;
    for (; next < ids.end() && *next < first + HexIds.PointSlots * run.Count; ++next)
    {
      const Index node = (*next - first) / HexIds.PointSlots;
      add(begin, node);
      begin = node + 1;
    }
    add(begin, run.Count);
  }
  this->Points = static_cast<Index>(ids.size()) + number;
}

void MeshWithRuns::FindElements()
{
  const Buffer<Index>& ids = this->TheMesh.ElementIds;
  const Index* next = ids.begin();
  for (const CellRuns::Run& run : this->Runs.Runs)
  {
    next = std::lower_bound(next, ids.end(), this->FirstId(run));
    this->ElementsBefore.push_back(next - ids.begin());
  }
  this->Elements = static_cast<Index>(ids.size()) + this->Runs.Count();
}

/// Numbers of the points at the nodes of two adjacent planes.
class MeshWithRuns::Planes
{
public:
  explicit Planes(const MeshWithRuns& mesh) : Whole(mesh)
  {
    for (int a = 0; a < 2; ++a)
    {
      this->Size[a] = static_cast<Index>(mesh.Grid.Coordinates(a).size());
    }
  }

  /// Returns the numbers of the points of row (j, k) of nodes, which is in one of the two planes
  /// that were used last. Only nodes of runs have a value.
  const Index* Row(Index j, Index k)
  {
    std::vector<Index>& plane = this->Numbers[k % 2];
    if (this->Place[k % 2] != k)
    {
      this->Place[k % 2] = k;
      this->Fill(k, plane);
    }
    return plane.data() + this->Size[0] * j;
  }

private:
  void Fill(Index k, std::vector<Index>& plane) const
  {
    plane.resize(this->Size[0] * this->Size[1]);
    const std::vector<NodeRun>& runs = this->Whole.NodeRuns;
    auto run = std::partition_point(
      runs.begin(), runs.end(), [k](const NodeRun& one) { return one.First[2] < k; });
    for (; run != runs.end() && run->First[2] == k; ++run)
    {
      Index* to = plane.data() + this->Size[0] * run->First[1] + run->First[0];
      for (Index n = 0; n < run->Count; ++n)
      {
        to[n] = run->Number + n;
      }
    }
    const Buffer<Index>& ids = this->Whole.TheMesh.PointIds;
    const Index first = IdOfNode(this->Whole.Grid, { { 0, 0, k } });
    const Index last = IdOfNode(this->Whole.Grid, { { 0, 0, k + 1 } });
    const Index* id = std::lower_bound(ids.begin(), ids.end(), first);
    for (; id < ids.end() && *id < last; ++id)
    {
      const Index place = *id - first;
      if (place % HexIds.PointSlots == 0)
      {
        plane[place / HexIds.PointSlots] = this->Whole.Numbers[id - ids.begin()];
      }
    }
  }

  const MeshWithRuns& Whole;
  std::array<Index, 2> Size, Place{ { -1, -1 } };
  std::array<std::vector<Index>, 2> Numbers;
};

void MeshWithRuns::ForCorners(
  const std::function<void(int material, const Index* corners)>& visit) const
{
  Planes planes(*this);
  std::array<Index, 8> corners;
  this->ForElements(
    [&](Index first, Index last)
    {
      for (Index e = first; e < last; ++e)
      {
        const Index* points = this->TheMesh.Elements.data() + 8 * e;
        for (int c = 0; c < 8; ++c)
        {
          corners[c] = this->Numbers[points[c]];
        }
        visit(this->TheMesh.Material[e], corners.data());
      }
    },
    [&](const CellRuns::Run& run)
    {
      const auto [i, j, k] = run.First;
      const Index *a = planes.Row(j, k) + i, *b = planes.Row(j + 1, k) + i,
                  *c = planes.Row(j, k + 1) + i, *d = planes.Row(j + 1, k + 1) + i;
      for (Index n = 0; n < run.Count; ++n)
      {
        corners = { { a[n], a[n + 1], b[n + 1], b[n], c[n], c[n + 1], d[n + 1], d[n] } };
        visit(run.Material, corners.data());
      }
    });
}

Index MeshWithRuns::FirstId(const NodeRun& run) const
{
  return IdOfNode(this->Grid, run.First);
}

Index MeshWithRuns::FirstId(const CellRuns::Run& run) const
{
  return IdOfCell(this->Grid, run.First);
}

Vector3 MeshWithRuns::PointAt(const NodeRun& run, Index place) const
{
  return this->Grid.NodePoint({ { run.First[0] + place, run.First[1], run.First[2] } });
}

double MeshWithRuns::VolumeOf(const CellRuns::Run& run) const
{
  const auto [i, j, k] = run.First;
  const std::vector<double>& x = this->Grid.Coordinates(0);
  return (x[i + run.Count] - x[i]) * this->Grid.Width(1, j) * this->Grid.Width(2, k);
}

} // namespace vfm
