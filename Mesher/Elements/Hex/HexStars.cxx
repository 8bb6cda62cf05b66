#include "Elements/Hex/HexStars.h"

#include "Base/Sorted.h"
#include "Elements/Hex/HexTopology.h"

#include <limits>
#include <numeric>

namespace vfm
{

int LabelOfLeaf(
  const RefinedGrid& grid, const LabelArray& labels, const OctreeKeys::LevelIndex& cell)
{
  const Index3 nearest = grid.NearestCell(cell.Level, cell.At);
  return grid.Finest().Local().Contains(nearest) ? labels[grid.Finest().Linear(nearest)]
                                                 : UnknownLabel;
}

HexStars::HexStars(const RefinedGrid& grid, const RefinedMesh& refined, const IndexBox& region,
  const LabelArray& labels) :
  Grid(grid),
  Lattice(grid.Lattice()),
  Refined(refined),
  Region(region),
  Labels(labels),
  IsTouched(region.NumberOfCells(), false)
{
  for (Index key : refined.TouchedCells)
  {
    this->IsTouched[IndexInBox(region, this->Lattice.HexOfKey(HexSlots * key).At)] = true;
  }
  this->FindNodes();
  this->GatherHexes();
  this->LinkHexes();
}

Index HexStars::Find(Index key) const
{
  return FindSorted(this->Keys, key);
}

int HexStars::DomainSides(Index n) const
{
  const OctreeKeys::LevelIndex node = this->Lattice.NodeOfKey(this->Keys[n]);
  if (node.Slot == 0)
  {
    return this->Lattice.DomainSides(node.Level, node.At);
  }
  return this->Refined.DomainSides[FindSorted(this->Refined.PointKeys, this->Keys[n])];
}

/// Finds the points of Refined with several labels around them, and such base nodes of
/// untouched cells.
void HexStars::FindNodes()
{
  const std::vector<Index>& keys = this->Refined.PointKeys;
  std::vector<int> least(keys.size(), std::numeric_limits<int>::max()), most(keys.size(), -1);
  const auto see = [&](Index point, int label)
  {
    least[point] = std::min(least[point], label);
    most[point] = std::max(most[point], label);
  };
  for (Index h = 0; h < this->Refined.NumberOfHexes(); ++h)
  {
    const int label =
      LabelOfLeaf(this->Grid, this->Labels, this->Lattice.HexOfKey(this->Refined.HexKeys[h]));
    for (Index at = 8 * h; at < 8 * h + 8; ++at)
    {
      see(this->Refined.Hexes[at], label);
    }
  }
  const CartesianGrid& finest = this->Grid.Finest();
  for (std::size_t p = 0; p < keys.size(); ++p)
  {
    const OctreeKeys::LevelIndex index = this->Lattice.NodeOfKey(keys[p]);
    const Index3 node = this->Grid.FinestNode(index.Level, index.At);
    for (int c = 0; index.Slot == 0 && c < 8; ++c)
    {
      const Index3 cell = CellOfStar(node, c);
      if (this->IsFineCell(cell))
      {
        see(static_cast<Index>(p), this->Labels[finest.Linear(cell)]);
      }
    }
  }
  this->CompareBaseCells(least, most);
  for (std::size_t p = 0; p < keys.size(); ++p)
  {
    if (most[p] >= 0 && least[p] != most[p])
    {
      this->Keys.push_back(keys[p]);
    }
  }
  SortUnique(this->Keys);
}

/// Splits the nodes of faces between base cells with different labels, at least one of them
/// untouched. Nodes that only untouched cells have are added at once.
void HexStars::CompareBaseCells(std::vector<int>& least, std::vector<int>& most)
{
  ForCells(this->Region,
    [&](const Index3& cell)
    {
      const int label = LabelOfLeaf(this->Grid, this->Labels, { 0, cell, 0 });
      for (int axis = 0; axis < 3; ++axis)
      {
        Index3 next = cell;
        ++next[axis];
        if (!this->Region.Contains(next) ||
          (this->IsBaseTouched(cell) && this->IsBaseTouched(next)) ||
          LabelOfLeaf(this->Grid, this->Labels, { 0, next, 0 }) == label)
        {
          continue;
        }
        for (int c = 0; c < 8; ++c)
        {
          if (c >> axis & 1)
          {
            const Index key = this->Lattice.NodeKey(0, CornerOfCell(cell, c), 0);
            const Index point = FindSorted(this->Refined.PointKeys, key);
            if (point < 0)
            {
              this->Keys.push_back(key);
              continue;
            }
            least[point] = -1; // splits the node in any case
            most[point] = std::max(most[point], 0);
          }
        }
      }
    });
}

HexStars::Hex HexStars::MakeHex(Kind kind, Index id) const
{
  OctreeKeys::LevelIndex cell;
  Index key = -1;
  switch (kind)
  {
    case Kind::Refined:
      key = this->Refined.HexKeys[id];
      cell = this->Lattice.HexOfKey(key);
      break;
    case Kind::Base:
      key = HexSlots * id;
      cell = this->Lattice.HexOfKey(key);
      break;
    case Kind::Fine:
      cell = this->Lattice.HexOfKey(
        this->Lattice.HexKey(this->Grid.NumberOfRefinements(), { { 0, 0, 0 } }, 0) + HexSlots * id);
      break;
  }
  return { kind, id, { cell, key, LabelOfLeaf(this->Grid, this->Labels, cell) } };
}

/// Adds the keys of the untouched base cells, or of the finest cells, at a node.
void HexStars::AddCells(Kind kind, int level, const Index3& node, std::vector<Index>& cells) const
{
  for (int c = 0; c < 8; ++c)
  {
    if (kind == Kind::Base)
    {
      const Index3 cell = CellOfStar(node, c);
      if (level == 0 && this->Region.Contains(cell) && !this->IsBaseTouched(cell))
      {
        cells.push_back(this->Grid.Base().CellKey(cell));
      }
      continue;
    }
    const Index3 p = this->Grid.FinestNode(level, node);
    const Index3 cell = CornerOfCell({ { p[0] - 1, p[1] - 1, p[2] - 1 } }, c);
    if (this->IsFineCell(cell))
    {
      cells.push_back(this->Grid.Finest().CellKey(cell));
    }
  }
}

void HexStars::GatherHexes()
{
  std::vector<bool> isSplit(this->Refined.PointKeys.size());
  for (std::size_t p = 0; p < isSplit.size(); ++p)
  {
    isSplit[p] = this->Find(this->Refined.PointKeys[p]) >= 0;
  }
  for (Index h = 0; h < this->Refined.NumberOfHexes(); ++h)
  {
    const Index* hex = this->Refined.Hexes.data() + 8 * h;
    if (std::any_of(hex, hex + 8, [&](Index p) { return isSplit[p]; }))
    {
      this->TheHexes.push_back(this->MakeHex(Kind::Refined, h));
    }
  }
  for (Kind kind : { Kind::Base, Kind::Fine })
  {
    std::vector<Index> cells;
    for (Index key : this->Keys)
    {
      const OctreeKeys::LevelIndex node = this->Lattice.NodeOfKey(key);
      if (node.Slot == 0)
      {
        this->AddCells(kind, node.Level, node.At, cells);
      }
    }
    SortUnique(cells);
    for (Index cell : cells)
    {
      this->TheHexes.push_back(this->MakeHex(kind, cell));
    }
  }
}

Index HexStars::KeyAt(const Hex& hex, int corner) const
{
  return hex.What == Kind::Refined
    ? this->Refined.PointKeys[this->Refined.Hexes[8 * hex.Id + VtkCorner[corner]]]
    : this->Lattice.LatticeKey(hex.Place.Cell.Level, CornerOfCell(hex.Place.Cell.At, corner));
}

Vector3 HexStars::PointAt(const Hex& hex, int corner) const
{
  if (hex.What == Kind::Refined)
  {
    const double* x =
      this->Refined.Points.data() + 3 * this->Refined.Hexes[8 * hex.Id + VtkCorner[corner]];
    return { { x[0], x[1], x[2] } };
  }
  return this->Lattice.NodePoint(hex.Place.Cell.Level, CornerOfCell(hex.Place.Cell.At, corner));
}

/// Returns the smallest widths of the hexes at a node; transition hexes are about half as wide as
/// their cell.
Vector3 HexStars::WidthsAt(const Star& star) const
{
  Vector3 least{ { 1e300, 1e300, 1e300 } };
  for (const Corner& at : star)
  {
    const Hex& hex = this->TheHexes[at.Hex];
    const Vector3 widths = this->Lattice.CellWidths(hex.Place.Cell.Level, hex.Place.Cell.At);
    const bool isTransition = hex.What == Kind::Refined && this->Refined.IsTransition[hex.Id];
    for (int a = 0; a < 3; ++a)
    {
      least[a] = std::min(least[a], (isTransition ? 0.5 : 1.0) * widths[a]);
    }
  }
  return least;
}

/// Lists the hexes at each node.
void HexStars::LinkHexes()
{
  for (std::size_t h = 0; h < this->TheHexes.size(); ++h)
  {
    for (int c = 0; c < 8; ++c)
    {
      const Index n = this->Find(this->KeyAt(this->TheHexes[h], c));
      if (n >= 0)
      {
        this->Corners.push_back({ n, static_cast<Index>(h), c });
      }
    }
  }
  std::stable_sort(this->Corners.begin(), this->Corners.end(),
    [](const Corner& a, const Corner& b) { return a.Node < b.Node; });
  this->Begin.assign(this->Keys.size() + 1, 0);
  for (const Corner& corner : this->Corners)
  {
    ++this->Begin[corner.Node + 1];
  }
  std::partial_sum(this->Begin.begin(), this->Begin.end(), this->Begin.begin());
}

} // namespace vfm
