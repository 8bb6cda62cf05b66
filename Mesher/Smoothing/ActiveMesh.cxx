#include "Smoothing/ActiveMesh.h"

#include "Base/Groups.h"
#include "Base/Vector3.h"
#include "Octree/LevelIds.h"

#include <limits>

namespace vfm
{
namespace
{

constexpr double SideClearance = 0.01; // distance kept by points that are not on a side, in cells
// Largest distance of points near narrow void from their start, in cells. It is smaller where cells
// are not cubes, because points slide farther there.
constexpr double ReachInCubes = 1.0, ReachInBoxes = 0.75;
constexpr double NoLimit = 1e300; // of a distance

/// Returns the widths of a cell in grid coordinates.
Vector3 CellWidths(const CartesianGrid& grid, const Index3& cell)
{
  return (1.0 / grid.MeanWidth()) *
    Vector3{ { grid.Width(0, cell[0]), grid.Width(1, cell[1]), grid.Width(2, cell[2]) } };
}

} // namespace

std::vector<Vector3> WidthsOfCells(
  const CartesianGrid& grid, const Mesh& mesh, const std::vector<Index>& elements)
{
  if (IsUniform(grid))
  {
    return { CellWidths(grid, grid.Global().Lower) };
  }
  std::vector<Vector3> widths;
  widths.reserve(elements.size());
  for (Index element : elements)
  {
    widths.push_back(CellWidths(grid, CellOfElement(grid, mesh, mesh.ElementIds[element])));
  }
  return widths;
}

std::vector<Vector3> WidthsOfLeaves(
  const RefinedGrid& levels, const Mesh& mesh, const std::vector<Index>& elements)
{
  const CartesianGrid& grid = levels.Finest();
  const Index slots = mesh.Ids.ElementSlots;
  const bool areHexes = AreHexes(mesh.Corners);
  std::vector<Vector3> widths;
  widths.reserve(elements.size());
  for (Index element : elements)
  {
    const Index id = mesh.ElementIds[element];
    if (areHexes ? IsCoarseElement(levels, id, slots) : IsCoarseTet(levels, id, slots))
    {
      const OctreeKeys::LevelIndex cell =
        areHexes ? CellOfCoarseElement(levels, id, slots) : CellOfCoarseTet(levels, id, slots);
      widths.push_back((1.0 / grid.MeanWidth()) * levels.Lattice().CellWidths(cell.Level, cell.At));
    }
    else
    {
      widths.push_back(CellWidths(grid, CellOfElement(grid, mesh, id)));
    }
  }
  return widths;
}

unsigned char FixedOnSides(int sides)
{
  return static_cast<unsigned char>(
    ((sides & 3) != 0) | ((sides >> 2 & 3) != 0) << 1 | ((sides >> 4 & 3) != 0) << 2);
}

void ActiveMesh::SetBarrier(
  const Mesh& mesh, const BarrierElements& barrier, const std::vector<Index>& elements)
{
  std::vector<unsigned char> isNear(this->X.size(), 0);
  const auto forPoints = [this](std::size_t element, const auto& visit)
  {
    const auto points = this->Elements.begin() + this->Corners * element;
    std::for_each(points, points + this->Corners, visit);
  };
  for (std::size_t e = 0; barrier.Exist && e < elements.size(); ++e)
  {
    if (barrier.Contain(mesh, elements[e]))
    {
      this->Demands.resize(elements.size(), 1.0f);
      this->Demands[e] = BarrierDemand;
      forPoints(e, [&](int point) { isNear[point] = 1; });
    }
  }
  // Only the owner of a point knows all elements at it.
  this->Exchange.SendAll([&](int mover) { return isNear[mover]; },
    [&](int mover, unsigned char flag) { isNear[mover] = flag; });
  if (std::find(isNear.begin(), isNear.end(), 1) == isNear.end())
  {
    return;
  }
  this->StaysNear = isNear;
  for (std::size_t e = 0; e < elements.size(); ++e)
  {
    bool touches = false;
    forPoints(e, [&](int point) { touches = touches || (this->IsActive[point] && isNear[point]); });
    forPoints(e, [&](int point) { this->StaysNear[point] |= touches; });
  }
}

void ActiveMesh::SetYielding(
  const Mesh& mesh, const std::vector<unsigned char>& isThin, const std::vector<Index>& elements)
{
  if (isThin.empty())
  {
    return;
  }
  this->YieldingFragments.reserve(elements.size());
  for (Index element : elements)
  {
    const int fragment = mesh.Fragment[element];
    this->YieldingFragments.push_back(isThin[fragment] ? fragment : 0);
  }
}

void ActiveMesh::LowerDemandsOf(const std::vector<unsigned char>& elements, float demand)
{
  this->Demands.resize(elements.size(), 1.0f);
  for (std::size_t e = 0; e < elements.size(); ++e)
  {
    this->Demands[e] = elements[e] ? std::min(this->Demands[e], demand) : this->Demands[e];
  }
  if (this->HasHexes())
  {
    this->Rings.UpdateDemands(*this);
  }
}

void ActiveMesh::LowerDemands(const std::vector<unsigned char>& fragments, float demand)
{
  std::vector<unsigned char> elements(this->YieldingFragments.size());
  std::transform(this->YieldingFragments.begin(), this->YieldingFragments.end(), elements.begin(),
    [&](int fragment) { return fragment > 0 && fragments[fragment]; });
  this->LowerDemandsOf(elements, demand);
}

void ActiveMesh::BoundBySeams(const CartesianGrid& grid, const Mesh& mesh)
{
  if (grid.FlatSeams(grid.Domain().Lower) == 0)
  {
    return;
  }
  this->OwnBounds.assign(this->MeshPoint.size(), this->Bounds);
  const double scale = 1.0 / grid.MeanWidth();
  for (std::size_t p = 0; p < this->MeshPoint.size(); ++p)
  {
    const Index3 cell = grid.CellAt(mesh.PointAt(this->MeshPoint[p]));
    const Index3 own = grid.Canonical(cell);
    for (int a = 0; a < 3; ++a)
    {
      const std::vector<double>& x = grid.Coordinates(a);
      const Index lower = cell[a] - (own[a] - grid.Domain().Lower[a]);
      const Index upper = lower + grid.Period(a);
      if (grid.Period(a) > 0 && lower >= 0)
      {
        const double clearance = SideClearance * grid.Width(a, lower);
        this->OwnBounds[p].Lower[a] = scale * (x[lower] - x[0] + clearance);
      }
      if (grid.Period(a) > 0 && upper < static_cast<Index>(x.size()))
      {
        const double clearance = SideClearance * grid.Width(a, upper - 1);
        this->OwnBounds[p].Upper[a] = scale * (x[upper] - x[0] - clearance);
      }
    }
  }
}

void ActiveMesh::PlacePoints(const CartesianGrid& grid, const Mesh& mesh)
{
  this->MeshPoints = mesh.Points.data();
  this->Origin = { { grid.Coordinates(0)[0], grid.Coordinates(1)[0], grid.Coordinates(2)[0] } };
  this->Scale = grid.MeanWidth();
  for (std::size_t p = 0; p < this->MeshPoint.size(); ++p)
  {
    this->X[p] = this->StartOf(static_cast<int>(p));
    this->Fixed[p] = FixedOnSides(FindDomainSides(grid, this->InMeshPoints(static_cast<int>(p)))) |
      grid.FlatSeams(mesh.PointAt(this->MeshPoint[p]));
  }
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = grid.Coordinates(a);
    const Index last = grid.Global().Upper[a] - 1;
    const double scale = 1.0 / grid.MeanWidth();
    this->Bounds.Lower[a] = scale * SideClearance * grid.Width(a, 0);
    this->Bounds.Upper[a] = scale * (x.back() - x.front() - SideClearance * grid.Width(a, last));
  }
  this->BoundBySeams(grid, mesh);
}

