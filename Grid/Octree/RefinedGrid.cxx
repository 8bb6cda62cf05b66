#include "Octree/RefinedGrid.h"

#include "Base/Sorted.h"
#include "Fractions/CoarsenFields.h"

namespace vfm
{
namespace
{

constexpr int BaseGhostLayers = 3; // one more than the layers of base cells whose hexes are made

} // namespace

RefinedGrid::RefinedGrid(const CartesianGrid& finest, const LevelPlan& plan,
  const std::vector<Index>& interfaces, Ranks& ranks) :
  FinestGrid(finest),
  BaseGrid(CoarsenGrid(finest, plan.Refinements, BaseGhostLayers)),
  TheLattice(this->BaseGrid, plan.Refinements,
    { { finest.Coordinates(0), finest.Coordinates(1), finest.Coordinates(2) } }),
  Sets(
    this->TheLattice, this->RequestFamilies(plan, interfaces), plan.Unit, this->FindPart(), ranks),
  UnitShift(plan.Unit == RefinedUnit::Cell ? 1 : 2),
  Uniform(plan.Refinements == 0),
  FineInterfaces(plan.FineInterfaces || this->Uniform)
{
  if (!this->IsUniform())
  {
    this->MarkFine();
  }
}

/// Returns the keys of the families of the last refinement around nodes.
std::vector<Index> RefinedGrid::FindFamilies(
  const std::vector<Index>& interfaces, const LevelPlan& plan) const
{
  const bool isCell = plan.Unit == RefinedUnit::Cell;
  const int level = this->NumberOfRefinements() - !isCell; // of the keys
  std::vector<Index> keys;
  for (Index node : interfaces)
  {
    const Index3 p = this->FinestGrid.Position(node);
    if (!this->FinestGrid.Owned().Touches(p))
    {
      continue;
    }
    const IndexBox around{ CellOfStar(p, 0), CornerOfCell(p, 7) };
    ForCells(
      ChangeLevel(Grow(around, plan.FineLayers, this->FinestGrid.Global()), isCell ? -1 : -2),
      [&](const Index3& q) { keys.push_back(this->TheLattice.FamilyKey(level, q)); });
  }
  SortUnique(keys);
  return keys;
}

/// Returns the families of the plan and those around interfaces, which this rank requests.
std::vector<std::vector<Index>> RefinedGrid::RequestFamilies(
  const LevelPlan& plan, const std::vector<Index>& interfaces) const
{
  std::vector<std::vector<Index>> families = plan.Families;
  families.resize(plan.Refinements);
  if (plan.FineInterfaces && plan.Refinements > 0)
  {
    const std::vector<Index> around = this->FindFamilies(interfaces, plan);
    families.back().insert(families.back().end(), around.begin(), around.end());
  }
  return families;
}

/// Returns the base cells of which this rank holds any cell.
IndexBox RefinedGrid::FindPart() const
{
  const IndexBox fine = ChangeLevel(this->FinestGrid.Local(), -this->NumberOfRefinements());
  IndexBox part = this->BaseGrid.Local();
  for (int a = 0; a < 3 && fine.NumberOfCells() > 0; ++a)
  {
    part.Lower[a] = std::min(part.Lower[a], fine.Lower[a]);
    part.Upper[a] = std::max(part.Upper[a], fine.Upper[a]);
  }
  return part;
}

void RefinedGrid::MarkFine()
{
  const int level = this->NumberOfRefinements() - 1;
  const IndexBox& box = this->FinestGrid.Local();
  this->Marked = ChangeLevel(box, -this->UnitShift);
  this->Fine.assign(this->Marked.NumberOfCells(), 0);
  this->HasFine.assign(this->Marked.Size(1) * this->Marked.Size(2), 0);
  for (Index key : this->Sets.Keys(level))
  {
    const Index3 q = this->TheLattice.FamilyOfKey(this->Sets.FamilyLevel(level), key);
    if (this->Marked.Contains(q))
    {
      this->Fine[IndexInBox(this->Marked, q)] = 1;
      this->HasFine[IndexInBox(this->Marked, q) / this->Marked.Size(0)] = 1;
    }
  }
}

/// Returns the row of families that contains a row of finest cells. A row outside the domain counts
/// as the row that it mirrors.
Index RefinedGrid::RowOfFamilies(Index j, Index k) const
{
  const auto family = [this](int a, Index i)
  {
    const IndexBox& box = this->FinestGrid.Local();
    return (std::min(std::max(i, box.Lower[a]), box.Upper[a] - 1) >> this->UnitShift) -
      this->Marked.Lower[a];
  };
  return family(2, k) * this->Marked.Size(1) + family(1, j);
}

bool RefinedGrid::IsMarked(const Index3& cell) const
{
  const IndexBox& box = this->FinestGrid.Local();
  if (box.NumberOfCells() == 0)
  {
    return false;
  }
  Index3 q = box.Nearest(cell);
  for (Index& i : q)
  {
    i >>= this->UnitShift;
  }
  return this->Fine[IndexInBox(this->Marked, q)];
}

int RefinedGrid::CountFineAround(const Index3& node) const
{
  int count = 0;
  for (int c = 0; c < 8; ++c)
  {
    count += this->IsFine(CellOfStar(node, c));
  }
  return count;
}

OctreeKeys::LevelIndex RefinedGrid::LeafOf(const Index3& finestCell) const
{
  OctreeKeys::LevelIndex leaf{ 0, finestCell, 0 };
  for (;; ++leaf.Level)
  {
    const int shift = this->NumberOfRefinements() - leaf.Level;
    leaf.At = { { finestCell[0] >> shift, finestCell[1] >> shift, finestCell[2] >> shift } };
    if (shift == 0 || !this->Sets.IsRefined(leaf.Level, leaf.At))
    {
      return leaf;
    }
  }
}

IndexBox RefinedGrid::FinestCells(int level, const Index3& cell) const
{
  return ChangeLevel(BoxOfCell(cell), this->NumberOfRefinements() - level);
}

Index3 RefinedGrid::FinestNode(int level, const Index3& node) const
{
  // Multiplied, because nodes below the grid have negative indices, which must not be shifted.
  const Index width = Index(1) << (this->NumberOfRefinements() - level);
  return { { node[0] * width, node[1] * width, node[2] * width } };
}

bool RefinedGrid::IsNear(int level, const Index3& cell) const
{
  const IndexBox box = this->FinestCells(level, cell);
  const IndexBox& owned = this->FinestGrid.Owned();
  bool near = owned.NumberOfCells() > 0;
  for (int a = 0; a < 3; ++a)
  {
    near = near && box.Lower[a] <= owned.Upper[a] && owned.Lower[a] <= box.Upper[a];
  }
  return near;
}

Index3 RefinedGrid::NearestCell(int level, const Index3& cell) const
{
  return this->FinestCells(level, cell).Nearest(this->FinestGrid.Owned().Lower);
}

} // namespace vfm
