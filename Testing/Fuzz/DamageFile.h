/**
 * Damage done to the bytes of a file, at random.
 */
#pragma once

#include "RandomDraw.h"

#include <string>

namespace vfm
{
namespace testing
{

/// Bytes flipped, numbers replaced, parts cut off, taken out, put in or repeated; once or a few
/// times. Returns what was done.
std::string DamageBytes(std::string& bytes, RandomDraw& draw);

} // namespace testing
} // namespace vfm
