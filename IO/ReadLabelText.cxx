#include "ReadLabelText.h"

#include "CellCount.h"
#include "OpenFile.h"
#include "VoxelRows.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

namespace vfm
{
namespace
{

constexpr Index LargestBuffer = 1 << 20;     // bytes
constexpr std::ptrdiff_t LongestNumber = 64; // characters
constexpr std::ptrdiff_t ShownLetters = 24;  // characters of an invalid value in a message

bool IsSpace(char c)
{
  return c == ' ' || (c >= '\t' && c <= '\r');
}

/// Returns a buffer for parts of a file; it is not larger than the file.
std::vector<char> MakeBuffer(const std::string& path)
{
  return std::vector<char>(std::clamp<Index>(GetFileLength(path), 1, LargestBuffer));
}

/// Calls work(begin, end) on consecutive parts of a file, from its beginning up to byte `last`.
template <class Work>
void ForParts(const std::string& path, Index last, const Work& work)
{
  std::ifstream stream = OpenFile(path);
  std::vector<char> part = MakeBuffer(path);
  for (Index left = last; left > 0 && stream; left -= stream.gcount())
  {
    stream.read(part.data(), std::min<Index>(left, part.size()));
    work(part.data(), part.data() + stream.gcount());
  }
}

/// Counts the words of a file.
Index CountValues(const std::string& path)
{
  Index count = 0;
  bool afterSpace = true;
  ForParts(path, std::numeric_limits<Index>::max(),
    [&](const char* begin, const char* end)
    {
      for (const char* c = begin; c < end; ++c)
      {
        const bool isSpace = IsSpace(*c);
        count += afterSpace && !isSpace;
        afterSpace = isSpace;
      }
    });
  return count;
}

/// Reads the labels of a file one by one.
class LabelStream
{
public:
  explicit LabelStream(const std::string& path) :
    Path(path),
    Stream(OpenFile(path)),
    Buffer(MakeBuffer(path)),
    Next(Buffer.data()),
    End(Buffer.data())
  {
  }

  /// Reads the next label; returns false at the end of the file.
  bool Read(int& label)
  {
    while (this->SkipSpaces() && this->End - this->Next < LongestNumber && this->Fill())
    {
    }
    if (this->Next == this->End)
    {
      return false;
    }
    const auto [stop, error] = std::from_chars(this->Next, this->End, label);
    if (error != std::errc() || label < 0 || (stop < this->End && !IsSpace(*stop)))
    {
      this->Reject();
    }
    this->Next = stop;
    return true;
  }

private:
  /// Skips white space in the buffer. Always returns true.
  bool SkipSpaces()
  {
    while (this->Next < this->End && IsSpace(*this->Next))
    {
      ++this->Next;
    }
    return true;
  }

  /// Moves the unread text to the front of the buffer and reads more of the file behind it. Returns
  /// false at the end of the file.
  bool Fill()
  {
    const std::ptrdiff_t left = this->End - this->Next;
    std::copy(this->Next, this->End, this->Buffer.data());
    this->Offset += this->Next - this->Buffer.data();
    this->Next = this->Buffer.data();
    const auto room = static_cast<std::streamsize>(this->Buffer.size()) - left;
    this->Stream.read(this->Buffer.data() + left, room);
    this->End = this->Next + left + this->Stream.gcount();
    return this->Stream.gcount() > 0;
  }

  [[noreturn]] void Reject() const
  {
    const char* end = std::find_if(this->Next, this->End, IsSpace);
    Index number = 0;
    const auto [stop, error] = std::from_chars(this->Next, end, number);
    std::string word(this->Next, std::min(end, this->Next + ShownLetters));
    std::replace_if(
      word.begin(), word.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    Index line = 1;
    ForParts(this->Path, this->Offset + (this->Next - this->Buffer.data()),
      [&line](const char* first, const char* last) { line += std::count(first, last, '\n'); });
    const std::string where = "line " + std::to_string(line) + ": ";
    if (stop == end && error != std::errc::invalid_argument)
    {
      throw InputError(where + "the label " + word +
        (word[0] == '-' ? " is negative." : " is larger than 2147483647."));
    }
    throw InputError(where + "'" + word + (end - this->Next > ShownLetters ? ".." : "") +
      "' is not an integer. (With numpy.savetxt, set fmt='%d'.)");
  }

  std::string Path;
  std::ifstream Stream;
  std::vector<char> Buffer;
  const char *Next, *End;
  Index Offset = 0; ///< place of the buffer in the file, bytes
};

[[noreturn]] void RejectCount(const VoxelFile& file)
{
  const Index values = CountValues(file.Path);
  throw InputError("it holds " + std::to_string(values) +
    (values == 1 ? " value, but " : " values, but ") + DescribeCells(file.Cells) +
    " cells require " + std::to_string(file.Cells[0] * file.Cells[1] * file.Cells[2]) + ".");
}

[[noreturn]] void RequireCells(const VoxelFile& file)
{
  const Index values = CountValues(file.Path);
  const Index edge = std::lround(std::cbrt(static_cast<double>(values)));
  throw InputError(
    "a voxel text does not contain its size. Set Dimensions, the numbers of cells along x, y and "
    "z; the file holds " +
    std::to_string(values) + " values" +
    (edge > 0 && edge * edge * edge == values
        ? ", which fit " + DescribeCells({ edge, edge, edge }) + " cells."
        : "."));
}

} // namespace

void CheckLabelCount(const VoxelFile& file)
{
  const Index3& cells = file.Cells;
  if (*std::min_element(cells.begin(), cells.end()) < 1)
  {
    RequireCells(file);
  }
  // Each value takes a digit and a space, except the last, which needs no space.
  if (GetFileLength(file.Path) < 2 * CountCells(cells) - 1)
  {
    RejectCount(file);
  }
}

void ReadLabelText(const VoxelFile& file, const IndexBox& box, int* labels)
{
  LabelStream stream(file.Path);
  const VoxelRows rows(file, box);
  int label = 0;
  for (Index plane = 0; plane < rows.Planes(); ++plane)
  {
    for (Index row = 0; row < rows.RowsInPlane(); ++row)
    {
      const VoxelRows::Part part = rows.Find(plane, row);
      int* to = labels + part.Cell;
      for (Index i = 0; i < rows.Length(); ++i)
      {
        if (!stream.Read(label))
        {
          RejectCount(file);
        }
        if (i >= part.First && i < part.Last)
        {
          *to = label;
          to += part.Stride;
        }
      }
    }
  }
  if (stream.Read(label))
  {
    RejectCount(file);
  }
}

} // namespace vfm
