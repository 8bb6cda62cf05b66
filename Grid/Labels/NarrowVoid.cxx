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

bool IsVoid(const CartesianGrid& grid, const LabelArray& labels, const Index3& cell)
{
  return grid.Local().Contains(cell) && labels[grid.Linear(cell)] == 0;
}

/// Returns the material of the first cell of a box that has one, else 0.
int MaterialIn(const CartesianGrid& grid, const LabelArray& labels, const IndexBox& cells)
{
  if (cells.NumberOfCells() == 1)
  {
    const Index3& cell = cells.Lower;
    return grid.Local().Contains(cell) ? labels[grid.Linear(cell)] : 0;
  }
  int material = 0;
  ForCells(Intersect(cells, grid.Local()),
    [&](const Index3& cell) { material = material > 0 ? material : labels[grid.Linear(cell)]; });
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
  Around(const CartesianGrid& grid, const LabelArray& labels, const IndexBox& cells) : Cells(cells)
  {
    const IndexBox& box = grid.Local();
    if (cells.NumberOfCells() == 1 && Grow(cells, 1, box).NumberOfCells() == 27)
    {
      this->ReadCells(labels, grid);
    }
    else
    {
      for (int n = 0; n < 27; ++n)
      {
        this->Material[n] = MaterialIn(grid, labels, Shifted(cells, StepAround(n), cells.Size(0)));
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
/// @param hasCubes  whether all cells are cubes (HasCubes)
bool IsBetween(
  const CartesianGrid& grid, const LabelArray& labels, bool hasCubes, const Around& around)
{
  const auto reaches = [&](int n)
  {
    const bool looksFar = !hasCubes || SquareOf(StepAround(n)) == 1;
    return around.HasMaterial(n) ||
      (looksFar &&
        MaterialIn(grid, labels, Shifted(around.Cells, StepAround(n), 2 * around.Cells.Size(0))) >
          0);
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
bool IsPocket(const IndexBox& domain, const Around& around)
{
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

bool IsNarrow(
  const CartesianGrid& grid, const LabelArray& labels, bool hasCubes, const IndexBox& cells)
{
  const Around around(grid, labels, cells);
  return IsBetween(grid, labels, hasCubes, around) ||
    (around.IsBeside &&
      (IsBesideSeveral(around) || IsPocket(grid.Global(), around) || IsBetweenParts(around)));
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
  /// @param mixed  mixed nodes, ascending
  BesideCells(const CartesianGrid& grid, const LabelArray& labels, const LabelUnits& units,
    const std::vector<Index>& mixed, Runtime& runtime) :
    Box(grid.Local()), Rows(Box.Size(1) * Box.Size(2))
  {
    ForRows(runtime, this->Box,
      [&](Index j, Index k, Index row)
      {
        for (Index x : this->FindBeside(grid, mixed, j, k))
        {
          const Index3 cell{ { x, j, k } };
          if (IsVoid(grid, labels, cell))
          {
            this->Rows[row].push_back({ x, units.CellsOf(units.UnitOf(cell)).Size(0) });
          }
        }
      });
    this->FindWidths(units.LargestWidth());
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
  /// Returns the indices along x of the cells of a row with mixed nodes, ascending.
  std::vector<Index> FindBeside(
    const CartesianGrid& grid, const std::vector<Index>& mixed, Index j, Index k) const
  {
    std::vector<Index> at;
    for (int n = 0; n < 4; ++n)
    {
      const Index first = grid.Linear({ { this->Box.Lower[0], j + (n & 1), k + (n >> 1) } });
      const auto begin = std::lower_bound(mixed.begin(), mixed.end(), first);
      for (auto node = begin; node != mixed.end() && *node <= first + this->Box.Size(0); ++node)
      {
        const Index x = this->Box.Lower[0] + *node - first;
        at.push_back(x - 1);
        at.push_back(x);
      }
    }
    SortUnique(at);
    return at;
  }
  void FindWidths(Index largest)
  {
    std::vector<unsigned char> occurs(largest + 1, 0);
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

  const IndexBox Box;
  std::vector<std::vector<BesideCell>> Rows;
  std::vector<Index> TheWidths;
};

/// Marks the cells of a row that can be narrow: the cells with mixed nodes, and a cell of each unit
/// around these.
/// @param box  local box
std::vector<unsigned char> MarkCandidates(
  const IndexBox& box, const BesideCells& beside, Index j, Index k)
{
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
  return isNear;
}

/// Returns the units of the void cells of a row among some cells, ascending.
/// @param first  first cell of the row in the local box
/// @param isNear  whether each cell of the row is one of them
std::vector<Index> FindVoidUnits(const RefinedGrid& levels, const LabelArray& labels,
  const LabelUnits& units, const Index3& first, const std::vector<unsigned char>& isNear)
{
  std::vector<Index> found;
  for (std::size_t n = 0; n < isNear.size(); ++n)
  {
    const Index3 cell{ { first[0] + static_cast<Index>(n), first[1], first[2] } };
    if (isNear[n] && IsVoid(levels.Finest(), labels, cell) &&
      !(levels.HasFineInterfaces() && !levels.IsFine(cell)))
    {
      found.push_back(units.UnitOf(cell));
    }
  }
  SortUnique(found);
  return found;
}

/// Returns the narrow units, ascending.
std::vector<Index> FindNarrow(const RefinedGrid& levels, const LabelArray& labels,
  const LabelUnits& units, const std::vector<Index>& mixed, Runtime& runtime)
{
  const CartesianGrid& grid = levels.Finest();
  const IndexBox& box = grid.Local();
  const bool hasCubes = HasCubes(grid);
  const BesideCells beside(grid, labels, units, mixed, runtime);
  std::vector<std::vector<Index>> found(box.Size(1) * box.Size(2));
  ForRows(runtime, box,
    [&](Index j, Index k, Index row)
    {
      found[row] = FindVoidUnits(
        levels, labels, units, { { box.Lower[0], j, k } }, MarkCandidates(box, beside, j, k));
      const auto isWide = [&](Index unit)
      { return !IsNarrow(grid, labels, hasCubes, units.CellsOf(unit)); };
      found[row].erase(
        std::remove_if(found[row].begin(), found[row].end(), isWide), found[row].end());
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
  const CartesianGrid& grid = levels.Finest();
  const LabelUnits units(grid, levels.HasFineInterfaces() ? nullptr : &levels);
  for (Index unit : FindNarrow(levels, labels, units, mixed, runtime))
  {
    this->Add(grid, units.CellsOf(unit));
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
