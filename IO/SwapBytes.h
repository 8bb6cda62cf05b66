/**
 * SwapBytes: reverses the byte order of values.
 */
#pragma once

#include <algorithm>
#include <cstring>

namespace vfm
{

/// Returns a value with its bytes in reverse order.
template <class Value>
Value SwapBytes(Value value)
{
  char bytes[sizeof(Value)];
  std::memcpy(bytes, &value, sizeof(Value));
  std::reverse(bytes, bytes + sizeof(Value));
  std::memcpy(&value, bytes, sizeof(Value));
  return value;
}

/// Returns whether this machine stores the least significant byte first.
inline bool IsLittleEndian()
{
  const short one = 1;
  char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

} // namespace vfm
