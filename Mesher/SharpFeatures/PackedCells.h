/**
 * PackedCells: the cells around a node in groups of four, the layout that fits read.
 */
#pragma once

#include "SharpFeatures/FeatureModel.h"

namespace vfm
{

/// How to measure the region inside several surfaces in a cell that all of them cut: exactly, or as
/// the product of the shares inside each, which is several times cheaper.
enum class SharedCells
{
  Exact,
  Product
};

/// Four cells. The last group is filled with cells of width and weight 0, which no plane cuts.
struct alignas(32) FourCells
{
  std::array<std::array<double, 4>, 3> Centre, Width; ///< [axis][cell]
  std::array<double, 4> Fraction, Weight;
};

/// Owns a copy of the cells.
class PackedCells
{
public:
  PackedCells() = default;
  PackedCells(const std::vector<SampleCell>& cells) : Fours((cells.size() + 3) / 4)
  {
    for (std::size_t c = 0; c < cells.size(); ++c)
    {
      FourCells& four = this->Fours[c / 4];
      for (int axis = 0; axis < 3; ++axis)
      {
        four.Centre[axis][c % 4] = cells[c].Centre[axis];
        four.Width[axis][c % 4] = 2.0 * cells[c].Half[axis];
      }
      four.Fraction[c % 4] = cells[c].Fraction;
      four.Weight[c % 4] = cells[c].Weight;
    }
  }

  /// Returns the number of groups.
  std::size_t Count() const { return this->Fours.size(); }
  std::vector<FourCells>::const_iterator begin() const { return this->Fours.begin(); }
  std::vector<FourCells>::const_iterator end() const { return this->Fours.end(); }

private:
  std::vector<FourCells> Fours;
};

} // namespace vfm
