/**
 * PackedCells: the cells around a node, four side by side, as fits take them.
 */
#pragma once

#include "SharpFeatures/FeatureModel.h"

namespace vfm
{

/// What is inside of several surfaces in a cell that they all cut: exactly, or as the product of what is inside of each, which costs a fraction.
enum class SharedCells
{
  Exact,
  Product
};

/// Missing cells are of width and weight 0: no plane cuts them.
struct alignas(32) FourCells
{
  std::array<std::array<double, 4>, 3> Centre, Width; ///< by axis
  std::array<double, 4> Fraction, Weight;
};

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

  std::size_t Count() const { return this->Fours.size(); }
  std::vector<FourCells>::const_iterator begin() const { return this->Fours.begin(); }
  std::vector<FourCells>::const_iterator end() const { return this->Fours.end(); }

private:
  std::vector<FourCells> Fours;
};

} // namespace vfm
