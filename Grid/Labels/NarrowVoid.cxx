#include "Labels/NarrowVoid.h"

#include "Base/DisjointSets.h"
#include "Labels/LeafLabels.h"

namespace vfm
{
namespace
{

Index SquareOf(const Index3& step)
{
  return step[0] * step[0] + step[1] * step[1] + step[2] * step[2];
}

struct Work
{
  const RefinedGrid& Levels;
  const LabelArray& Labels;
  const CartesianGrid& Grid = Levels.Finest();
  const bool HasCubes = vfm::HasCubes(Grid);
  const LabelUnits Units{ Grid, Levels.HasFineInterfaces() ? nullptr : &Levels };
};

bool IsVoid(const Work& work, const Index3& cell)
{
  return work.Grid.Local().Contains(cell) && work.Labels[work.Grid.Linear(cell)] == 0;
}

/// Returns the material of the first cell of a box that has one, else 0.
int MaterialIn(const Work& work, const IndexBox& cells)
{
  int material = 0;
  ForCells(Intersect(cells, work.Grid.Local()),
    [&](const Index3& cell)
    { material = material > 0 ? material : work.Labels[work.Grid.Linear(cell)]; });
  return material;
}

IndexBox Shifted(IndexBox cells, const Index3& step, Index factor)
{
  for (int a = 0; a < 3; ++a)
  {
    cells.Lower[a] += factor * step[a];
    cells.Upper[a] += factor * step[a];
  }
  return cells;
}

/// A void unit and the materials of the units around it, by StepAround; 0 is void or outside.
class Around
{
public:
  Around(const Work& work, const IndexBox& cells) : Cells(cells)
  {
    for (int n = 0; n < 27; ++n)
    {
      this->Material[n] = MaterialIn(work, Shifted(cells, StepAround(n), cells.Size(0)));
      this->IsBeside = this->IsBeside || this->HasMaterial(n);
    }
    this->FindParts();
  }
  bool HasMaterial(int n) const { return this->Material[n] > 0; }
  /// Returns whether two materials around the unit are connected there by faces.
  bool AreOnePart(int n, int m) const { return this->Parts[n] == this->Parts[m]; }

  IndexBox Cells;
  std::array<int, 27> Material;
  bool IsBeside = false; // whether any unit around has a material

private:
  void FindParts()
  {
    std::vector<Index> parent = MakeSets(27);
    for (int n = 0; n < 27; ++n)
    {
      const Index3 step = StepAround(n);
      for (int axis = 0, next = 1; axis < 3; ++axis, next *= 3)
      {
        if (step[axis] < 1 && this->HasMaterial(n) && this->HasMaterial(n + next))
        {
          Join(parent, n, n + next);
        }
      }
    }
    for (int n = 0; n < 27; ++n)
    {
      this->Parts[n] = FindRoot(parent, n);
    }
  }

