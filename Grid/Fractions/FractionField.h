/**
 * FractionField: volume fractions of all materials in every cell of the local box, stored sparsely.
 * A cell filled by one material (or void) stores a label. A mixed cell stores a short list of pairs
 * (material, fraction). So a thousand grains do not need a thousand arrays.
 *
 * Materials are numbered 1..N, void is 0. The fractions of a cell, void included, sum to 1.
 */
#pragma once

#include "Base/PagedArray.h"

#include <string>

namespace vfm
{

/// Largest distance of a fraction from [0,1] that counts as rounding.
constexpr double FractionTolerance = 1e-6;
/// Largest tolerance that a user may set.
constexpr double LargestFractionTolerance = 0.1;

/// Excess of a sum of fractions over 1 that is always accepted; the sum is scaled to 1.
constexpr double SumTolerance = 1e-3;

/// Fractions of the cells of a grid, owned and ghost, by linear index. Owns its data. Several
/// threads may read it; none may write at the same time.
class FractionField
{
public:
  struct Part
  {
    int Material;
    double Fraction;
  };
  struct Range
  {
    const Part* First;
    const Part* Last;
    Range(const Part* first, const Part* last) : First(first), Last(last) {}
    Range(const std::vector<Part>& parts) : Range(parts.data(), parts.data() + parts.size()) {}
    const Part* begin() const { return this->First; }
    const Part* end() const { return this->Last; }
  };

  /// Makes every cell void.
  FractionField(const CartesianGrid& grid, int numberOfMaterials);

  /// Source of fractions, with one array per material.
  class Reader
  {
  public:
    virtual ~Reader() = default;
    /// Reads the fractions of one material in a row of cells along x.
    /// @param material  1 to N
    /// @param first  position of the first cell
    /// @param count  number of cells
    /// @param[out] values  fractions of the cells, `count` numbers
    virtual void Read(int material, const Index3& first, Index count, double* values) const = 0;
    /// Returns the largest error by which the number type of a material's array may round a
    /// fraction up.
    virtual double Rounding(int /*material*/) const { return 0.0; }
    /// Returns the largest accepted distance of a value from [0,1].
    virtual double Tolerance() const { return FractionTolerance; }
    /// Returns the name of the array of a material, for messages.
    virtual std::string Name(int material) const = 0;
  };
  /// Reads the fractions of all cells of the local box. A fraction outside [0,1] is clipped if its
  /// distance is at most the tolerance. Cells with distances above 1e-6 are counted
  /// (NumberOfClippedCells). Sums above 1 are scaled to 1. Cells whose sum exceeds 1 by more than
  /// rounding are counted (NumberOfNormalisedCells).
  /// @throws InputError  only on the rank that holds the cell, if
  /// - a fraction is not finite, or its distance from [0,1] exceeds the tolerance
  /// - a sum exceeds 1 by more than 1e-3, and by more than the tolerance plus all Rounding()
  static FractionField FromReader(const CartesianGrid& grid, int numberOfMaterials, const Reader&);

  int NumberOfMaterials() const { return this->Materials; }
  /// Returns the number of owned cells whose sum exceeded 1 by more than rounding.
  Index NumberOfNormalisedCells() const { return this->Normalised; }
  /// Returns the number of owned cells with a fraction outside [0,1] by more than rounding.
  Index NumberOfClippedCells() const { return this->Clipped; }

  void SetLabel(Index cell, int label) { this->Entry.Set(cell, label); }
  /// Sets the materials of a cell; void fills the rest. A sum above 1 is scaled to 1.
  /// @param parts  distinct materials >= 1, ascending, with fractions > 0
  void SetParts(Index cell, const std::vector<Part>& parts);

  /// Sets the parts of a cell as given, without scaling.
  /// @param parts  Parts() of another field, void included; a single part sets a label
  void CopyParts(Index cell, Range parts);
  /// Copies a cell of another field.
  void CopyCell(Index cell, const FractionField& from, Index other);

