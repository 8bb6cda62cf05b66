#include "Meshes/Vtk/VtuText.h"

#include "Meshes/Files/OutputFile.h"
#include "Report/UniqueNames.h"

#ifdef VFM_HAS_ZLIB
#include <zlib.h>
#endif

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace vfm
{
namespace
{

using Sizes = std::vector<std::uint32_t>;

std::string ToBase64(std::string_view bytes)
{
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t first = 0; first < bytes.size(); first += 3)
  {
    const std::size_t count = std::min<std::size_t>(bytes.size() - first, 3);
    std::uint32_t bits = 0;
    for (std::size_t b = 0; b < 3; ++b)
    {
      bits = bits << 8 | (b < count ? static_cast<unsigned char>(bytes[first + b]) : 0);
    }
    for (std::size_t d = 0; d < 4; ++d)
    {
      text += d <= count ? digits[bits >> (18 - 6 * d) & 63] : '=';
    }
  }
  return text;
}

std::string_view BytesOf(const Sizes& sizes)
{
  return { reinterpret_cast<const char*>(sizes.data()), sizeof(sizes[0]) * sizes.size() };
}

#ifdef VFM_HAS_ZLIB

constexpr const char* HeadAttributes =
  "header_type=\"UInt32\" compressor=\"vtkZLibDataCompressor\"";
constexpr std::size_t BlockSize = 32768;
constexpr int CompressionLevel = 5; // default of VTK

/// Adds compressed values: number of blocks, size of a block, size of the last block if it is
/// shorter or 0, compressed sizes; then the blocks.
void AddValues(OutputFile& file, std::string_view bytes)
{
  const std::size_t blocks = (bytes.size() + BlockSize - 1) / BlockSize;
  Sizes sizes{ static_cast<std::uint32_t>(blocks), BlockSize,
    static_cast<std::uint32_t>(bytes.size() % BlockSize) };
  std::string all, buffer(compressBound(BlockSize), '\0');
  for (std::size_t block = 0; block < blocks; ++block)
  {
    const std::string_view part = bytes.substr(block * BlockSize, BlockSize);
    uLongf size = buffer.size();
    compress2(reinterpret_cast<Bytef*>(&buffer[0]), &size,
      reinterpret_cast<const Bytef*>(part.data()), part.size(), CompressionLevel);
    sizes.push_back(static_cast<std::uint32_t>(size));
    all.append(buffer, 0, size);
  }
  file.Add(ToBase64(BytesOf(sizes)));
  file.Add(ToBase64(all));
}

#else

constexpr const char* HeadAttributes = "header_type=\"UInt64\"";

void AddValues(OutputFile& file, std::string_view bytes)
{
  const std::uint64_t size = bytes.size();
  std::string all(reinterpret_cast<const char*>(&size), sizeof(size));
  file.Add(ToBase64(all.append(bytes)));
}

#endif

/// Returns the attribute of a type, for instance type="Int32".
template <class Value>
std::string TypeAttribute()
{
  const char* kind = std::is_floating_point_v<Value> ? "Float"
    : std::is_signed_v<Value>                        ? "Int"
                                                     : "UInt";
  return std::string("type=\"") + kind + std::to_string(8 * sizeof(Value)) + "\"";
}

std::string IdAttribute()
{
  return TypeAttribute<Index>() + " IdType=\"1\"";
}

/// Adds an XML element with values. ParaView does not list hidden arrays.
void AddElement(OutputFile& file, const char* element, const std::string& attributes,
  std::string_view bytes, bool isHidden)
{
  file.Add(std::string("<") + element + " " + attributes + " format=\"binary\">\n");
  AddValues(file, bytes);
  file.Add(isHidden
      ? "\n<InformationKey name=\"GUI_HIDE\" location=\"vtkAbstractArray\">1</InformationKey>\n"
      : "\n");
  file.Add(std::string("</") + element + ">\n");
}

template <class Value>
void AddField(OutputFile& file, const FieldArray& field, const std::vector<Value>& values)
{
  std::string attributes = " Name=\"" + XmlText(field.Name) + "\"";
  if (field.Components > 1)
  {
    attributes += " NumberOfComponents=\"" + std::to_string(field.Components) + "\"";
  }
  attributes += " NumberOfTuples=\"" + std::to_string(values.size() / field.Components) + "\"";
  if constexpr (std::is_same_v<Value, std::string>)
  {
    std::string bytes;
    for (const std::string& text : values)
    {
      bytes.append(text).append(1, '\0');
    }
    AddElement(file, "Array", "type=\"String\"" + attributes, bytes, true);
  }
  else
  {
    const std::string type = std::is_same_v<Value, Index> ? IdAttribute() : TypeAttribute<Value>();
    AddElement(file, "DataArray", type + attributes,
      { reinterpret_cast<const char*>(values.data()), sizeof(Value) * values.size() }, true);
  }
}

template <class T>
std::string_view View(const T* values, Index count)
{
  return { reinterpret_cast<const char*>(values), sizeof(T) * static_cast<std::size_t>(count) };
}

/// Adds PointData or CellData.
/// @param tuples  number of points or elements
void AddArrays(
  OutputFile& file, const char* element, const std::vector<MeshArray>& arrays, Index tuples)
{
  file.Add(std::string("<") + element + DescribeVtuRoles(arrays) + ">\n");
  for (const MeshArray& array : arrays)
  {
    AddVtuArray(file, DescribeVtuArray(array),
      View(static_cast<const char*>(array.Values),
        WidthOfType(array.Type) * array.Components * tuples));
  }
  file.Add(std::string("</") + element + ">\n");
}

} // namespace

