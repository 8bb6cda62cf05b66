#include "Surfaces/VtpFile.h"

#include "GridFiles/CellLists.h"
#include "GridFiles/VtkArrays.h"
#include "GridFiles/VtkExtents.h"
#include "Ranks/Errors.h"
#include "Surfaces/FileBytes.h"
#include "Surfaces/PolygonTriangles.h"
#include "Surfaces/XmlTags.h"

#include <algorithm>

namespace vfm
{
namespace
{

constexpr int ZlibBits = 15;
constexpr double LargestRatio = 1100.0; // of zlib's packed bytes

/// Reads the elements up to the appended data.
XmlOutline ReadOutline(const std::string& bytes)
{
  XmlOutline outline;
  outline.FileSize = static_cast<std::int64_t>(bytes.size());
  OutlineElement top;
  std::vector<OutlineElement*> open{ &top };
  XmlTag tag;
  for (XmlTags tags(bytes); tags.Next(tag);)
  {
    if (tag.IsEnd)
    {
      open.pop_back();
      continue;
    }
    open.back()->Children.emplace_back();
    OutlineElement& element = open.back()->Children.back();
    element.Name = tag.Name;
    element.Place = static_cast<std::int64_t>(tag.Place);
    for (const auto& [name, value] : tag.Attributes)
    {
      element.Attributes[std::string(name)] = ReplaceReferences(value);
    }
    open.push_back(&element);
    if (tag.Name == AppendedDataName)
    {
      outline.Encoding = element.Get("encoding");
      const std::size_t end = bytes.find('>', tag.Place);
      const std::size_t begin = bytes.find_first_not_of(" \t\r\n", end + 1);
      if (begin == std::string::npos || bytes[begin] != '_' ||
        (outline.Encoding != "raw" && outline.Encoding != "base64"))
      {
        RejectVtkFile("its appended data have no encoding or no begin");
      }
      outline.Appended = static_cast<std::int64_t>(begin + 1);
      break;
    }
  }
  if (top.Children.empty())
  {
    RejectVtkFile("it has no element");
  }
  outline.Root = std::move(top.Children[0]);
  return outline;
}

VtkStorage MakeStorage(
  const XmlOutline& outline, const std::string& bytes, const SurfaceTools& tools)
{
  const OutlineElement& root = outline.Root;
  if (root.Name != "VTKFile" || root.Get("type") != "PolyData")
  {
    throw InputError("it is not a VTK file of the type that its suffix requires: required is "
                     "<VTKFile type=\"PolyData\">.");
  }
  const std::string packed = root.Get("compressor");
  if (!packed.empty() && packed != "vtkZLibDataCompressor")
  {
    throw InputError(
      "it is compressed by " + packed + ": save it with zlib or without compression.");
  }
  return { "", outline.Encoding, outline.Appended, outline.FileSize,
    root.Get("byte_order") == "BigEndian", root.Get("header_type") == "UInt64" ? 8 : 4, packed,
    packed.empty() ? 1.0 : LargestRatio,
    [tools](
      const std::string&, const std::vector<unsigned char>& from, std::vector<unsigned char>& to)
    {
      const std::string_view view(reinterpret_cast<const char*>(from.data()), from.size());
      const std::string plain = InflateAll(view, ZlibBits, tools);
      const bool isGood = plain.size() == to.size();
      std::copy_n(plain.begin(), isGood ? plain.size() : 0, to.begin());
      return isGood;
    },
    bytes };
}

const OutlineElement& FindArray(const OutlineElement& list, const std::string& name)
{
  for (const OutlineElement& array : list.Children)
  {
    if (array.Name == "DataArray" && (name.empty() || array.Get("Name") == name))
    {
      return array;
    }
  }
  RejectVtkFile("its " + list.Name + " have no array '" + name + "'");
}

std::vector<double> ReadArray(
  const OutlineElement& array, std::optional<std::int64_t> tuples, const VtkStorage& storage)
{
  std::vector<double> values;
  CheckVtkArray(array, tuples, storage, [&values](double value) { values.push_back(value); });
  return values;
}

/// Appends the triangles of strips or polygons.
void AddCells(const OutlineElement& lists, std::int64_t cells, std::int64_t points, Index first,
  const VtkStorage& storage, SurfaceFile& file)
{
  if (cells <= 0)
  {
    return;
  }
  CheckCellLists(lists, cells, points, storage);
  const std::vector<double> ends = ReadArray(FindArray(lists, "offsets"), cells, storage);
  const std::vector<double> corners =
    ReadArray(FindArray(lists, "connectivity"), std::nullopt, storage);
  std::vector<Index> cell;
  std::size_t at = 0;
  for (double end : ends)
  {
    cell.clear();
    for (; at < static_cast<std::size_t>(end); ++at)
    {
      cell.push_back(first + static_cast<Index>(corners[at]));
    }
    const bool isStrip = lists.Name == "Strips";
    for (std::size_t c = 0; isStrip && c + 2 < cell.size(); ++c)
    {
      AddPolygon({ cell[c], cell[c + 1 + c % 2], cell[c + 2 - c % 2] }, 0, file);
    }
    if (!isStrip)
    {
      AddPolygon(cell, 0, file);
    }
  }
}

std::int64_t CountOf(const OutlineElement& piece, const std::string& name)
{
  return piece.Get(name).empty() ? 0 : ReadVtkInts<1>(piece, name, 0)[0];
}

void AddPiece(const OutlineElement& piece, const VtkStorage& storage, SurfaceFile& file)
{
  const std::int64_t points = CountOf(piece, "NumberOfPoints");
  const OutlineElement* places = piece.Find("Points");
  if (points == 0 || !places)
  {
    return;
  }
  const OutlineElement& array = FindArray(*places, "");
  if (array.Get("NumberOfComponents") != "3")
  {
    RejectVtkFile("its points do not have three components");
  }
  const std::vector<double> values = ReadArray(array, points, storage);
  const Index first = static_cast<Index>(file.Points.size());
  for (std::size_t v = 0; v + 2 < values.size(); v += 3)
  {
    file.Points.push_back({ { values[v], values[v + 1], values[v + 2] } });
  }
  for (const char* name : { "Polys", "Strips" })
  {
    if (const OutlineElement* lists = piece.Find(name))
    {
      AddCells(
        *lists, CountOf(piece, std::string("NumberOf") + name), points, first, storage, file);
    }
  }
}

} // namespace

SurfaceFile ReadVtp(const std::string& bytes, const SurfaceTools& tools)
{
  const XmlOutline outline = ReadOutline(bytes);
  const VtkStorage storage = MakeStorage(outline, bytes, tools);
  SurfaceFile file;
  file.PatchNames = { "" };
  const OutlineElement* data = outline.Root.Find("PolyData");
  if (!data)
  {
    RejectVtkFile("it has no element PolyData");
  }
  for (const OutlineElement& piece : data->Children)
  {
    if (piece.Name == "Piece")
    {
      AddPiece(piece, storage, file);
    }
  }
  return file;
}

} // namespace vfm
