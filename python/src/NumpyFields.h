/**
 * NumpyFields: memory of a mesh as arrays of numpy, which own it from then on: nothing is copied.
 */
#pragma once

#include "Base/Buffer.h"
#include "State/TransferredArray.h"
#include "Summary/MeshFields.h"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

namespace vfm
{

/// An array of shape (n,), or of rows of so many columns; values is empty after.
template <class T>
nanobind::object ToNumpy(Buffer<T>& values, int columns = 0)
{
  namespace nb = nanobind;
  const std::size_t rows = columns > 0 ? values.size() / columns : values.size();
  if (!values.data())
  {
    values = Buffer<T>(0); // a capsule cannot hold null
  }
  T* data = values.data();
  nb::capsule owner(data, [](void* memory) noexcept { std::free(memory); });
  values.release();
  const std::size_t shape[2] = { rows, static_cast<std::size_t>(columns) };
  return nb::cast(nb::ndarray<nb::numpy, T>(data, columns > 0 ? 2 : 1, shape, owner));
}

/// In the type of the array, a row a tuple where it has several components.
nanobind::object ToNumpy(TransferredArray& array);

/// By name: arrays of numpy, or lists of texts.
nanobind::dict ToDict(const FieldArrays& fields);

} // namespace vfm
