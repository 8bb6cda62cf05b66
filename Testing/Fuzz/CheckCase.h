/**
 * Checks of all guarantees for the mesh of a case.
 */
#pragma once

#include "FuzzCase.h"

namespace vfm
{
namespace testing
{

struct FuzzResult
{
  std::string Problem; ///< empty, or the first problem
  Index Elements = 0;
  /// smallest Jacobian determinant of any element, in volumes of its cells
  double Coefficient = 1e300;
  double ScaledJacobian = 1e300; ///< smallest of all elements
  double Overlap = 0.0;          ///< ElementOverlaps::Depth
  Index Locked = 0;              ///< CountLocked
  MeshReport Report;             ///< of the mesh on one rank
};

using Cuts = std::vector<std::vector<IndexBox>>; ///< boxes of the ranks of each run

/// Makes the mesh of a case on one rank, and on the ranks of the case or of each cut.
FuzzResult CheckCase(const FuzzCase& c);
FuzzResult CheckCase(const FuzzCase& c, const Cuts& cuts);

} // namespace testing
} // namespace vfm
