/**
 * Hdf5Bytes: parts of an HDF5 file, and numbers in them. All numbers are little-endian.
 */
#pragma once

#include "OpenFile.h"

#include <cstdint>
#include <string>
#include <utility>

namespace vfm
{

[[noreturn]] inline void RejectHdf5(const std::string& what)
{
  throw InputError("it is not an HDF5 file, or it is damaged: " + what + ".");
}

/// Part of a file.
class Hdf5Bytes
{
public:
  explicit Hdf5Bytes(std::string bytes) : Bytes(std::move(bytes)) {}

  std::size_t Size() const { return this->Bytes.size(); }
  /// Returns an unsigned number of `width` bytes.
  /// @throws InputError  if it is not inside
  std::uint64_t Number(std::size_t at, int width) const
  {
    this->Require(at, static_cast<std::uint64_t>(width));
    std::uint64_t number = 0;
    for (int i = width; i-- > 0;)
    {
      number = number << 8 | static_cast<unsigned char>(this->Bytes[at + i]);
    }
    return number;
  }
  /// Returns a part of the part.
  /// @throws InputError  if it is not inside
  Hdf5Bytes Part(std::size_t at, std::uint64_t count) const
  {
    this->Require(at, count);
    return Hdf5Bytes(this->Bytes.substr(at, count));
  }
  bool BeginsWith(const std::string& text) const
  {
    return this->Bytes.compare(0, text.size(), text) == 0;
  }
  /// Returns whether a text begins at a place and ends with a zero inside.
  bool HasText(std::uint64_t at) const
  {
    return at < this->Size() && this->Bytes.find('\0', at) != std::string::npos;
  }

private:
  void Require(std::size_t at, std::uint64_t count) const
  {
    if (at > this->Size() || count > this->Size() - at)
    {
      RejectHdf5("an entry is longer than its place");
    }
  }

  std::string Bytes;
};

/// File from which parts are read.
class Hdf5Stream
{
public:
  /// @throws InputError  if the file has no signature of HDF5
  explicit Hdf5Stream(const std::string& path) :
    Stream(OpenFile(path)),
    Length(static_cast<std::uint64_t>(GetFileLength(path))),
    Left(static_cast<Index>(4 * this->Length + 4096))
  {
    const std::string signature = "\x89HDF\r\n\x1a\n";
    std::uint64_t start = 0; // the signature may follow other data, at 512 or twice of it
    while (start + signature.size() <= this->Length &&
      !this->Read(start, signature.size()).BeginsWith(signature))
    {
      start = start == 0 ? 512 : 2 * start;
    }
    this->Start = start;
    if (start + signature.size() > this->Length)
    {
      RejectHdf5("it has no signature");
    }
  }

  /// Reads a part.
  /// @param address  place behind the signature's
  /// @throws InputError  if it is not inside the file
  Hdf5Bytes Read(std::uint64_t address, std::uint64_t count)
  {
    const std::uint64_t most = this->Length - this->Start;
    if (address > most || count > most - address)
    {
      RejectHdf5("an address is behind its end");
    }
    this->Left -= static_cast<Index>(count);
    if (this->Left < 0)
    {
      RejectHdf5("its parts overlap");
    }
    std::string bytes(count, '\0');
    this->Stream.clear();
    this->Stream.seekg(static_cast<std::streamoff>(this->Start + address));
    this->Stream.read(bytes.data(), static_cast<std::streamsize>(count));
    return Hdf5Bytes(std::move(bytes));
  }

private:
  std::ifstream Stream;
  std::uint64_t Length, Start = 0;
  Index Left; // bytes that may still be read; parts of an intact file do not overlap
};

} // namespace vfm