void ActiveMesh::CodeStarts()
{
  this->Starts = CodedPoints(this->MeshPoints, this->MeshPoint);
  this->Starts.Convert([this](int a, double x) { return (x - this->Origin[a]) / this->Scale; });
}

/// Returns the largest distance of a point near narrow void from its start, along each axis.
Vector3 ActiveMesh::ReachOf(int point) const
{
  if (this->HasCubes())
  {
    return ReachInCubes * this->Widths[0];
  }
  Vector3 reach{ { NoLimit, NoLimit, NoLimit } };
  const std::vector<CornerPosition>& corners = this->CornerOffset;
  for (CornerPosition at = corners[point]; at < corners[point + 1]; ++at)
  {
    const Vector3& widths = this->WidthsAt(this->CornerList[at]);
    for (int a = 0; a < 3; ++a)
    {
      reach[a] = std::min(reach[a], ReachInBoxes * widths[a]);
    }
  }
  return reach;
}

MoveBounds ActiveMesh::RangeOf(int point) const
{
  MoveBounds range = this->BoundsOf(point);
  const bool staysNear = !this->StaysNear.empty() && this->StaysNear[point];
  const Vector3 start = this->StartOf(point), reach = this->ReachOf(point);
  for (int a = 0; a < 3; ++a)
  {
    if (this->Fixed[point] >> a & 1)
    {
      range.Lower[a] = range.Upper[a] = this->X[point][a];
    }
    else if (staysNear)
    {
      range.Lower[a] = std::max(range.Lower[a], start[a] - reach[a]);
      range.Upper[a] = std::min(range.Upper[a], start[a] + reach[a]);
    }
  }
  return range;
}

bool ActiveMesh::IsNearStart(int point, const Vector3& x) const
{
  if (this->StaysNear.empty() || !this->StaysNear[point])
  {
    return true;
  }
  const Vector3 start = this->StartOf(point), reach = this->ReachOf(point);
  bool isNear = true;
  for (int a = 0; a < 3; ++a)
  {
    isNear &= std::abs(x[a] - start[a]) <= reach[a];
  }
  return isNear;
}

void ActiveMesh::ListCorners()
{
  if (this->Elements.size() > std::numeric_limits<CornerPosition>::max())
  {
    throw InputError("More elements at interfaces than one rank can smooth: use more ranks.");
  }
  auto corners = MakeGroups<CornerPosition, CornerPosition>(this->X.size(),
    [this](const auto& visit)
    {
      for (std::size_t position = 0; position < this->Elements.size(); ++position)
      {
        const int p = this->Elements[position];
        if (this->IsActive[p])
        {
          visit(p, static_cast<CornerPosition>(position));
        }
      }
    });
  this->CornerOffset = std::move(corners.Begin);
  this->CornerList = std::move(corners.Items);
  if (this->Corners == 4)
  {
    this->Stars.Build(this->Elements, this->CornerOffset, this->CornerList);
  }
}

void ActiveMesh::CopyTo(Mesh& mesh, const CartesianGrid& grid) const
{
  const double scale = grid.MeanWidth();
  for (std::size_t p = 0; p < this->X.size(); ++p)
  {
    const Vector3 start = this->StartOf(static_cast<int>(p));
    for (int a = 0; a < 3; ++a)
    {
      if (this->IsActive[p] && this->X[p][a] != start[a])
      {
        mesh.Points[3 * static_cast<Index>(this->MeshPoint[p]) + a] =
          grid.Coordinates(a)[0] + scale * this->X[p][a];
      }
    }
  }
}

} // namespace vfm
