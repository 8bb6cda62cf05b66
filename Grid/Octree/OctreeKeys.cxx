#include "Octree/OctreeKeys.h"

#include "Base/Runtime.h"
#include "Fractions/RefineCells.h"

#include <cmath>
#include <limits>

namespace vfm
{
namespace
{

Index Linear(const Index3& p, Index nx, Index ny)
{
  return (p[2] * ny + p[1]) * nx + p[0];
}

Index3 Position(Index n, Index nx, Index ny)
{
  return { { n % nx, n / nx % ny, n / nx / ny } };
}

/// Returns the last level whose keys begin at or before the key.
int LevelOf(const std::vector<Index>& offsets, Index key)
{
  return static_cast<int>(std::upper_bound(offsets.begin(), offsets.end(), key) - offsets.begin()) -
    1;
}

/// Throws InputError if keys need more than 64 bits.
void CheckKeys(const CartesianGrid& base, int refinements)
{
  // The factor 2 covers the coarser levels, which together have fewer keys than the finest one.
  double bound = 2.0 * static_cast<double>(OctreeKeys::HexSlots);
  for (Index n : base.Global().Upper)
  {
    bound *= std::ldexp(static_cast<double>(n), refinements) + 1.0;
  }
  if (bound >= static_cast<double>(std::numeric_limits<Index>::max()))
  {
    throw InputError("The refined grid has more nodes than 64-bit keys can number: refine less.");
  }
}

/// Returns the coordinates of the nodes of the finest level if all cells are halved.
std::array<std::vector<double>, 3> HalveOften(const CartesianGrid& base, int refinements)
{
  CheckKeys(base, refinements);
  return HalveWidths(base.Coordinates(), refinements);
}

} // namespace

OctreeKeys::OctreeKeys(const CartesianGrid& base, int refinements) :
  OctreeKeys(base, refinements, HalveOften(base, refinements))
{
}

OctreeKeys::OctreeKeys(
  const CartesianGrid& base, int refinements, std::array<std::vector<double>, 3> finest) :
  Grid(base), X(std::move(finest))
{
  if (refinements > 0)
  {
    CheckKeys(base, refinements);
  }
  Index nodes = 0, hexes = 0;
  for (int level = 0; level <= refinements; ++level)
  {
    this->NodeOffset.push_back(nodes);
    this->HexOffset.push_back(hexes);
    Index n = 1, c = 1;
    for (int a = 0; a < 3; ++a)
    {
      c *= this->Cells(level, a);
      n *= this->Cells(level, a) + 1;
    }
    nodes += n * NodeSlots;
    hexes += c * HexSlots;
  }
}

bool OctreeKeys::HasCell(int level, const Index3& cell) const
{
  bool has = true;
  for (int a = 0; a < 3; ++a)
  {
    has = has && cell[a] >= 0 && cell[a] < this->Cells(level, a);
  }
  return has;
}

bool OctreeKeys::HasFamily(int level, const Index3& family) const
{
  return this->HasCell(level, { { 2 * family[0], 2 * family[1], 2 * family[2] } });
}

Vector3 OctreeKeys::NodePoint(int level, const Index3& node) const
{
  return { { this->Coordinate(level, 0, node[0]), this->Coordinate(level, 1, node[1]),
    this->Coordinate(level, 2, node[2]) } };
}

Vector3 OctreeKeys::ToPoint(const Vector3& x) const
{
  const int levels = this->NumberOfRefinements();
  Vector3 point;
  for (int a = 0; a < 3; ++a)
  {
    const double fine = std::ldexp(x[a], levels);
    const Index last = this->Cells(levels, a) - 1;
    const Index cell = std::min(std::max<Index>(static_cast<Index>(std::floor(fine)), 0), last);
    const double low = this->X[a][cell], high = this->X[a][cell + 1];
    const double part = fine - static_cast<double>(cell);
    point[a] = part == 1.0 ? high : low + part * (high - low); // exact on the upper side
  }
  return point;
}

Vector3 OctreeKeys::FromPoint(const Vector3& point) const
{
  Vector3 x;
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& nodes = this->X[a];
    const Index cell =
      std::upper_bound(nodes.begin() + 1, nodes.end() - 1, point[a]) - nodes.begin() - 1;
    const double fine =
      static_cast<double>(cell) + (point[a] - nodes[cell]) / (nodes[cell + 1] - nodes[cell]);
    x[a] = std::ldexp(fine, -this->NumberOfRefinements());
  }
  return x;
}

Vector3 OctreeKeys::CellWidths(int level, const Index3& cell) const
{
  Vector3 widths;
  for (int a = 0; a < 3; ++a)
  {
    widths[a] = this->Coordinate(level, a, cell[a] + 1) - this->Coordinate(level, a, cell[a]);
  }
  return widths;
}

int OctreeKeys::DomainSides(int level, const Index3& node) const
{
  int sides = 0;
  for (int a = 0; a < 3; ++a)
  {
    sides |= (node[a] == 0) << (2 * a) | (node[a] == this->Cells(level, a)) << (2 * a + 1);
  }
  return sides;
}

int OctreeKeys::FlatSeams(int level, const Index3& node) const
{
  const Index3 below{ { node[0] >> level, node[1] >> level, node[2] >> level } };
  int axes = this->Grid.IsPeriodic() ? this->Grid.FlatSeams(below) : 0;
  for (int a = 0; a < 3; ++a)
  {
    axes &= ~((node[a] != below[a] << level) << a);
  }
  return axes;
}

Index OctreeKeys::FamilyKey(int level, const Index3& family) const
{
  return Linear(family, this->Families(level, 0), this->Families(level, 1));
}

Index3 OctreeKeys::FamilyOfKey(int level, Index key) const
{
  return Position(key, this->Families(level, 0), this->Families(level, 1));
}

Index OctreeKeys::NodeKey(int level, const Index3& node, int slot) const
{
  return this->NodeOffset[level] +
    NodeSlots * Linear(node, this->Cells(level, 0) + 1, this->Cells(level, 1) + 1) + slot;
}

Index OctreeKeys::LatticeKey(int level, Index3 node) const
{
  for (; level > 0 && !((node[0] | node[1] | node[2]) & 1); --level)
  {
    node = { { node[0] / 2, node[1] / 2, node[2] / 2 } };
  }
  return this->NodeKey(level, node, 0);
}

Index OctreeKeys::HexKey(int level, const Index3& cell, int slot) const
{
  return this->HexOffset[level] +
    HexSlots * Linear(cell, this->Cells(level, 0), this->Cells(level, 1)) + slot;
}

OctreeKeys::LevelIndex OctreeKeys::NodeOfKey(Index key) const
{
  const int level = LevelOf(this->NodeOffset, key);
  const Index at = key - this->NodeOffset[level];
  return { level, Position(at / NodeSlots, this->Cells(level, 0) + 1, this->Cells(level, 1) + 1),
    static_cast<int>(at % NodeSlots) };
}

OctreeKeys::LevelIndex OctreeKeys::HexOfKey(Index key) const
{
  const int level = LevelOf(this->HexOffset, key);
  const Index at = key - this->HexOffset[level];
  return { level, Position(at / HexSlots, this->Cells(level, 0), this->Cells(level, 1)),
    static_cast<int>(at % HexSlots) };
}

} // namespace vfm
