/**
 * PackBytes: packs numbers, texts and lists of both into a message, in order.
 */
#pragma once

#include "Base/IndexBox.h"
#include "Ranks/Ranks.h"

#include <string>
#include <type_traits>

namespace vfm
{

/// Appends values to a message.
class Packer
{
public:
  template <class T>
  void Add(const T& value)
  {
    this->AddMany(&value, 1);
  }
  template <class T>
  void AddMany(const T* values, Index count)
  {
    const char* begin = reinterpret_cast<const char*>(values);
    this->Packed.insert(this->Packed.end(), begin, begin + count * sizeof(T));
  }
  void Add(const std::string& text)
  {
    this->Add(static_cast<Index>(text.size()));
    this->AddMany(text.data(), static_cast<Index>(text.size()));
  }
  template <class T>
  void Add(const std::vector<T>& values)
  {
    const Index count = static_cast<Index>(values.size());
    this->Add(count);
    if constexpr (std::is_trivially_copyable_v<T>)
    {
      this->AddMany(values.data(), count);
    }
    else
    {
      std::for_each(values.begin(), values.end(), [this](const T& value) { this->Add(value); });
    }
  }

  Bytes Packed;
};

/// Reads the values that a Packer added, in the same order.
class Unpacker
{
public:
  /// bytes must outlive this object.
  explicit Unpacker(const Bytes& bytes) : Next(bytes.data()), End(bytes.data() + bytes.size()) {}
  bool IsAtEnd() const { return this->Next == this->End; }

  template <class T>
  T Take()
  {
    T value;
    this->TakeTo(value);
    return value;
  }
  template <class T>
  void TakeTo(T& value)
  {
    std::memcpy(&value, this->Next, sizeof(T));
    this->Next += sizeof(T);
  }
  void TakeTo(std::string& text)
  {
    const auto size = this->Take<Index>();
    text.assign(this->Next, size);
    this->Next += size;
  }
  template <class T>
  void TakeTo(std::vector<T>& values)
  {
    const auto count = this->Take<Index>();
    if constexpr (std::is_trivially_copyable_v<T>)
    {
      values = this->TakeMany<T>(count);
    }
    else
    {
      values.resize(count);
      std::for_each(values.begin(), values.end(), [this](T& value) { this->TakeTo(value); });
    }
  }
  template <class T>
  std::vector<T> TakeMany(Index count)
  {
    std::vector<T> values(count);
    if (count > 0)
    {
      std::memcpy(values.data(), this->Next, count * sizeof(T));
      this->Next += count * sizeof(T);
    }
    return values;
  }

private:
  const char *Next, *End;
};

} // namespace vfm
