/**
 * NumpyFields: makes numpy arrays from buffers of a mesh without copies; numpy then owns
 * the memory.
 */
#pragma once

#include "Base/Buffer.h"
#include "Report/MeshFields.h"
#include "State/TransferredArray.h"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

namespace vfm
{

/// Returns an array of shape (n,), or (n, columns) if columns > 0; values is empty afterwards.
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

/// Returns rows of three numbers as an array of shape (n, 3).
template <class T, class Row>
nanobind::object RowsToNumpy(const std::vector<Row>& rows)
{
  Buffer<T> values(3 * rows.size());
  for (std::size_t r = 0; r < rows.size(); ++r)
  {
    std::copy(rows[r].begin(), rows[r].end(), values.data() + 3 * r);
  }
  return ToNumpy(values, 3);
}

/// Returns integers as an array of shape (n,).
inline nanobind::object NumbersToNumpy(const std::vector<int>& numbers)
{
  Buffer<std::int32_t> values(numbers.size());
  std::copy(numbers.begin(), numbers.end(), values.data());
  return ToNumpy(values);
}

/// Returns an array of the same type, of shape (n,) or (n, Components); the values are then empty.
nanobind::object ToNumpy(TransferredArray& array);

/// Returns numpy arrays, or lists of texts, by name.
nanobind::dict ToDict(const FieldArrays& fields);

} // namespace vfm
