/**
 * PlotfileText: reads words and numbers of the text files of an AMReX plotfile.
 */
#pragma once

#include "Base/IndexBox.h"
#include "CellCount.h"
#include "OpenFile.h"
#include "ReadLine.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iomanip>
#include <string>

namespace vfm
{

/// Text of a plotfile, read item by item. Each function takes a description of the expected item.
/// @throws InputError  if another item is found; the message contains the path and the description
class PlotfileText
{
public:
  explicit PlotfileText(const std::string& path) : Path(path)
  {
    PrefixErrors(path + " cannot be read: ", [&] { this->Stream = OpenFile(path); });
  }

  [[noreturn]] void Fail(const std::string& expected)
  {
    throw InputError(
      this->Path + " is truncated, damaged or of another format: it should have " + expected + ".");
  }
  std::string Word(const std::string& what)
  {
    std::string word;
    const auto isControl = [](unsigned char c) { return std::iscntrl(c) != 0; };
    this->Stream >> std::setw(static_cast<int>(LongestLine)) >> word;
    if (!this->Stream || std::any_of(word.begin(), word.end(), isControl))
    {
      this->Fail(what);
    }
    return word;
  }
  std::int64_t Int(std::int64_t least, std::int64_t most, const std::string& what)
  {
    std::int64_t value = 0;
    if (!(this->Stream >> value) || value < least || value > most)
    {
      this->Fail(what);
    }
    return value;
  }
  double Real(const std::string& what)
  {
    double value = 0.0;
    if (!(this->Stream >> value) || !std::isfinite(value))
    {
      this->Fail(what);
    }
    return value;
  }
  /// Reads the given characters, with white space between them or not.
  void Signs(const char* signs, const std::string& what)
  {
    for (char sign = 0; *signs; ++signs)
    {
      if (!(this->Stream >> sign) || sign != *signs)
      {
        this->Fail(what);
      }
    }
  }
  /// Reads a box written as ((i,j,k) (i,j,k) (0,0,0)), its first and last cell.
  IndexBox Box(const std::string& what)
  {
    IndexBox box;
    this->Signs("(", what);
    this->Cell(box.Lower, what);
    this->Cell(box.Upper, what);
    Index3 type;
    this->Cell(type, what);
    this->Signs(")", what);
    for (int a = 0; a < 3; ++a)
    {
      ++box.Upper[a];
      if (box.Upper[a] <= box.Lower[a] || type[a] != 0)
      {
        this->Fail(what);
      }
    }
    PrefixErrors(this->Path + ": ", [&] { CountCells({ box.Size(0), box.Size(1), box.Size(2) }); });
    return box;
  }
  void Bytes(char* to, std::int64_t count)
  {
    if (!this->Stream.read(to, count))
    {
      this->Fail(std::to_string(count) + " bytes of values");
    }
  }
  void Seek(std::int64_t position) { this->Stream.seekg(position); }
  std::int64_t Position() { return this->Stream.tellg(); }

private:
  void Cell(Index3& cell, const std::string& what)
  {
    for (int a = 0; a < 3; ++a)
    {
      this->Signs(a == 0 ? "(" : ",", what);
      cell[a] = this->Int(-LargestIndex, LargestIndex, what);
    }
    this->Signs(")", what);
  }

  static constexpr std::int64_t LargestIndex = 1 << 30;
  std::string Path;
  std::ifstream Stream;
};

} // namespace vfm
