/**
 * Everything that is promised of a mesh, checked in a random case.
 */
#pragma once

#include "FuzzCase.h"

namespace vfm
{
namespace testing
{

struct FuzzResult
{
  std::string Problem; ///< "" or what is wrong
  Index Elements = 0;
  double Coefficient = 1e300;    ///< smallest of the elements' Jacobians, in volumes of their cells
  double ScaledJacobian = 1e300; ///< smallest
  double Overlap =
    0.0; ///< deepest: nothing keeps fragments apart where the void between is not meshed
};

/// Makes the mesh of a case on one rank and on its ranks.
FuzzResult CheckCase(const FuzzCase& c);

} // namespace testing
} // namespace vfm
