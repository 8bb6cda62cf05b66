/**
 * Checks of all guarantees for the mesh of a random case.
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
};

/// Makes the mesh of a case on one rank and on the ranks of the case.
FuzzResult CheckCase(const FuzzCase& c);

} // namespace testing
} // namespace vfm
