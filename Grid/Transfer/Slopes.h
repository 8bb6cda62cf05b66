/**
 * Slopes: linear reconstruction of values in donors. Gradients are found by least squares over the
 * donors around. They are limited as by T. J. Barth and D. C. Jespersen, The design and application
 * of upwind schemes on unstructured meshes, AIAA 89-0366, 1989. No part of an element gets a value
 * outside the range of the donors around.
 *
 * The contents of a donor are conserved. Slopes per volume are relative to the centroid of its
 * parts. If both density and a value per mass have slopes, their product with the second moment of
 * the parts would change the content. A shift of the value compensates this exactly.
 */
#pragma once

#include "Transfer/DonorContents.h"
#include "Transfer/DonorParts.h"

namespace vfm
{

/// Slopes of the donors whose parts are not all at one position. The columns must outlive it.
class Slopes
{
public:
  /// Makes all values constant in their donors.
  explicit Slopes(const StateColumns& columns) : Columns(columns) {}
  /// Finds the slopes of owned donors, and receives the slopes of copies.
  /// @param donors,values  donors and their values; copies around owned donors must be up to date
  /// @param shapes  shapes of owned donors, after CentreShapes
  /// @param links  links of the copies that have parts of elements of this rank
  /// @pre Collective among peers.
  Slopes(const StateColumns& columns, const CartesianGrid& grid, const DonorTable& donors,
    const DonorValues& values, const std::vector<DonorShape>& shapes, const DonorLinks& links,
    Runtime& runtime);

  /// Finds the values of a donor at a position.
  /// @param x  position relative to the centroid of the donor
  /// @param own  values at the centroid, one per column
  /// @param[out] values  values at the position
  void Evaluate(int donor, const Vector3& x, const double* own, double* values) const
  {
    const int place = this->Places.empty() ? -1 : this->Places[donor];
    const int count = this->Columns.Count();
    if (place < 0)
    {
      std::copy_n(own, count, values);
      return;
    }
    const double* line = this->Lines.data() + static_cast<std::size_t>(place) * 4 * count;
    for (int c = 0; c < count; ++c, line += 4)
    {
      values[c] = own[c] + (line[0] * x[0] + line[1] * x[1] + line[2] * x[2] + line[3]);
    }
  }

private:
  const StateColumns& Columns;
  std::vector<int> Places;   // position of each donor in Lines; -1 if it is constant
  std::vector<double> Lines; // slope and shift of each column, per donor
};

} // namespace vfm