  /// Sets the cells of a row one after another, faster and in less memory than SetLabel and
  /// SetParts. At the ends of a row, a cell of the layer around the local box may get the label of
  /// its neighbour, so that a row of one label remains one run.
  class RowWriter
  {
  public:
    explicit RowWriter(FractionField& field) : Field(field) {}
    /// Starts a row.
    /// @param first  linear index of the first cell that is set
    void Start(Index first);
    void AddLabel(int label, Index count = 1);
    /// AddParts adds a cell like SetParts; CopyParts and CopyCell add a cell like the functions of
    /// the same names above.
    void AddParts(const std::vector<Part>& parts);
    void CopyParts(Range parts);
    void CopyCell(const FractionField& from, Index other);
    /// Writes the remaining cells; must be called after the last cell.
    void Finish();

  private:
    FractionField& Field;
    Index First = 0;
    std::vector<int> Entries; // entries of the cells from First on
  };

  bool IsMixed(Index cell) const { return this->Entry[cell] < 0; }
  /// Returns the label of a cell that is not mixed.
  int Label(Index cell) const { return this->Entry[cell]; }
  /// Returns the parts of a mixed cell in the order of their materials, void first if present.
  Range Parts(Index cell) const
  {
    const Index m = ~static_cast<Index>(this->Entry[cell]);
    return { this->List.data() + this->Offset[m], this->List.data() + this->Offset[m + 1] };
  }
  /// Calls visit(material, fraction) for each part of a cell, once for a pure cell.
  template <class Visitor>
  void ForParts(Index cell, const Visitor& visit) const
  {
    if (!this->IsMixed(cell))
    {
      visit(this->Label(cell), 1.0);
      return;
    }
    for (const Part& part : this->Parts(cell))
    {
      visit(part.Material, part.Fraction);
    }
  }
  double Fraction(Index cell, int material) const
  {
    return this->IsMixed(cell) ? FractionOf(this->Parts(cell), material)
                               : (this->Label(cell) == material ? 1.0 : 0.0);
  }
  /// Returns the fraction of a material among some parts, or 0.
  static double FractionOf(Range parts, int material)
  {
    for (const Part& part : parts)
    {
      if (part.Material == material)
      {
        return part.Fraction;
      }
    }
    return 0.0;
  }
  /// Visits the cells [first, last) of a row in order. Calls pure(begin, end, label) for runs of
  /// one label, and each(begin, end) for all other ranges. The latter may also contain pure cells.
  template <class Pure, class Each>
  void Visit(Index first, Index last, const Pure& pure, const Each& each) const
  {
    this->Entry.Visit(
      first, last,
      [&](Index begin, Index end, int entry)
      {
        if (entry >= 0)
        {
          pure(begin, end, entry);
          return;
        }
        each(begin, end);
      },
      [&](Index begin, Index end, const int*) { each(begin, end); });
  }
  /// Visits the cells [first, last) of a row in order: run(begin, end, label) for runs of one
  /// label, with label -1 for a single mixed cell.
  template <class Run>
  void VisitRuns(Index first, Index last, const Run& run) const
  {
    this->Visit(first, last, run,
      [&](Index begin, Index end)
      {
        for (Index cell = begin; cell < end; ++cell)
        {
          run(cell, cell + 1, this->IsMixed(cell) ? -1 : this->Label(cell));
        }
      });
  }
  std::size_t MemoryInBytes() const;

private:
  int StoreParts(const std::vector<Part>& parts);
  int StoreCopy(Range parts);
  int CloseParts();

  int Materials;
  Index Normalised = 0, Clipped = 0;
  PagedArray<int> Entry;     // label >= 0, or ~(index of the mixed cell)
  std::vector<Index> Offset; // mixed cells + 1
  std::vector<Part> List;
};

/// Returns the label of a mixed cell: void if the materials fill less than isoValue, else the
/// material with the largest fraction, the smaller number on a tie.
/// @param parts  sorted by material
int MaterialOfParts(FractionField::Range parts, double isoValue);

/// Returns the label of a cell, pure or mixed.
inline int MaterialOfCell(const FractionField& fractions, Index cell, double isoValue)
{
  return fractions.IsMixed(cell) ? MaterialOfParts(fractions.Parts(cell), isoValue)
                                 : fractions.Label(cell);
}

} // namespace vfm
