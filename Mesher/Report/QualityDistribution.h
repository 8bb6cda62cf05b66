/**
 * QualityDistribution: counts the scaled Jacobians of a mesh in intervals and lists its worst
 * elements.
 */
#pragma once

#include "Base/Vector3.h"
#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

#include <tuple>

namespace vfm
{

/// Numbers of values in intervals of equal width.
struct Histogram
{
  double Lower = 0.0, Upper = 1.0; ///< ends of the first and of the last interval
  std::vector<Index> Counts;       ///< one per interval; empty: the values are not known
};

/// An element and its scaled Jacobian.
struct RatedElement
{
  Index Id = 0; ///< global id
  int Material = 0;
  double Quality = 0.0;
  Vector3 Centroid{}; ///< centroid of the volume
  /// Orders by quality, then by id.
  bool operator<(const RatedElement& other) const
  {
    return std::tie(this->Quality, this->Id) < std::tie(other.Quality, other.Id);
  }
  bool operator==(const RatedElement& other) const
  {
    return std::tie(this->Quality, this->Id) == std::tie(other.Quality, other.Id);
  }
};

struct QualityDistribution
{
  /// Scaled Jacobians: intervals of width 0.05 from 0 to 1, or from -1 if a value is negative.
  Histogram ScaledJacobian;
  std::vector<RatedElement> Worst; ///< ascending by quality, then by id
};

/// Finds the distribution of the element array ScaledJacobian.
/// @param mesh part of this rank
/// @param worst maximum number of elements to list
/// @return equal on all ranks and for any number of ranks; empty lists if no rank has the array
/// @throws InputError if GlobalCellIds or MaterialId is missing; on all ranks
/// @pre Collective
QualityDistribution FindQualityDistribution(const MeshData& mesh, std::size_t worst, Ranks& ranks);

} // namespace vfm
