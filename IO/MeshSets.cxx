#include "MeshSets.h"

#include "Base/Runtime.h"
#include "FaceSurfaces.h"
#include "MaterialIds.h"
#include "MaterialNames.h"
#include "MeshFaces.h"
#include "Ranks/Agreement.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMatrix3x3.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace vfm
{
namespace
{

constexpr const char* SideNames[6] = { "x_min", "x_max", "y_min", "y_max", "z_min", "z_max" };
constexpr int NoSide = -1;
constexpr double SideTolerance = 1e-9; // of the domain's length; the mesh has the very coordinate

using Pair = std::array<int, 2>;     // of materials that touch; the faces are the first's
using PairSide = std::array<int, 3>; // and a surface between them

/// The sides of the domain and what lies on them.
class Domain
{
public:
  explicit Domain(vtkUnstructuredGrid* mesh) :
    Points(mesh->GetPoints()), Bounds(mesh->GetFieldData()->GetArray("DomainBounds"))
  {
    vtkDataArray* frame = mesh->GetFieldData()->GetArray("DomainFrame");
    this->IsTurned = frame && frame->GetNumberOfTuples() == 12;
    for (int i = 0; this->IsTurned && i < 9; ++i)
    {
      this->ToOwn[i] = frame->GetComponent(i, 0);
      this->Origin[i % 3] = frame->GetComponent(9 + i % 3, 0);
    }
    vtkMatrix3x3::Invert(this->ToOwn, this->ToOwn);
  }

  bool IsOnSide(vtkIdType point, int side) const
  {
    if (!this->Bounds)
    {
      return false;
    }
    const int axis = side / 2;
    const double length = this->Bound(2 * axis + 1) - this->Bound(2 * axis);
    return std::abs(this->Coordinate(point, axis) - this->Bound(side)) <= SideTolerance * length;
  }

  /// The side on which a whole face lies, or NoSide.
  int SideOfFace(const MeshFace& face) const
  {
    for (int side = 0; side < 6; ++side)
    {
      if (std::all_of(face.Points, face.Points + face.Corners,
            [&](vtkIdType point) { return this->IsOnSide(point, side); }))
      {
        return side;
      }
    }
    return NoSide;
  }

private:
  double Bound(int side) const { return this->Bounds->GetComponent(side, 0); }

  /// Of turned images along their own axis.
  double Coordinate(vtkIdType point, int axis) const
  {
    const double* x = this->Points->GetPoint(point);
    if (!this->IsTurned)
    {
      return x[axis];
    }
    const double* row = this->ToOwn + 3 * axis;
    return this->Origin[axis] + row[0] * (x[0] - this->Origin[0]) +
      row[1] * (x[1] - this->Origin[1]) + row[2] * (x[2] - this->Origin[2]);
  }

  vtkPoints* Points;
  vtkDataArray* Bounds;
  bool IsTurned = false;
  double ToOwn[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 }, Origin[3] = { 0, 0, 0 };
};

/// Ids of pairs of materials, in the order of the pairs. voidId: the number of material 0 when it is the first.
std::vector<int> NumberPairs(const std::vector<Pair>& pairs, int voidId)
{
  const auto first = [voidId](const Pair& pair) { return pair[0] == 0 ? voidId : pair[0]; };
  Index factor = 1000, largest = 0;
  for (const Pair& pair : pairs)
  {
    largest = std::max<Index>(largest, first(pair));
    while (factor <= std::max(first(pair), pair[1]))
    {
      factor *= 10;
    }
  }
  std::vector<int> ids;
  const bool fits = largest < std::numeric_limits<int>::max() / factor;
  for (const Pair& pair : pairs)
  {
    ids.push_back(
      fits ? static_cast<int>(first(pair) * factor) + pair[1] : 7 + static_cast<int>(ids.size()));
  }
  return ids;
}

/// Ids of smooth sides, in their order. pairIds: of their pairs; greatest: of all pairs.
std::vector<int> NumberSides(
  const std::vector<PairSide>& sides, const std::vector<int>& pairIds, int greatest)
{
  Index factor = 1000;
  for (const PairSide& side : sides)
  {
    while (factor <= side[2])
    {
      factor *= 10;
    }
  }
  const bool fits = greatest < std::numeric_limits<int>::max() / factor;
  std::vector<int> ids;
  for (std::size_t s = 0; s < sides.size(); ++s)
  {
    ids.push_back(fits ? static_cast<int>(pairIds[s] * factor) + sides[s][2]
                       : greatest + 1 + static_cast<int>(s));
  }
  return ids;
}

/// The keys of all ranks. Collective.
template <class Map>
auto UniteKeys(Ranks& ranks, const Map& map)
{
  std::vector<std::decay_t<decltype(map.begin()->first)>> list;
  for (const auto& entry : map)
  {
    list.push_back(entry.first);
  }
  return Unite(ranks, std::move(list));
}

/// Collective: the side sets of the sides of the domain, of pairs, and of the smooth sides of these.
std::vector<SideSet> MakeSideSets(
  vtkUnstructuredGrid* mesh, const Domain& domain, FaceSurfaces& surfaces, Ranks& ranks)
{
  std::map<int, std::vector<MeshSide>> ofDomain;
  std::map<Pair, std::vector<MeshSide>> ofPairs;
  std::map<PairSide, std::vector<MeshSide>> ofSides;
  vtkDataArray* materials = mesh->GetCellData()->GetArray("MaterialId");
  for (const MeshFace& face : FindMeshFaces(mesh, "MaterialId", ranks))
  {
    const int side = face.Behind == NothingBehind ? domain.SideOfFace(face) : NoSide;
    const Pair pair{ { static_cast<int>(materials->GetComponent(face.Cell, 0)),
      std::max(face.Behind, 0) } };
    const MeshSide here{ face.Cell, face.Face };
    (side == NoSide ? ofPairs[pair] : ofDomain[side]).push_back(here);
    const int surface = side == NoSide ? surfaces.Find(face) : 0;
    if (surface > 0)
    {
      ofSides[{ { pair[0], pair[1], surface } }].push_back(here);
    }
  }
  std::vector<SideSet> sets;
  for (int side : UniteKeys(ranks, ofDomain))
  {
    sets.push_back({ side + 1, SideNames[side], 0, std::move(ofDomain[side]) });
  }
  const MaterialNames names(mesh);
  const auto nameOf = [&names](int first, int second)
  { return names.Name(first) + "_to_" + names.Name(second); };
  const std::vector<Pair> pairs = UniteKeys(ranks, ofPairs);
  const bool hasVoid = !pairs.empty() && pairs.front()[0] == 0;
  const std::vector<int> ids = NumberPairs(pairs, hasVoid ? FindVoidId(mesh, ranks) : 0);
  for (std::size_t p = 0; p < pairs.size(); ++p)
  {
    sets.push_back({ ids[p], nameOf(pairs[p][0], pairs[p][1]), 0, std::move(ofPairs[pairs[p]]) });
  }
  const std::vector<PairSide> sides = UniteKeys(ranks, ofSides);
  std::vector<int> pairIds;
  for (const PairSide& side : sides)
  {
    const Pair pair{ { side[0], side[1] } };
    pairIds.push_back(ids[std::lower_bound(pairs.begin(), pairs.end(), pair) - pairs.begin()]);
  }
  const int greatest = ids.empty() ? 0 : *std::max_element(ids.begin(), ids.end());
  const std::vector<int> sideIds = NumberSides(sides, pairIds, greatest);
  for (std::size_t s = 0; s < sides.size(); ++s)
  {
    sets.push_back(
      { sideIds[s], nameOf(sides[s][0], sides[s][1]) + "_" + std::to_string(sides[s][2]),
        sides[s][2], std::move(ofSides[sides[s]]) });
  }
  return sets;
}

/// Collective: those of the sides of the domain, and of smooth sides.
std::vector<NodeSet> MakeNodeSets(vtkUnstructuredGrid* mesh, const Domain& domain,
  const std::vector<SideSet>& sideSets, FaceSurfaces& surfaces, Ranks& ranks)
{
  std::vector<NodeSet> sets;
  const auto add = [&](int id, const std::string& name, const auto& contains)
  {
    NodeSet set{ id, name, {} };
    for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
    {
      if (contains(point))
      {
        set.Points.push_back(point);
      }
    }
    if (ranks.Any(!set.Points.empty()))
    {
      sets.push_back(std::move(set));
    }
  };
  for (int side = 0; side < 6; ++side)
  {
    add(side + 1, SideNames[side], [&](vtkIdType point) { return domain.IsOnSide(point, side); });
  }
  surfaces.ShareRims(ranks);
  for (const SideSet& sides : sideSets)
  {
    if (sides.Surface > 0)
    {
      add(sides.Id, sides.Name,
        [&](vtkIdType point) { return surfaces.Contains(sides.Surface, point); });
    }
  }
  return sets;
}

} // namespace

MeshSets FindMeshSets(vtkUnstructuredGrid* mesh, Ranks& ranks)
{
  const Domain domain(mesh);
  FaceSurfaces surfaces(mesh);
  std::vector<SideSet> sides = MakeSideSets(mesh, domain, surfaces, ranks);
  std::vector<NodeSet> nodes = MakeNodeSets(mesh, domain, sides, surfaces, ranks);
  return { std::move(sides), std::move(nodes) };
}

} // namespace vfm
