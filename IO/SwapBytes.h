/**
 * SwapBytes: values in the other order of bytes.
 */
#pragma once

#include <algorithm>
#include <cstring>

namespace vfm
{

template <class Value>
Value SwapBytes(Value value)
{
  char bytes[sizeof(Value)];
  std::memcpy(bytes, &value, sizeof(Value));
  std::reverse(bytes, bytes + sizeof(Value));
  std::memcpy(&value, bytes, sizeof(Value));
  return value;
}

/// Whether this machine stores the least byte first.
inline bool IsLittleEndian()
{
  const short one = 1;
  char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

} // namespace vfm
