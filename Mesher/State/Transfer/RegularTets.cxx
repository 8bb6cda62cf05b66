#include "State/Transfer/RegularTets.h"

#include <algorithm>

namespace vfm
{
namespace
{

using Place = std::int64_t;

constexpr int Bits = 21; // bits of a field
constexpr std::array<Place, 3> Steps{ { 1, Place(1) << Bits, Place(1) << 2 * Bits } };
constexpr Place Ones = Steps[0] + Steps[1] + Steps[2];
constexpr Place Mask = Steps[1] - 1;

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

/// Returns the corner of the cell of a centre at which a node is: bit a is set if it is on the
/// upper side of axis a.
int CornerAt(Place node, Place centre)
{
  const Place sides = node - centre + Ones;
  return static_cast<int>((sides >> 1 & 1) | (sides >> Bits & 2) | (sides >> (2 * Bits - 1) & 4));
}

/// Returns the axis along which two places are two apart, or -1.
int AxisOf(Place distance)
{
  return distance == 2 * Steps[0] ? 0
    : distance == 2 * Steps[1]    ? 1
    : distance == 2 * Steps[2]    ? 2
                                  : -1;
}

/// Positions of the centres among the corners, then of the nodes, per set of centres (bits).
constexpr std::array<std::array<std::uint8_t, 4>, 16> ListOrders()
{
  std::array<std::array<std::uint8_t, 4>, 16> orders{};
  for (int set = 0; set < 16; ++set)
  {
    int place = 0;
    for (int isNode = 0; isNode < 2; ++isNode)
    {
      for (int c = 0; c < 4; ++c)
      {
        if ((set >> c & 1) != isNode)
        {
          orders[set][place++] = static_cast<std::uint8_t>(c);
        }
      }
    }
  }
  return orders;
}
constexpr std::array<std::array<std::uint8_t, 4>, 16> Orders = ListOrders();

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
  const Place x = centre >> 1 & (Mask >> 1), y = centre >> (Bits + 1) & (Mask >> 1),
              z = centre >> (2 * Bits + 1);
  return this->Grid.Linear(this->Grid.Local().Lower) + x + y * this->Grid.Stride(1) +
    z * this->Grid.Stride(2);
}

int RegularTets::FindInTet(Index element, std::array<RegularPart, 2>& parts) const
{
  const Index* points = this->TheMesh.Elements.data() + 4 * element;
  const Place places[4] = { this->Places[points[0]], this->Places[points[1]],
    this->Places[points[2]], this->Places[points[3]] };
  if ((places[0] | places[1] | places[2] | places[3]) < 0)
  {
    return 0;
  }
  const int centres = static_cast<int>(
    (places[0] & 1) | (places[1] & 1) << 1 | (places[2] & 1) << 2 | (places[3] & 1) << 3);
  const std::array<std::uint8_t, 4>& order = Orders[centres];
  const int count = (centres & 1) + (centres >> 1 & 1) + (centres >> 2 & 1) + (centres >> 3);
  const auto at = [&](int i) { return places[order[i]]; };
  return count == 2 ? this->FindInTwo(at(0), at(1), at(2), at(3), parts)
    : count == 1    ? this->FindInCell(at(0), { { at(1), at(2), at(3) } }, parts)
                    : 0;
}

int RegularTets::FindInCell(
  Place centre, const std::array<Place, 3>& nodes, std::array<RegularPart, 2>& parts) const
{
  std::array<int, 3> corners{};
  for (int i = 0; i < 3; ++i)
  {
    if (!IsCorner(nodes[i], centre))
    {
      return 0;
    }
    corners[i] = CornerAt(nodes[i], centre);
  }
  // The axes along which all three corners are on the same side; one if they are on a face.
  const int equal = 7 & ~((corners[0] ^ corners[1]) | (corners[0] ^ corners[2]));
  if (equal != 1 && equal != 2 && equal != 4)
  {
    return 0;
  }
  const int missing = corners[0] ^ corners[1] ^ corners[2];
  parts[0] = { this->CellOf(centre), KindInCell(equal / 2, missing) };
  return 1;
}

int RegularTets::FindInTwo(
  Place one, Place two, Place a, Place b, std::array<RegularPart, 2>& parts) const
{
  const Place lower = std::min(one, two), upper = std::max(one, two);
  const int axis = AxisOf(upper - lower), edgeAxis = AxisOf(a > b ? a - b : b - a);
  if (axis < 0 || edgeAxis < 0 || edgeAxis == axis || !IsCorner(a, lower) || !IsCorner(a, upper) ||
    !IsCorner(b, lower))
  {
    return 0;
  }
  const int other = 3 - axis - edgeAxis, otherSide = CornerAt(a, lower) >> other & 1;
  const Index cell = this->CellOf(lower);
  parts[0] = { cell, KindInTwo(axis, 1, other, otherSide) };
  parts[1] = { cell + this->Grid.Stride(axis), KindInTwo(axis, 0, other, otherSide) };
  return 2;
}

} // namespace vfm