  std::array<Index, 27> Parts; // a number for each connected part
};

/// Returns whether materials are within two units on both sides. Not where one part, as at a
/// concave edge, is beside the unit along a diagonal.
bool IsBetween(const Work& work, const Around& around)
{
  const auto reaches = [&](int n)
  {
    const bool looksFar = !work.HasCubes || SquareOf(StepAround(n)) == 1;
    return around.HasMaterial(n) ||
      (looksFar &&
        MaterialIn(work, Shifted(around.Cells, StepAround(n), 2 * around.Cells.Size(0))) > 0);
  };
  bool found = false;
  for (int n = 0; n < 13 && !found; ++n) // one of each pair of opposite steps
  {
    const bool isOnePart = SquareOf(StepAround(n)) > 1 && around.HasMaterial(n) &&
      around.HasMaterial(26 - n) && around.AreOnePart(n, 26 - n);
    found = !isOnePart && reaches(n) && reaches(26 - n);
  }
  return found;
}

/// Returns whether two separate parts are around a unit, at an angle of 120 degrees or more.
bool IsBetweenParts(const Around& around)
{
  bool found = false;
  for (int n = 0; n < 27; ++n)
  {
    for (int m = 0; m < n && around.HasMaterial(n) && !found; ++m)
    {
      if (around.AreOnePart(n, m) || !around.HasMaterial(m))
      {
        continue;
      }
      const Index3 a = StepAround(n), b = StepAround(m);
      const Index dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
      found = dot < 0 && 4 * dot * dot >= SquareOf(a) * SquareOf(b);
    }
  }
  return found;
}

/// Returns whether a unit shares faces with different materials.
bool IsBesideSeveral(const Around& around)
{
  int material = 0;
  bool found = false;
  for (int n : { 4, 10, 12, 14, 16, 22 }) // steps to the neighbours by faces
  {
    found = found || (around.HasMaterial(n) && material > 0 && around.Material[n] != material);
    material = std::max(material, around.Material[n]);
  }
  return found;
}

/// Returns whether a unit lies between a side of the domain and a material, beside more of it.
bool IsPocket(const Work& work, const Around& around)
{
  const IndexBox& domain = work.Grid.Global();
  bool found = false;
  for (int axis = 0, step = 1; axis < 3; ++axis, step *= 3)
  {
    const bool isClosed =
      (around.Cells.Lower[axis] == domain.Lower[axis] && around.HasMaterial(13 + step)) ||
      (around.Cells.Upper[axis] == domain.Upper[axis] && around.HasMaterial(13 - step));
    for (int other = 1; other < 27; other *= 3)
    {
      found = found ||
        (isClosed && other != step &&
          (around.HasMaterial(13 + other) || around.HasMaterial(13 - other)));
    }
  }
  return found;
}

bool IsNarrow(const Work& work, const IndexBox& cells)
{
  const Around around(work, cells);
  return IsBetween(work, around) ||
    (around.IsBeside &&
      (IsBesideSeveral(around) || IsPocket(work, around) || IsBetweenParts(around)));
}

/// Calls visit(cell) for the void cells that can be narrow: those at mixed nodes, and a cell of
/// each unit around these.
template <class Visitor>
void ForCandidates(const Work& work, const std::vector<Index>& mixed, const Visitor& visit)
{
  PagedArray<unsigned char> isDone(work.Grid, 0);
  for (Index node : mixed)
  {
    const Index3 p = work.Grid.Position(node);
    for (int c = 0; c < 8; ++c)
    {
      const Index3 cell = CellOfStar(p, c);
      if (!IsVoid(work, cell) || isDone[work.Grid.Linear(cell)] != 0)
      {
        continue;
      }
      isDone.Set(work.Grid.Linear(cell), 1);
      const IndexBox cells = work.Units.CellsOf(work.Units.UnitOf(cell));
      for (int n = 0; n < 27; ++n)
      {
        const Index3 other = Shifted(BoxOfCell(cell), StepAround(n), cells.Size(0)).Lower;
        if (IsVoid(work, other))
        {
          visit(other);
        }
      }
    }
  }
}

} // namespace

NarrowVoid::NarrowVoid(
  const RefinedGrid& levels, const LabelArray& labels, const std::vector<Index>& mixed) :
  Cells(levels.Finest(), 0), Nodes(levels.Finest(), 0)
{
  const Work work{ levels, labels };
  PagedArray<unsigned char> isDone(work.Grid, 0);
  ForCandidates(work, mixed,
    [&](const Index3& cell)
    {
      const Index unit = work.Units.UnitOf(cell);
      if (isDone[unit] != 0 || (levels.HasFineInterfaces() && !levels.IsFine(cell)))
      {
        return;
      }
      isDone.Set(unit, 1);
      const IndexBox cells = work.Units.CellsOf(unit);
      if (IsNarrow(work, cells))
      {
        this->Add(work.Grid, cells);
      }
    });
}

void NarrowVoid::Add(const CartesianGrid& grid, const IndexBox& cells)
{
  this->Empty = false;
  vfm::ForCells(cells, [&](const Index3& cell) { this->Cells.Set(grid.Linear(cell), 1); });
  vfm::ForCells(NodesOf(cells), [&](const Index3& node) { this->Nodes.Set(grid.Linear(node), 1); });
  const IndexBox owned = Intersect(cells, grid.Owned());
  this->Owned += owned.NumberOfCells();
}

NarrowVoid FindBarrier(const MeshSettings& options, const RefinedGrid& levels,
  const LabelArray& labels, const std::vector<Index>& mixed)
{
  return !options.MeshVoid && MovesPoints(options) ? NarrowVoid(levels, labels, mixed)
                                                   : NarrowVoid();
}

} // namespace vfm
