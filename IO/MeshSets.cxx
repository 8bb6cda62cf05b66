#include "MeshSets.h"

#include "Agreement.h"
#include "Base/Runtime.h"
#include "MaterialIds.h"
#include "MaterialNames.h"
#include "MeshFaces.h"

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

using Pair = std::array<int, 2>; // of materials that touch; the faces are the first's

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

/// Collective: the side sets of the sides of the domain, then those of pairs.
std::vector<SideSet> MakeSideSets(vtkUnstructuredGrid* mesh, const Domain& domain, Ranks& ranks)
{
  std::map<int, std::vector<MeshSide>> ofSides;
  std::map<Pair, std::vector<MeshSide>> ofPairs;
  vtkDataArray* materials = mesh->GetCellData()->GetArray("MaterialId");
  for (const MeshFace& face : FindMeshFaces(mesh, "MaterialId", ranks))
  {
    const int side = face.Behind == NothingBehind ? domain.SideOfFace(face) : NoSide;
    const Pair pair{ { static_cast<int>(materials->GetComponent(face.Cell, 0)),
      std::max(face.Behind, 0) } };
    (side == NoSide ? ofPairs[pair] : ofSides[side]).push_back({ face.Cell, face.Face });
  }
  const auto keys = [](const auto& map)
  {
    std::vector<std::decay_t<decltype(map.begin()->first)>> list;
    for (const auto& entry : map)
    {
      list.push_back(entry.first);
    }
    return list;
  };
  std::vector<SideSet> sets;
  for (int side : Unite(ranks, keys(ofSides)))
  {
    sets.push_back({ side + 1, SideNames[side], std::move(ofSides[side]) });
  }
  const MaterialNames names(mesh);
  const std::vector<Pair> pairs = Unite(ranks, keys(ofPairs));
  const bool hasVoid = !pairs.empty() && pairs.front()[0] == 0;
  const std::vector<int> ids = NumberPairs(pairs, hasVoid ? FindVoidId(mesh, ranks) : 0);
  for (std::size_t p = 0; p < pairs.size(); ++p)
  {
    sets.push_back({ ids[p], names.Name(pairs[p][0]) + "_to_" + names.Name(pairs[p][1]),
      std::move(ofPairs[pairs[p]]) });
  }
  return sets;
}

/// Collective.
std::vector<NodeSet> MakeNodeSets(vtkUnstructuredGrid* mesh, const Domain& domain, Ranks& ranks)
{
  std::vector<NodeSet> sets;
  for (int side = 0; side < 6; ++side)
  {
    NodeSet set{ side + 1, SideNames[side], {} };
    for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
    {
      if (domain.IsOnSide(point, side))
      {
        set.Points.push_back(point);
      }
    }
    if (ranks.Any(!set.Points.empty()))
    {
      sets.push_back(std::move(set));
    }
  }
  return sets;
}

} // namespace

MeshSets FindMeshSets(vtkUnstructuredGrid* mesh, Ranks& ranks)
{
  const Domain domain(mesh);
  std::vector<SideSet> sides = MakeSideSets(mesh, domain, ranks);
  return { std::move(sides), MakeNodeSets(mesh, domain, ranks) };
}

} // namespace vfm
