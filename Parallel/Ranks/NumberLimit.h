/**
 * NumberLimit: refuses more things of a mesh than its numbers can hold.
 */
#pragma once

#include "Ranks/Errors.h"

#include <limits>

namespace vfm
{

/// Throws an InputError (TooLarge) if things cannot be numbered from 1 with 32 bits. A check of a
/// number that all ranks know, so all throw.
/// @param things  plural, such as "fragments"
inline void CheckNumberLimit(std::int64_t count, const char* things)
{
  constexpr std::int64_t largest = std::numeric_limits<int>::max();
  if (count > largest)
  {
    throw InputError(ErrorCode::TooLarge,
      "The mesh has " + std::to_string(count) + " " + things + ", but at most " +
        std::to_string(largest) + " can be numbered. Mesh parts of the input one after the other.");
  }
}

} // namespace vfm
