/**
 * TransferredArray: a state array of the elements or points of a mesh.
 */
#pragma once

#include "Base/Buffer.h"
#include "Input/ValueType.h"

#include <string>
#include <vector>

namespace vfm
{

struct TransferredArray
{
  std::string Name;
  int Type = ValueType::Double; ///< one of ValueType
  int Components = 1;
  std::vector<std::string> ComponentNames; ///< empty, or one per component; "" if unnamed
  bool IsExtensive = false;                ///< true: values are sums over an element
  Buffer<char> Values; ///< shape (tuples, Components), row-major, of type CarrierType(Type)
};

/// Returns the memory of a buffer as bytes, without a copy.
template <class T>
Buffer<char> TakeBytes(Buffer<T>& values)
{
  const std::size_t size = values.size() * sizeof(T);
  return Buffer<char>::From(reinterpret_cast<char*>(values.release()), size);
}

} // namespace vfm
