#include "Surfaces/StlFile.h"

#include "Base/ParseText.h"
#include "Base/Sorted.h"
#include "Ranks/Errors.h"
#include "Surfaces/FileBytes.h"
#include "Surfaces/PatchList.h"
#include "Surfaces/TextScan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace vfm
{
namespace
{

constexpr std::size_t HeaderSize = 84;     // text of 80 bytes, number of triangles
constexpr std::size_t RecordSize = 50;     // normal, three corners, attribute
constexpr std::size_t AttributePlace = 48; // in a record
constexpr std::size_t MostColours = 256;   // more are not patches but a texture
constexpr int NoColour = -1;

[[noreturn]] void RejectKind()
{
  throw InputError("it is not an STL file, or is truncated.");
}

/// Returns whether the begin of a file is text whose first word is "solid".
bool BeginsAsText(std::string_view bytes)
{
  constexpr std::size_t looked = 1024;
  const std::string_view head = bytes.substr(0, looked);
  const bool isPlain = std::none_of(head.begin(), head.end(), [](char c) { return c == '\0'; });
  return isPlain && ToLower(std::string(TextScan(head).Word())) == "solid";
}

/// Returns the colour of a triangle, 0xrrggbb, or NoColour.
int FindColour(unsigned int attribute, bool isOfMagics)
{
  const bool hasBit = (attribute & 0x8000u) != 0;
  if (hasBit == isOfMagics) // Magics sets the bit for the colour of the whole body
  {
    return NoColour;
  }
  const auto widen = [](unsigned int five) { return five << 3 | five >> 2; };
  const unsigned int low = widen(attribute & 31u), middle = widen(attribute >> 5 & 31u),
                     high = widen(attribute >> 10 & 31u);
  return static_cast<int>(
    isOfMagics ? low << 16 | middle << 8 | high : high << 16 | middle << 8 | low);
}

std::string NameColour(int colour)
{
  char name[16] = "";
  if (colour != NoColour)
  {
    std::snprintf(name, sizeof(name), "colour_%06x", static_cast<unsigned int>(colour));
  }
  return name;
}

/// Makes patches of the colours, in ascending order.
void SetColours(const std::vector<int>& colours, SurfaceFile& file)
{
  std::vector<int> used = colours;
  SortUnique(used);
  if (used.size() > MostColours)
  {
    file.Note = "Its " + std::to_string(used.size()) + " colours are ignored: at most " +
      std::to_string(MostColours) + " are patches.";
    used = { NoColour };
  }
  for (int colour : used)
  {
    file.PatchNames.push_back(NameColour(colour));
  }
  for (int colour : colours)
  {
    file.Patches.push_back(used.size() == 1 ? 0 : static_cast<int>(FindSorted(used, colour)));
  }
}

SurfaceFile ReadBinary(std::string_view bytes)
{
  const std::size_t count = ReadBytesAs<std::uint32_t>(bytes, HeaderSize - 4, false);
  const bool isOfMagics = bytes.substr(0, HeaderSize).find("COLOR=") != std::string_view::npos;
  SurfaceFile file;
  file.Points.reserve(3 * count);
  file.Triangles.reserve(count);
  std::vector<int> colours;
  for (std::size_t t = 0; t < count; ++t)
  {
    const std::size_t begin = HeaderSize + t * RecordSize;
    for (std::size_t c = 0; c < 3; ++c)
    {
      Vector3 corner{};
      for (std::size_t a = 0; a < 3; ++a)
      {
        corner[a] =
          static_cast<double>(ReadBytesAs<float>(bytes, begin + 12 + 12 * c + 4 * a, false));
      }
      file.Points.push_back(corner);
    }
    const Index first = static_cast<Index>(3 * t);
    file.Triangles.push_back({ { first, first + 1, first + 2 } });
    colours.push_back(
      FindColour(ReadBytesAs<std::uint16_t>(bytes, begin + AttributePlace, false), isOfMagics));
  }
  SetColours(colours, file);
  const std::size_t end = HeaderSize + count * RecordSize;
  if (end < bytes.size())
  {
    file.Note += (file.Note.empty() ? "" : " ") + std::to_string(bytes.size() - end) +
      " bytes behind its triangles are ignored.";
  }
  return file;
}

/// Reads the three corners of a facet up to its end.
void ReadFacet(TextScan& text, SurfaceFile& file)
{
  const Index first = static_cast<Index>(file.Points.size());
  for (std::string word = ToLower(std::string(text.Word())); word != "endfacet";
       word = ToLower(std::string(text.Word())))
  {
    if (word.empty())
    {
      text.Reject("the file ends in a facet.");
    }
    if (word == "vertex")
    {
      Vector3 corner{};
      for (double& x : corner)
      {
        x = text.Number("coordinate of a vertex");
      }
      file.Points.push_back(corner);
    }
  }
  if (static_cast<Index>(file.Points.size()) != first + 3)
  {
    text.Reject("the facet has " + std::to_string(static_cast<Index>(file.Points.size()) - first) +
      " vertices; 3 are required.");
  }
  file.Triangles.push_back({ { first, first + 1, first + 2 } });
}

SurfaceFile ReadText(std::string_view bytes)
{
  SurfaceFile file;
  PatchList patches;
  TextScan text(bytes);
  int patch = 0;
  while (!text.IsAtEnd())
  {
    const std::string word = ToLower(std::string(text.Word()));
    if (word == "solid")
    {
      patch = patches.Find(std::string(text.RestOfLine()));
    }
    else if (word == "facet")
    {
      ReadFacet(text, file);
      file.Patches.push_back(patch);
    }
    else if (word == "endsolid")
    {
      text.RestOfLine();
    }
    else
    {
      text.Reject(QuoteText(word) + " is not a word of STL: solid, facet and endsolid are.");
    }
  }
  patches.Finish(file);
  return file;
}

} // namespace

SurfaceFile ReadStl(std::string_view bytes)
{
  const bool isLong = bytes.size() >= HeaderSize;
  const std::size_t required = isLong ? HeaderSize +
      RecordSize * std::size_t(ReadBytesAs<std::uint32_t>(bytes, HeaderSize - 4, false))
                                      : 0;
  if (isLong && required == bytes.size())
  {
    return ReadBinary(bytes);
  }
  if (BeginsAsText(bytes))
  {
    return ReadText(bytes);
  }
  if (!isLong || required == HeaderSize)
  {
    RejectKind();
  }
  if (required > bytes.size())
  {
    throw InputError("it is not an STL file, or is truncated: its " +
      std::to_string((required - HeaderSize) / RecordSize) + " triangles require " +
      std::to_string(required) + " bytes, and it has " + std::to_string(bytes.size()) + ".");
  }
  return ReadBinary(bytes);
}

} // namespace vfm
