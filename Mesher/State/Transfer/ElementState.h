/**
 * ElementStates: the state of elements, summed over their parts. A part gets its contents from
 * linear values in its donor (Slopes.h).
 */
#pragma once

#include "State/Transfer/StateColumns.h"

#include <vector>

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

/// Sums the parts of some elements at a time. The columns must outlive it.
class ElementStates
{
public:
  explicit ElementStates(const StateColumns& columns);

  /// Removes all elements.
  void Clear();
  /// Begins the next element.
  void Start() { this->Firsts.push_back(static_cast<int>(this->Parts.size())); }
  /// Adds a part to the last element.
  void Add(const StatePart& part) { this->Parts.push_back(part); }
  /// Returns the number of elements.
  std::size_t Count() const { return this->Firsts.size(); }
  /// Finds the values of the elements from their parts.
  void Finish();
  /// Returns the values of an element, one per column, after Finish.
  const double* Values(std::size_t i) const
  {
    return this->Found.data() + i * this->Columns.Width();
  }
  double Mass(std::size_t i) const { return this->Weights[i * this->Bases.size() + 1]; }

private:
  int FindSlot(int base);
  void Sum();
  template <int Groups>
  void SumFew();
  void SumMany();
  void SumElement(const StatePart* first, const StatePart* end, double* weights, double* found);
  double FindMean(std::size_t i, int column) const;

  const StateColumns& Columns;
  std::vector<StatePart> Parts;  // of the elements one after another
  std::vector<int> Firsts;       // first part of each element; after Finish, also the end
  std::vector<int> Slots;        // position of the base of each column in Bases, 0 up to Width()
  std::vector<int> Bases;        // columns that are bases: -1 for volume, density, then weights
  std::vector<double> IsPerMass; // per column, -1 if its base is density, else 0
  std::vector<double> Factors;   // contents of the bases, per part of one element
  std::vector<double> Weights;   // per element, contents of the bases; of volume, its own volume
  std::vector<double> Found;     // per element, Width() numbers
};

} // namespace vfm
