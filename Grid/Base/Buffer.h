/**
 * Buffer: an array of plain data whose memory VTK can adopt without a copy.
 */
#pragma once

#include "Base/Memory.h"

#include <type_traits>
#include <utility>

namespace vfm
{

/// Array of trivially copyable values. It owns its memory, which comes from AllocateBytes and is
/// freed by std::free. It can be moved, not copied.
template <class T>
class Buffer
{
  static_assert(std::is_trivially_copyable<T>::value, "Buffer holds plain data");

public:
  Buffer() = default;
  /// Allocates `size` values without initialising them.
  /// @throws std::bad_alloc  if there is not enough memory
  explicit Buffer(std::size_t size) :
    Data(static_cast<T*>(AllocateBytes(size * sizeof(T)))), Size(size)
  {
  }
  Buffer(std::size_t size, T value) : Buffer(size)
  {
    for (T& item : *this)
    {
      item = value;
    }
  }
  Buffer(Buffer&& other) noexcept { this->swap(other); }
  Buffer& operator=(Buffer&& other) noexcept
  {
    Buffer(std::move(other)).swap(*this);
    return *this;
  }
  ~Buffer() { std::free(this->Data); }

  /// Returns a buffer that owns the given memory, for instance the result of release().
  static Buffer From(T* data, std::size_t size)
  {
    Buffer buffer;
    buffer.Data = data;
    buffer.Size = size;
    return buffer;
  }

  void swap(Buffer& other) noexcept
  {
    std::swap(this->Data, other.Data);
    std::swap(this->Size, other.Size);
  }

  /// Returns the memory and leaves the buffer empty. The caller frees the memory by std::free.
  T* release()
  {
    this->Size = 0;
    return std::exchange(this->Data, nullptr);
  }

  T* data() { return this->Data; }
  const T* data() const { return this->Data; }
  std::size_t size() const { return this->Size; }
  bool empty() const { return this->Size == 0; }
  T& operator[](std::size_t i) { return this->Data[i]; }
  const T& operator[](std::size_t i) const { return this->Data[i]; }
  T* begin() { return this->Data; }
  T* end() { return this->Data + this->Size; }
  const T* begin() const { return this->Data; }
  const T* end() const { return this->Data + this->Size; }

private:
  T* Data = nullptr;
  std::size_t Size = 0;
};

} // namespace vfm
