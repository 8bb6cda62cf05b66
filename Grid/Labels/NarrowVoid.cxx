#include "Labels/NarrowVoid.h"

#include "Base/Groups.h"
#include "Base/Sorted.h"
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
  if (cells.NumberOfCells() == 1)
  {
    const Index3& cell = cells.Lower;
    return work.Grid.Local().Contains(cell) ? work.Labels[work.Grid.Linear(cell)] : 0;
  }
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

/// Returns the units that share faces with some units around a unit. Bit n is unit StepAround(n).
std::uint32_t BesideUnits(std::uint32_t units)
{
  constexpr std::uint32_t LowX = 0x1249249, LowY = 0x1c0e07; // units at the lower side
  return (units & ~(LowX << 2)) << 1 | (units & ~LowX) >> 1 | (units & ~(LowY << 6)) << 3 |
    (units & ~LowY) >> 3 | units << 9 | units >> 9;
}

/// A void unit and the materials of the units around it, by StepAround; 0 is void or outside.
class Around
{
public:
  Around(const Work& work, const IndexBox& cells) : Cells(cells)
  {
    const IndexBox& box = work.Grid.Local();
    if (cells.NumberOfCells() == 1 && Grow(cells, 1, box).NumberOfCells() == 27)
    {
      this->ReadCells(work.Labels, work.Grid);
    }
    else
    {
      for (int n = 0; n < 27; ++n)
      {
        this->Material[n] = MaterialIn(work, Shifted(cells, StepAround(n), cells.Size(0)));
      }
    }
    this->IsBeside = std::any_of(
      this->Material.begin(), this->Material.end(), [](int material) { return material > 0; });
    if (this->IsBeside)
    {
      this->FindParts();
    }
  }
  bool HasMaterial(int n) const { return this->Material[n] > 0; }
  /// Returns whether two materials around the unit are connected there by faces. Both must be
  /// materials.
  bool AreOnePart(int n, int m) const { return this->Parts[n] == this->Parts[m]; }
  bool HasSeveralParts() const { return this->NumberOfParts > 1; }

  IndexBox Cells;
  std::array<int, 27> Material;
  bool IsBeside = false; // whether any unit around has a material

private:
  /// Fills Material for a single cell whose neighbours are all in the local box.
  void ReadCells(const LabelArray& labels, const CartesianGrid& grid)
  {
    const Index3& cell = this->Cells.Lower;
    for (int row = 0; row < 9; ++row)
    {
      const Index first =
        grid.Linear({ { cell[0] - 1, cell[1] + row % 3 - 1, cell[2] + row / 3 - 1 } });
      const LabelArray::RowView view = labels.Row(first);
      for (int x = 0; x < 3; ++x)
      {
        this->Material[3 * row + x] = view[labels.InRow(first) + x];
      }
    }
  }
  void FindParts()
  {
    std::uint32_t left = 0;
    for (int n = 0; n < 27; ++n)
    {
      left |= static_cast<std::uint32_t>(this->HasMaterial(n)) << n;
    }
    for (; left != 0; ++this->NumberOfParts)
    {
      std::uint32_t part = left & ~(left - 1); // grows from the lowest unit
      for (std::uint32_t before = 0; part != before;)
      {
        before = part;
        part = (part | BesideUnits(part)) & left;
      }
      for (int n = 0; n < 27; ++n)
      {
        this->Parts[n] = part >> n & 1 ? this->NumberOfParts : this->Parts[n];
      }
      left &= ~part;
    }
  }

  std::array<int, 27> Parts{}; // number of the part of each unit with a material
  int NumberOfParts = 0;
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
  for (int n = 0; n < 27 && around.HasSeveralParts(); ++n)
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

/// Void cell with a mixed node, in a row along x.
struct BesideCell
{
  Index X, Width; // index along x; width of the unit of the cell, in cells
};

/// The void cells with mixed nodes, by rows of the local box.
class BesideCells
{
public:
  BesideCells(const Work& work, const std::vector<Index>& mixed, Runtime& runtime) :
    Box(work.Grid.Local()), Rows(Box.Size(1) * Box.Size(2))
  {
    ForRows(runtime, this->Box,
      [&](Index j, Index k, Index row) { this->FillRow(work, mixed, j, k, this->Rows[row]); });
    std::vector<unsigned char> occurs(work.Units.LargestWidth() + 1, 0);
    for (const std::vector<BesideCell>& row : this->Rows)
    {
      std::for_each(
        row.begin(), row.end(), [&](const BesideCell& cell) { occurs[cell.Width] = 1; });
    }
    for (std::size_t width = 0; width < occurs.size(); ++width)
    {
      if (occurs[width])
      {
        this->TheWidths.push_back(static_cast<Index>(width));
      }
    }
  }

