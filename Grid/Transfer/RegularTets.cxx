#include "Transfer/RegularTets.h"

#include "Base/Vector3.h"

#include <algorithm>
#include <cmath>

namespace vfm
{
namespace
{

using Place = std::int64_t;

constexpr int Bits = 21; // bits of a field
constexpr std::array<Place, 3> Steps{ { 1, Place(1) << Bits, Place(1) << 2 * Bits } };
constexpr Place Ones = Steps[0] + Steps[1] + Steps[2];
constexpr Place Mask = Steps[1] - 1;

bool IsCentre(Place place)
{
  return place & 1;
}

/// Returns whether a node is a corner of the cell of a centre.
bool IsCorner(Place node, Place centre)
{
  return ((node - centre + Ones) & ~(2 * Ones)) == 0;
}

/// Returns twice the coordinate of a point along an axis, in cells of the local box; -1 if it is
/// neither a node nor the middle of a cell. The search begins at cell i and sets i to the cell.
Place FindPlace(const std::vector<double>& x, Index first, Index last, double value, Index& i)
{
  i = std::min(std::max(i, first), last - 1);
  if (!(x[i] <= value && value < x[i + 1]))
  {
    i = std::upper_bound(x.begin() + first, x.begin() + last, value) - x.begin() - 1;
    i = std::max(i, first);
  }
  return value == x[i]                   ? 2 * (i - first)
    : value == 0.5 * (x[i] + x[i + 1])   ? 2 * (i - first) + 1
    : value == x[i + 1] && i + 1 == last ? 2 * (last - first)
                                         : -1;
}

} // namespace

RegularTets::RegularTets(const Mesh& mesh, const CartesianGrid& grid, Runtime& runtime) :
  TheMesh(mesh), Grid(grid)
{
  const IndexBox& box = grid.Local();
  if (mesh.Corners != 4 || std::max(std::max(box.Size(0), box.Size(1)), box.Size(2)) >= Mask / 2)
  {
    return;
  }
  this->Places.resize(mesh.Points.size() / 3);
  runtime.For(0, static_cast<Index>(this->Places.size()),
    [&](Index begin, Index end)
    {
      Index3 cell{};
      for (Index p = begin; p < end; ++p)
      {
        Place sum = 0;
        int odd = 0;
        for (int a = 0; a < 3; ++a)
        {
          const Place place = FindPlace(
            grid.Coordinates(a), box.Lower[a], box.Upper[a], mesh.Points[3 * p + a], cell[a]);
          odd = place < 0 ? 4 : odd + static_cast<int>(place & 1);
          sum += std::max<Place>(place, 0) * Steps[a];
        }
        this->Places[p] = odd == 0 || odd == 3 ? sum : -1;
      }
    });
}

Index RegularTets::CellOf(Place centre) const
{
  const IndexBox& box = this->Grid.Local();
  const Place x = centre >> 1 & (Mask >> 1), y = centre >> (Bits + 1) & (Mask >> 1),
              z = centre >> (2 * Bits + 1);
  return (z * box.Size(1) + y) * box.Size(0) + x;
}

int RegularTets::CutTet(Index element, std::array<OverlapPart, 2>& parts) const
{
  const Index* points = this->TheMesh.Elements.data() + 4 * element;
  // Corners: centres from the first, nodes from the last.
  std::array<int, 4> order{};
  int centres = 0, nodes = 4;
  for (int c = 0; c < 4; ++c)
  {
    const Place place = this->Places[points[c]];
    if (place < 0)
    {
      return 0;
    }
    order[IsCentre(place) ? centres++ : --nodes] = c;
  }
  return centres == 2 ? this->CutInTwo(points, order, parts)
    : centres == 1    ? this->CutInCell(points, order[0], parts)
                      : 0;
}

int RegularTets::CutInCell(const Index* points, int centre, std::array<OverlapPart, 2>& parts) const
{
  const Place place = this->Places[points[centre]];
  std::array<Vector3, 4> x;
  for (int c = 0; c < 4; ++c)
  {
    if (c != centre && !IsCorner(this->Places[points[c]], place))
    {
      return 0;
    }
    x[c] = this->TheMesh.PointAt(points[c]);
  }
  const double volume = Dot(x[1] - x[0], Cross(x[2] - x[0], x[3] - x[0])) / 6.0;
  parts[0] = { this->CellOf(place), volume, 0.25 * ((x[0] + x[1]) + (x[2] + x[3])) };
  return volume > 0.0 ? 1 : 0;
}

int RegularTets::CutInTwo(
  const Index* points, std::array<int, 4> order, std::array<OverlapPart, 2>& parts) const
{
  Index low = points[order[0]], high = points[order[1]];
  if (this->Places[high] < this->Places[low])
  {
    std::swap(low, high);
  }
  const Index first = points[order[2]], second = points[order[3]];
  const Place lower = this->Places[low], upper = this->Places[high], a = this->Places[first],
              b = this->Places[second];
  const Place along = (upper - lower) / 2, edge = (a > b ? a - b : b - a) / 2;
  const int axis = along == Steps[0] ? 0 : along == Steps[1] ? 1 : 2;
  const bool isEdge = edge == Steps[0] || edge == Steps[1] || edge == Steps[2];
  if (along != Steps[axis] || !isEdge || edge == along || !IsCorner(a, lower) ||
    !IsCorner(a, upper) || !IsCorner(b, lower))
  {
    return 0;
  }
  const Vector3 p = this->TheMesh.PointAt(first), q = this->TheMesh.PointAt(second);
  parts[0] = this->HalfOf(lower, this->TheMesh.PointAt(low), p, q, axis);
  parts[1] = this->HalfOf(upper, this->TheMesh.PointAt(high), p, q, axis);
  return 2;
}

/// Returns the half of a tet in the cell of one of its centres. Its corners are the centre, the
/// ends a and b of an edge, and the projection of the centre onto the face of the edge. Its volume
/// is a 24th of the cell, and the cell is 8 times the box between the centre and a.
/// @param axis  axis normal to the face
OverlapPart RegularTets::HalfOf(
  Place place, const Vector3& centre, const Vector3& a, const Vector3& b, int axis) const
{
  Vector3 foot = centre;
  foot[axis] = a[axis];
  const Vector3 size = a - centre;
  return { this->CellOf(place), std::fabs(size[0] * size[1] * size[2]) / 3.0,
    0.25 * ((centre + foot) + (a + b)) };
}

} // namespace vfm