std::string VtuHead(const std::string& type, const std::string& version)
{
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + type + "\" version=\"" + version +
    "\" byte_order=\"LittleEndian\" " + HeadAttributes + ">\n";
}

std::string XmlText(const std::string& text)
{
  std::string safe;
  for (char c : ToUtf8(text))
  {
    switch (c)
    {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\t':
      case '\n':
      case '\r': // readers convert them to spaces in attributes
        safe += "&#" + std::to_string(static_cast<int>(c)) + ";";
        break;
      default:
        safe += static_cast<unsigned char>(c) < ' ' ? UnknownCharacter : std::string(1, c);
    }
  }
  return safe;
}

std::string DescribeVtuArray(const MeshArray& array)
{
  std::string text = array.Type == ValueType::Id
    ? IdAttribute()
    : VisitType(array.Type, [](auto tag) { return TypeAttribute<typename decltype(tag)::Type>(); });
  text += " Name=\"" + XmlText(array.Name) + "\"";
  if (array.Components > 1)
  {
    text += " NumberOfComponents=\"" + std::to_string(array.Components) + "\"";
  }
  for (std::size_t c = 0; c < array.ComponentNames.size(); ++c)
  {
    if (!array.ComponentNames[c].empty())
    {
      text +=
        " ComponentName" + std::to_string(c) + "=\"" + XmlText(array.ComponentNames[c]) + "\"";
    }
  }
  return text;
}

void AddVtuArray(OutputFile& file, const std::string& attributes, std::string_view bytes)
{
  AddElement(file, "DataArray", attributes, bytes, false);
}

void AddVtuFields(OutputFile& file, const MeshData& mesh)
{
  file.Add("<FieldData>\n");
  if (mesh.Time)
  {
    AddElement(file, "DataArray",
      TypeAttribute<double>() + " Name=\"TimeValue\" NumberOfTuples=\"1\"",
      { reinterpret_cast<const char*>(&*mesh.Time), sizeof(double) }, false);
  }
  for (const FieldArray& field : mesh.Fields)
  {
    std::visit([&](const auto& values) { AddField(file, field, values); }, field.Values);
  }
  file.Add("</FieldData>\n");
}

void AddVtuMesh(OutputFile& file, const MeshData& mesh)
{
  AddArrays(file, "PointData", mesh.PointArrays, mesh.NumberOfPoints);
  AddArrays(file, "CellData", mesh.ElementArrays, mesh.NumberOfElements);
  file.Add("<Points>\n");
  AddVtuArray(file, VtuPointAttributes, View(mesh.Points, 3 * mesh.NumberOfPoints));
  file.Add("</Points>\n");
}

void AddVtuElements(OutputFile& file, const MeshData& mesh)
{
  const Index count = mesh.NumberOfElements, nodes = mesh.NodesPerElement();
  std::vector<Index> all;
  for (Index element = 0; mesh.MidsPerElement > 0 && element < count; ++element)
  {
    mesh.ForNodes(element,
      [&all](const Index* first, const Index* last) { all.insert(all.end(), first, last); });
  }
  AddVtuArray(file, "type=\"Int64\" Name=\"connectivity\"",
    View(all.empty() ? mesh.Elements : all.data(), nodes * count));
  std::vector<Index> offsets(count);
  for (Index element = 0; element < count; ++element)
  {
    offsets[element] = nodes * (element + 1);
  }
  AddVtuArray(file, "type=\"Int64\" Name=\"offsets\"", View(offsets.data(), count));
}

std::string DescribeVtuRoles(const std::vector<MeshArray>& arrays)
{
  constexpr const char* roles[][2] = { { "MaterialId", "Scalars" }, { "SurfaceId", "Scalars" },
    { "CurveId", "Scalars" }, { "VertexId", "Scalars" }, { "GlobalCellIds", "GlobalIds" },
    { "GlobalPointIds", "GlobalIds" } };
  std::string text;
  for (const auto& [name, role] : roles)
  {
    const std::string attribute = std::string(" ") + role;
    if (FindArray(arrays, name) && text.find(attribute) == std::string::npos)
    {
      text += attribute + "=\"" + name + "\"";
    }
  }
  return text;
}

} // namespace vfm
