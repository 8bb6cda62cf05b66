/**
 * ElementState: the state of an element, summed over its parts. A part gets its contents from
 * linear values in its donor (Slopes.h).
 */
#pragma once

#include "State/Transfer/StateColumns.h"

namespace vfm
{

/// Part of an element, with the values that it gets its contents from.
struct StatePart
{
  const double* Own;  ///< values at the origin, StateColumns::Width() numbers
  const double* Line; ///< slopes along x, y, z and shifts, four lists like Own
  Vector3 X;          ///< position relative to the origin
  double Inside;      ///< volume of the element in the part
  double Volume;      ///< volume of the material that the part receives, equal up to rounding
};

/// Sums the parts of elements, one element after another. The columns must outlive it.
class ElementState
{
public:
  explicit ElementState(const StateColumns& columns);

  /// Begins an element.
  void Start() { this->Parts.clear(); }
  void Add(const StatePart& part) { this->Parts.push_back(part); }
  /// Finds the values of the element from its parts.
  void Finish();
  /// Returns the values, one per column, after Finish.
  const double* Values() const { return this->Found.data(); }
  double Mass() const { return this->Factors[1]; }

private:
  int FindSlot(int base);
  bool Sum();
  void FindMean(int column);

  const StateColumns& Columns;
  std::vector<StatePart> Parts;
  std::vector<int> Slots; // position of the base of each column in Bases, 0 up to Width()
  std::vector<int> Bases; // columns that are bases: -1 for volume, density, then weights
  // Contents of the bases: in the element, where that of volume is its own volume, then per part.
  std::vector<double> Factors;
  std::vector<double> Found;
};

} // namespace vfm
