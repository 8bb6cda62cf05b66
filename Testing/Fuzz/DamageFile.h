/**
 * Random damage to the bytes of a file.
 */
#pragma once

#include "RandomDraw.h"

#include <string>

namespace vfm
{
namespace testing
{

/// Flips bytes, replaces numbers, or cuts off, removes, inserts or repeats parts; once or a few
/// times. Returns a description of the damage.
std::string DamageBytes(std::string& bytes, RandomDraw& draw);

} // namespace testing
} // namespace vfm
