#include "Report/MeshWithRuns.h"

#include "Report/MeshArrays.h"

#include <algorithm>
#include <stdexcept>

namespace vfm
{
namespace
{

constexpr std::size_t ValuesOfPart = 16384;

Index IdOfNode(const CartesianGrid& grid, const Index3& node)
{
  return HexIds.PointSlots * grid.NodeKey(node) + 1;
}

Index IdOfCell(const CartesianGrid& grid, const Index3& cell)
{
  return HexIds.ElementSlots * grid.CellKey(cell) + 1;
}

/// Collects values and passes them on in parts.
template <class T>
class Parts
{
public:
  explicit Parts(const AddBytes& add) : Pass(add) {}
  void Add(T value)
  {
    this->Values.push_back(value);
    if (this->Values.size() >= ValuesOfPart)
    {
      this->Flush();
    }
  }
  void AddAll(const T* values, Index count)
  {
    for (Index i = 0; i < count; ++i)
    {
      this->Add(values[i]);
    }
  }
  void Flush()
  {
    this->Pass(
      { reinterpret_cast<const char*>(this->Values.data()), sizeof(T) * this->Values.size() });
    this->Values.clear();
  }

private:
  const AddBytes& Pass;
  std::vector<T> Values;
};

[[noreturn]] void RejectArray(const MeshArray& array)
{
  throw std::logic_error("A mesh with runs has no values of the array " + array.Name + ".");
}

} // namespace

MeshWithRuns::MeshWithRuns(const MeshData& mesh, const CartesianGrid& grid, const CellRuns& runs) :
  Mesh(mesh), Grid(grid), Runs(runs)
{
  this->FindNodes();
  this->FindElements();
  this->Numbers.resize(mesh.NumberOfPoints);
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

/// A cell of a run has the lowest node of its own, unless the mesh holds the point: all cells at
/// the node are of runs then.
void MeshWithRuns::FindNodes()
{
  const Index *ids = this->Mesh.PointIds, *end = ids + this->Mesh.NumberOfPoints, *next = ids;
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
        const Index before = next - ids;
        this->NodeRuns.push_back(
          { node, stop - begin, run.Material, run.Fragment, before, number + before });
        number += stop - begin;
      }
    };
    next = std::lower_bound(next, end, first);
    Index begin = 0;
    for (; next < end && *next < first + HexIds.PointSlots * run.Count; ++next)
    {
      const Index node = (*next - first) / HexIds.PointSlots;
      add(begin, node);
      begin = node + 1;
    }
    add(begin, run.Count);
  }
  this->Points = this->Mesh.NumberOfPoints + number;
}

void MeshWithRuns::FindElements()
{
  const Index *ids = this->Mesh.ElementIds, *end = ids + this->Mesh.NumberOfElements, *next = ids;
  for (const CellRuns::Run& run : this->Runs.Runs)
  {
    next = std::lower_bound(next, end, IdOfCell(this->Grid, run.First));
    this->ElementsBefore.push_back(next - ids);
  }
  this->Elements = this->Mesh.NumberOfElements + this->Runs.Count();
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
    const MeshData& mesh = this->Whole.Mesh;
    const Index first = IdOfNode(this->Whole.Grid, { { 0, 0, k } });
    const Index last = IdOfNode(this->Whole.Grid, { { 0, 0, k + 1 } });
    const Index* id = std::lower_bound(mesh.PointIds, mesh.PointIds + mesh.NumberOfPoints, first);
    for (; id < mesh.PointIds + mesh.NumberOfPoints && *id < last; ++id)
    {
      const Index place = *id - first;
      if (place % HexIds.PointSlots == 0)
      {
        plane[place / HexIds.PointSlots] = this->Whole.Numbers[id - mesh.PointIds];
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
        const Index* points = this->Mesh.Element(e);
        for (int c = 0; c < 8; ++c)
        {
          corners[c] = this->Numbers[points[c]];
        }
        visit(this->Mesh.Material[e], corners.data());
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

void MeshWithRuns::AddPoints(const AddBytes& add) const
{
  Parts<double> parts(add);
  this->ForPoints([&](Index first, Index last)
    { parts.AddAll(this->Mesh.Points + 3 * first, 3 * (last - first)); },
    [&](const NodeRun& run)
    {
      for (Index n = 0; n < run.Count; ++n)
      {
        const Vector3 x =
          this->Grid.NodePoint({ { run.First[0] + n, run.First[1], run.First[2] } });
        parts.AddAll(x.data(), 3);
      }
    });
  parts.Flush();
}

void MeshWithRuns::AddCorners(const AddBytes& add) const
{
  Parts<Index> parts(add);
  this->ForCorners([&](int, const Index* corners) { parts.AddAll(corners, 8); });
  parts.Flush();
}

void MeshWithRuns::AddPointValues(const MeshArray& array, const AddBytes& add) const
{
  const auto pass = [&](auto tag, const auto& valueAt)
  {
    using Value = decltype(tag);
    const auto* values = static_cast<const Value*>(array.Values);
    Parts<Value> parts(add);
    this->ForPoints([&](Index first, Index last) { parts.AddAll(values + first, last - first); },
      [&](const NodeRun& run)
      {
        for (Index n = 0; n < run.Count; ++n)
        {
          parts.Add(valueAt(run, n));
        }
      });
    parts.Flush();
  };
  if (array.Name == "GlobalPointIds")
  {
    pass(Index(),
      [this](const NodeRun& run, Index n)
      { return IdOfNode(this->Grid, run.First) + HexIds.PointSlots * n; });
  }
  else if (array.Name == "GeometryDimension")
  {
    pass(int(), [](const NodeRun&, Index) { return 3; });
  }
  else if (array.Name == "GeometryId")
  {
    pass(int(), [](const NodeRun& run, Index) { return run.Fragment; });
  }
  else
  {
    RejectArray(array);
  }
}

void MeshWithRuns::AddElementValues(const MeshArray& array, const AddBytes& add) const
{
  const auto pass = [&](auto tag, const auto& valueAt)
  {
    using Value = decltype(tag);
    const auto* values = static_cast<const Value*>(array.Values);
    Parts<Value> parts(add);
    this->ForElements([&](Index first, Index last) { parts.AddAll(values + first, last - first); },
      [&](const CellRuns::Run& run)
      {
        for (Index n = 0; n < run.Count; ++n)
        {
          parts.Add(valueAt(run, n));
        }
      });
    parts.Flush();
  };
  using Run = CellRuns::Run;
  if (array.Name == "MaterialId")
  {
    pass(int(), [](const Run& run, Index) { return run.Material; });
  }
  else if (array.Name == "FragmentId")
  {
    pass(int(), [](const Run& run, Index) { return run.Fragment; });
  }
  else if (array.Name == "GlobalCellIds")
  {
    pass(Index(),
      [this](const Run& run, Index n)
      { return IdOfCell(this->Grid, run.First) + HexIds.ElementSlots * n; });
  }
  else if (array.Name == "ScaledJacobian")
  {
    pass(float(), [](const Run&, Index) { return 1.0f; });
  }
  else
  {
    RejectArray(array);
  }
}

double MeshWithRuns::VolumeOf(const CellRuns::Run& run) const
{
  const auto [i, j, k] = run.First;
  const std::vector<double>& x = this->Grid.Coordinates(0);
  return (x[i + run.Count] - x[i]) * this->Grid.Width(1, j) * this->Grid.Width(2, k);
}

} // namespace vfm