  /// Returns the widths of the cells, each once.
  const std::vector<Index>& Widths() const { return this->TheWidths; }

  /// Returns the cells of a row; empty outside the local box.
  const std::vector<BesideCell>& Row(Index j, Index k) const
  {
    static const std::vector<BesideCell> none;
    const bool isInside = this->Box.Lower[1] <= j && j < this->Box.Upper[1] &&
      this->Box.Lower[2] <= k && k < this->Box.Upper[2];
    return isInside
      ? this->Rows[(k - this->Box.Lower[2]) * this->Box.Size(1) + j - this->Box.Lower[1]]
      : none;
  }

private:
  void FillRow(const Work& work, const std::vector<Index>& mixed, Index j, Index k,
    std::vector<BesideCell>& cells) const
  {
    std::vector<Index> at; // indices along x
    for (int n = 0; n < 4; ++n)
    {
      const Index first = work.Grid.Linear({ { this->Box.Lower[0], j + (n & 1), k + (n >> 1) } });
      const auto begin = std::lower_bound(mixed.begin(), mixed.end(), first);
      for (auto node = begin; node != mixed.end() && *node <= first + this->Box.Size(0); ++node)
      {
        const Index x = this->Box.Lower[0] + *node - first;
        at.push_back(x - 1);
        at.push_back(x);
      }
    }
    SortUnique(at);
    for (Index x : at)
    {
      const Index3 cell{ { x, j, k } };
      if (IsVoid(work, cell))
      {
        cells.push_back({ x, work.Units.CellsOf(work.Units.UnitOf(cell)).Size(0) });
      }
    }
  }

  const IndexBox Box;
  std::vector<std::vector<BesideCell>> Rows;
  std::vector<Index> TheWidths;
};

/// Returns the units of the void cells of a row that can be narrow: the cells with mixed nodes, and
/// a cell of each unit around these. Units can occur repeatedly.
std::vector<Index> FindCandidates(const Work& work, const BesideCells& beside, Index j, Index k)
{
  const IndexBox& box = work.Grid.Local();
  std::vector<unsigned char> isNear(box.Size(0), 0);
  const auto mark = [&](Index x)
  {
    if (box.Lower[0] <= x && x < box.Upper[0])
    {
      isNear[x - box.Lower[0]] = 1;
    }
  };
  for (Index width : beside.Widths())
  {
    for (Index row = 0; row < 9; ++row)
    {
      for (const BesideCell& cell :
        beside.Row(j + (row % 3 - 1) * width, k + (row / 3 - 1) * width))
      {
        for (Index step = -1; step <= 1 && cell.Width == width; ++step)
        {
          mark(cell.X + step * width);
        }
      }
    }
  }
  std::vector<Index> units;
  for (Index x = box.Lower[0]; x < box.Upper[0]; ++x)
  {
    const Index3 cell{ { x, j, k } };
    if (isNear[x - box.Lower[0]] && IsVoid(work, cell) &&
      !(work.Levels.HasFineInterfaces() && !work.Levels.IsFine(cell)))
    {
      units.push_back(work.Units.UnitOf(cell));
    }
  }
  return units;
}

/// Returns the narrow units, ascending.
std::vector<Index> FindNarrow(const Work& work, const std::vector<Index>& mixed, Runtime& runtime)
{
  const IndexBox& box = work.Grid.Local();
  const BesideCells beside(work, mixed, runtime);
  std::vector<std::vector<Index>> found(box.Size(1) * box.Size(2));
  ForRows(runtime, box,
    [&](Index j, Index k, Index row)
    {
      std::vector<Index>& units = found[row];
      units = FindCandidates(work, beside, j, k);
      SortUnique(units);
      units.erase(std::remove_if(units.begin(), units.end(),
                    [&](Index unit) { return !IsNarrow(work, work.Units.CellsOf(unit)); }),
        units.end());
    });
  std::vector<Index> narrow = Joined(found);
  SortUnique(narrow);
  return narrow;
}

} // namespace

NarrowVoid::NarrowVoid(const RefinedGrid& levels, const LabelArray& labels,
  const std::vector<Index>& mixed, Runtime& runtime) :
  Cells(levels.Finest(), 0), Nodes(levels.Finest(), 0)
{
  const Work work{ levels, labels };
  for (Index unit : FindNarrow(work, mixed, runtime))
  {
    this->Add(work.Grid, work.Units.CellsOf(unit));
  }
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
  const LabelArray& labels, const std::vector<Index>& mixed, Runtime& runtime)
{
  return !options.MeshVoid && MovesPoints(options) ? NarrowVoid(levels, labels, mixed, runtime)
                                                   : NarrowVoid();
}

} // namespace vfm
