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

#include "State/Transfer/DonorContents.h"
#include "State/Transfer/DonorParts.h"

namespace vfm
{

/// Slopes of the donors whose parts are not all at one position.
class Slopes
{
public:
  /// Makes all values constant in their donors.
  explicit Slopes(const StateColumns& columns) : Width(4 * columns.Width()), Zeros(this->Width, 0.0)
  {
  }
  /// Finds the slopes of owned donors, and receives the slopes of copies.
  /// @param donors,values  donors and their values; copies around owned donors must be up to date
  /// @param shapes  shapes of owned donors, after CentreShapes
  /// @param links  links of the copies that have parts of elements of this rank
  /// @pre Collective among peers.
  Slopes(const StateColumns& columns, const CartesianGrid& grid, const DonorTable& donors,
    const DonorValues& values, const DonorShapes& shapes, const DonorLinks& links,
    Runtime& runtime);

  /// Returns the slopes of a donor relative to its centroid: StatePart::Line.
  const double* LineOf(int donor) const
  {
    const int place = this->Places.empty() ? -1 : this->Places[donor];
    return place < 0 ? this->Zeros.data()
                     : this->Lines.data() + static_cast<std::size_t>(place) * this->Width;
  }

private:
  const int Width;
  const std::vector<double> Zeros; // slopes of constant donors
  std::vector<int> Places;         // position of each donor in Lines; -1 if it is constant
  std::vector<double> Lines;       // Width numbers per donor
};

} // namespace vfm
