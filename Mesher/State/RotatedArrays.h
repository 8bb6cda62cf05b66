/**
 * RotatedArrays: state arrays of vectors and tensors along the axes of an image, which are rotated
 * to world coordinates with the mesh.
 */
#pragma once

#include "State/StatePlan.h"

namespace vfm
{

/// Marks the arrays that the option RotatedArrays names.
/// @param names  state arrays, or arrays of the mesh that are made of several; of several arrays,
/// any one stands for all
/// @param plan,states  arrays to mark: conserved arrays of the plan, and states that it copies
/// @throws InputError if a name is not of a state array, or if the array is neither a vector nor a
/// tensor, or would be copied as integers
void MarkRotated(
  const std::vector<std::string>& names, StatePlan& plan, std::vector<StateArray>& states);

} // namespace vfm
