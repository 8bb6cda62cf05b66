/**
 * TypedValues: an array that a reader returns, of a type known at run time.
 */
#pragma once

#include "Base/Buffer.h"
#include "Base/IndexBox.h"
#include "Input/ValueType.h"

#include <string>

namespace vfm
{

/// Named array of values of a type known at run time.
struct TypedValues
{
  std::string Name;
  int Type = ValueType::Int; ///< one of ValueType
  Buffer<char> Bytes;        ///< all values, x fastest, in the byte order of this machine
};

/// Allocates an array of `count` values of a ValueType, without initialising them.
inline TypedValues MakeValues(const std::string& name, int type, Index count)
{
  return { name, type, Buffer<char>(count * WidthOfType(type)) };
}

} // namespace vfm
