/**
 * FractionField: the volume fractions of all materials in every cell of the local box, stored sparsely.
 * A cell filled by one material (or void) is a label; a mixed cell has a short list of (material,
 * fraction), so a thousand grains cost no thousand arrays.
 *
 * Materials are numbered 1..N, void is 0. The fractions of a cell, void included, sum to 1.
 */
#pragma once

#include "Base/PagedArray.h"

#include <string>

namespace vfm
{

/// Fractions may lie so far outside [0,1] by rounding.
constexpr double FractionTolerance = 1e-6;
/// No user may allow more.
constexpr double LargestFractionTolerance = 0.1;

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

  /// Every cell void.
  FractionField(const CartesianGrid& grid, int numberOfMaterials);

  /// Fractions given one array a material. Reader has
  ///   void Read(int material, Index3 first, Index count, double* values)
  /// which fills the fractions of material 1..N in count cells along x.
  /// Fractions outside [0,1] by no more than the tolerance are clipped, and counted where by more than 1e-6. Sums above 1 are
  /// normalised, and counted where rounding does not explain them. Throws InputError on NaN or infinity, values farther outside,
  /// sums above 1 by more than 1e-3, by more than the tolerance and by more than the rounding of all materials.
  class Reader
  {
  public:
    virtual ~Reader() = default;
    virtual void Read(int material, const Index3& first, Index count, double* values) const = 0;
    /// How far the type that stores the fractions of a material may have rounded one of them up.
    virtual double Rounding(int /*material*/) const { return 0.0; }
    /// How far outside [0,1] values may lie.
    virtual double Tolerance() const { return FractionTolerance; }
    /// For messages.
    virtual std::string Name(int material) const = 0;
  };
  static FractionField FromReader(const CartesianGrid& grid, int numberOfMaterials, const Reader&);

  int NumberOfMaterials() const { return this->Materials; }
  /// Owned cells whose sum exceeded 1 by more than rounding explains, and was scaled back.
  Index NumberOfNormalisedCells() const { return this->Normalised; }
  /// Owned cells where a fraction lay outside [0,1] by more than rounding explains, and was clipped.
  Index NumberOfClippedCells() const { return this->Clipped; }

  void SetLabel(Index cell, int label) { this->Entry.Set(cell, label); }
  /// parts: fractions of distinct materials >= 1, each > 0, sum <= 1 but for rounding.
  void SetParts(Index cell, const std::vector<Part>& parts);

  /// The parts of a cell as Parts() of another field has them, void included: nothing is normalised. Of one part its label.
  void CopyParts(Index cell, Range parts);
  /// What a cell of another field holds.
  void CopyCell(Index cell, const FractionField& from, Index other);

  /// Sets cells of a row one after the other, faster and in less memory than cell by cell. The layer around the local box
  /// may get the labels of the cells beside it, so that rows of one label stay alike.
  class RowWriter
  {
  public:
    explicit RowWriter(FractionField& field) : Field(field) {}
    /// first: the first cell.
    void Start(Index first);
    void AddLabel(int label, Index count = 1);
    /// Like SetParts and CopyParts.
    void AddParts(const std::vector<Part>& parts);
    void CopyParts(Range parts);
    void CopyCell(const FractionField& from, Index other);
    /// To be called after the last cell.
    void Finish();

  private:
    FractionField& Field;
    Index First = 0;
    std::vector<int> Entries; // of the cells from First
  };

  bool IsMixed(Index cell) const { return this->Entry[cell] < 0; }
  /// The label of a cell that is not mixed.
  int Label(Index cell) const { return this->Entry[cell]; }
  /// The parts of a mixed cell in the order of their materials, void first when present.
  Range Parts(Index cell) const
  {
    const Index m = ~static_cast<Index>(this->Entry[cell]);
    return { this->List.data() + this->Offset[m], this->List.data() + this->Offset[m + 1] };
  }
  /// Calls visit(material, fraction) for what a cell holds, of a pure one once.
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
  /// Of a material among some parts.
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
  /// Visits the cells [first, last) of a row in order: pure(begin, end, label) for some of the same label, each(begin, end)
  /// for others.
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
  /// The same as run(begin, end, label); label -1: one cell of several parts.
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

/// The label of a mixed cell: void where the materials fill less than isoValue, else the material of the largest fraction,
/// ties to the smaller. parts: in the order of their materials.
int MaterialOfParts(FractionField::Range parts, double isoValue);

/// The label of a cell, of a pure one its own.
inline int MaterialOfCell(const FractionField& fractions, Index cell, double isoValue)
{
  return fractions.IsMixed(cell) ? MaterialOfParts(fractions.Parts(cell), isoValue)
                                 : fractions.Label(cell);
}

} // namespace vfm
