/**
 * TypedValues: values that a reader returns, of a type known at run time.
 */
#pragma once

#include "Base/Buffer.h"
#include "Base/IndexBox.h"
#include "Input/ValueType.h"

#include <string>

namespace vfm
{

struct TypedValues
{
  std::string Name;
  int Type = ValueType::Int; ///< of ValueType
  Buffer<char> Bytes;        ///< value by value, x fastest, in the byte order of this machine
};

inline TypedValues MakeValues(const std::string& name, int type, Index count)
{
  return { name, type, Buffer<char>(count * WidthOfType(type)) };
}

} // namespace vfm
