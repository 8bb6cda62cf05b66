/**
 * ReadNumbers: reads the values of an image that are stored as text.
 */
#pragma once

#include "Images/StoredValues.h"

namespace vfm
{

/// Reads numbers separated by white space. Integers may be written as real numbers, such as 2.0.
/// @param stored  one file, not compressed
/// @throws InputError  if there are too few numbers, or if one is not of the type or out of its
///   range; the message contains its place among the values, from 1, and its text
TypedValues ReadNumbers(const StoredValues& stored, Index count);

} // namespace vfm
