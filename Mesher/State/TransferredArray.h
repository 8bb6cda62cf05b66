/**
 * TransferredArray: values of the input that the elements or points of a mesh have.
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
  int Type = ValueType::Double; ///< of ValueType
  int Components = 1;
  std::vector<std::string> ComponentNames; ///< empty, or one a component, "" where it has none
  Buffer<char> Values; ///< tuple by tuple, in the type in which they travel (CarrierType)
};

/// The same memory, whatever it holds.
template <class T>
Buffer<char> TakeBytes(Buffer<T>& values)
{
  const std::size_t size = values.size() * sizeof(T);
  return Buffer<char>::From(reinterpret_cast<char*>(values.release()), size);
}

} // namespace vfm
