#include "Levels/PeriodicFields.h"

#include "Elements/PeriodicIds.h"
#include "Fractions/CoarsenFields.h"
#include "Fractions/GhostFractions.h"
#include "Input/NodeCoordinates.h"
#include "Labels/Labels.h"

namespace vfm
{
namespace
{

constexpr Index FewestCells = 3; // with two, different hexahedra would have the same points
// Largest number of faces between different materials at the seam without a warning: relative to
// the mean between two layers inside, and to all faces.
constexpr Index LargestExcess = 3;
constexpr double LargestShare = 0.05;

/// Checks the numbers of cells of the coarsest level.
void CheckSizes(const MesherOptions& options, const IndexBox& cells, bool isRefined)
{
  for (int a = 0; a < 3; ++a)
  {
    const Index size = RepeatingAxes(options)[a] ? cells.Size(a) : 2 * FewestCells;
    if (size < FewestCells)
    {
      throw InputError("A periodic mesh needs at least " + std::to_string(FewestCells) +
        " cells along " + AxisNames[a] + ", not " + std::to_string(size) + ".");
    }
    if (isRefined && size % 2 != 0) // families are pairs of cells
    {
      throw InputError("A refined periodic mesh needs an even number of cells along " +
        std::string(AxisNames[a]) + ", not " + std::to_string(size) + ".");
    }
  }
}

/// Collective. Returns for each axis the number of faces across it between cells of different
/// materials: inside the domain, and between the last cells and the copies of the first.
std::vector<Index> CountChanges(const CartesianGrid& grid, const LabelArray& labels, Ranks& ranks)
{
  std::vector<std::int64_t> counts(6, 0);
  ForCells(grid.Owned(),
    [&](const Index3& cell)
    {
      const Index at = grid.Linear(cell);
      for (int a = 0; a < 3; ++a)
      {
        const bool isLast = cell[a] == grid.Domain().Upper[a] - 1;
        const bool hasNext = !isLast || grid.Period(a) > 0;
        counts[2 * a + isLast] += hasNext && labels[at] != labels[at + grid.Stride(a)];
      }
    });
  ranks.Sum(counts);
  return counts;
}

/// Replaces the coarsest grid, and the keys of families accordingly.
void ReplaceBase(LevelFields& fields)
{
  const int levels = static_cast<int>(fields.Families.size());
  CartesianGrid base = CoarsenGrid(fields.Grid, levels, GhostLayers);
  const OctreeKeys before(fields.Base, levels), after(base, levels);
  const Index3 &from = fields.Base.Domain().Lower, &to = base.Domain().Lower;
  const Index3 cells{ { from[0] - to[0], from[1] - to[1], from[2] - to[2] } };
  for (int level = 0; level < levels; ++level)
  {
    for (Index& key : fields.Families[level])
    {
      const IndexBox family = ChangeLevel(BoxOfCell(before.FamilyOfKey(level, key)), 1);
      key = after.FamilyKeyOf(Below({ level, family.Lower, 0 }, cells, 0));
    }
  }
  fields.Base = std::move(base);
}

} // namespace

int CountPeriodicLevels(
  const MesherOptions& options, const std::array<std::vector<double>, 3>& coordinates)
{
  int levels = AnyLevel;
  for (int a = 0; a < 3; ++a)
  {
    const Index cells = static_cast<Index>(coordinates[a].size()) - 1;
    int own = 0;
    while (cells % (Index(4) << own) == 0 && (cells >> (own + 1)) >= FewestCells)
    {
      ++own;
    }
    levels = RepeatingAxes(options)[a] ? std::min(levels, own) : levels;
  }
  return levels;
}

void CheckPeriods(const MesherOptions& options)
{
  if (options.Periodic == 0)
  {
    return;
  }
  if (options.Elements == ElementKind::Tets && options.PeriodicSides == Sides::Free)
  {
    throw InputError("PeriodicSides is Free: the sides of tetrahedra can only be Flat or Joined.");
  }
}

void AddCopies(
  const MesherOptions& options, const LevelSetup& setup, Ranks& ranks, LevelFields& fields)
{
  if (options.Periodic == 0)
  {
    return;
  }
  CheckSizes(options, fields.Base.Global(), setup.Refinements() > 0);
  const int levels = static_cast<int>(fields.Families.size());
  ReplaceGrid(
    CartesianGrid::Covering(fields.Grid.Coordinates(), fields.Grid.Owned(), RepeatingAxes(options),
      options.PeriodicSides == Sides::Flat ? Seam::Flat : Seam::Free, GhostLayers, HexLayers,
      Index(GhostLayers) << levels),
    ranks, fields.Grid, fields.Field.Fractions);
  ReplaceBase(fields);
}

std::string DescribeSeams(const LevelFields& fields, double isoValue, Ranks& ranks)
{
  const CartesianGrid& grid = fields.Grid;
  std::string text;
  if (!grid.IsPeriodic())
  {
    return text;
  }
  const std::vector<Index> changes =
    CountChanges(grid, AssignMaterials(grid, fields.Field.Fractions, isoValue), ranks);
  for (int a = 0; a < 3; ++a)
  {
    const IndexBox& box = grid.Domain();
    const Index faces = box.NumberOfCells() / box.Size(a), layers = box.Size(a) - 1;
    const Index atSeam = changes[2 * a + 1];
    if (grid.Period(a) > 0 && atSeam * layers > LargestExcess * changes[2 * a] &&
      static_cast<double>(atSeam) > LargestShare * static_cast<double>(faces))
    {
      text += std::string(text.empty() ? "" : " ") + "Across " + AxisNames[a] +
        ", the materials of " + std::to_string(atSeam) + " of " + std::to_string(faces) +
        " faces of cells on opposite sides differ: the mesh has an interface there. Is the input "
        "one period?";
    }
  }
  return text;
}

void RemoveCopies(Ranks& ranks, LevelFields& fields)
{
  if (fields.Grid.IsPeriodic())
  {
    ReplaceGrid(fields.Grid.OfDomain(GhostLayers), ranks, fields.Grid, fields.Field.Fractions);
    ReplaceBase(fields);
  }
}

} // namespace vfm
