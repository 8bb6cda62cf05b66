/**
 * How values vary in donors: linearly, with gradients by least squares over the donors around, limited as by Barth and Jespersen (The design
 * and application of upwind schemes on unstructured meshes, AIAA 89-0366, 1989): no part of an element gets what lies outside the
 * values of the donors around.
 *
 * What a donor has in all stays: slopes per volume are about the centroid of its parts. A slope per mass, where density has one too, moves
 * momentum by the product of the two and the second moment of the parts; a shift of the value takes that back exactly.
 */
#pragma once

#include "Transfer/DonorContents.h"
#include "Transfer/DonorParts.h"

namespace vfm
{

/// The slopes in donors whose parts are not all at one place.
class Slopes
{
public:
  /// None: all values are constant in their donors.
  explicit Slopes(const StateColumns& columns) : Columns(columns) {}
  /// Of the donors that this rank owns; copies of those around have their values. Then of copies with parts of this rank's elements.
  /// Collective.
  Slopes(const StateColumns& columns, const CartesianGrid& grid, const DonorTable& donors,
    const DonorValues& values, const std::vector<DonorShape>& shapes, const DonorLinks& links,
    Runtime& runtime);

  /// The values of a donor at a place from its centroid, in place.
  void AddAt(int donor, const Vector3& x, double* values) const
  {
    const int place = this->Places.empty() ? -1 : this->Places[donor];
    if (place < 0)
    {
      return;
    }
    const double* line =
      this->Lines.data() + static_cast<std::size_t>(place) * 4 * this->Columns.Count();
    for (int c = 0; c < this->Columns.Count(); ++c, line += 4)
    {
      values[c] += line[0] * x[0] + line[1] * x[1] + line[2] * x[2] + line[3];
    }
  }

private:
  const StateColumns& Columns;
  std::vector<int> Places;   // of donors in Lines; -1: constant
  std::vector<double> Lines; // of each column a slope and a shift
};

} // namespace vfm
