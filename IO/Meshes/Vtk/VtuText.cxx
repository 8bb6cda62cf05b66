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

using AddParts = std::function<void(const AddBytes& add)>;

void AppendBase64(std::string_view bytes, std::string& text)
{
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
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
}

/// Writes bytes as one text in base64.
class Base64
{
public:
  explicit Base64(OutputFile& file) : File(file) {}
  void Add(std::string_view bytes)
  {
    this->Rest.append(bytes);
    const std::size_t whole = this->Rest.size() / 3 * 3;
    this->Write(whole);
    this->Rest.erase(0, whole);
  }
  void Finish()
  {
    this->Write(this->Rest.size());
    this->Rest.clear();
  }

private:
  void Write(std::size_t size)
  {
    this->Text.clear();
    AppendBase64(std::string_view(this->Rest).substr(0, size), this->Text);
    this->File.Add(this->Text);
  }

  OutputFile& File;
  std::string Rest; // fewer than 3 bytes between calls
  std::string Text;
};

#ifdef VFM_HAS_ZLIB

constexpr const char* HeadAttributes =
  "header_type=\"UInt32\" compressor=\"vtkZLibDataCompressor\"";
constexpr std::size_t BlockSize = 32768;
constexpr int CompressionLevel = 5; // default of VTK

/// Writes compressed values: number of blocks, size of a block, size of the last block if it is
/// shorter or 0, compressed sizes; then the blocks.
class Values
{
public:
  /// @param size  number of bytes
  Values(OutputFile& file, std::size_t size) :
    File(file), Blocks(file), Packed(compressBound(BlockSize), '\0')
  {
    const std::size_t blocks = (size + BlockSize - 1) / BlockSize;
    this->Sizes = { static_cast<std::uint32_t>(blocks), BlockSize,
      static_cast<std::uint32_t>(size % BlockSize) };
    const std::size_t bytes = sizeof(std::uint32_t) * (this->Sizes.size() + blocks);
    this->Place = file.Reserve((bytes + 2) / 3 * 4);
  }
  void Add(std::string_view bytes)
  {
    while (!bytes.empty())
    {
      if (this->Block.empty() && bytes.size() >= BlockSize)
      {
        this->AddBlock(bytes.substr(0, BlockSize));
        bytes.remove_prefix(BlockSize);
        continue;
      }
      const std::size_t taken = std::min(BlockSize - this->Block.size(), bytes.size());
      this->Block.append(bytes.substr(0, taken));
      bytes.remove_prefix(taken);
      if (this->Block.size() == BlockSize)
      {
        this->AddBlock(this->Block);
        this->Block.clear();
      }
    }
  }
  void Finish()
  {
    if (!this->Block.empty())
    {
      this->AddBlock(this->Block);
    }
    this->Blocks.Finish();
    std::string text;
    AppendBase64({ reinterpret_cast<const char*>(this->Sizes.data()),
                   sizeof(std::uint32_t) * this->Sizes.size() },
      text);
    this->File.Fill(this->Place, text);
  }

private:
  void AddBlock(std::string_view block)
  {
    uLongf size = this->Packed.size();
    compress2(reinterpret_cast<Bytef*>(&this->Packed[0]), &size,
      reinterpret_cast<const Bytef*>(block.data()), block.size(), CompressionLevel);
    this->Sizes.push_back(static_cast<std::uint32_t>(size));
    this->Blocks.Add({ this->Packed.data(), size });
  }

  OutputFile& File;
  Base64 Blocks;
  std::string Block, Packed;
  std::vector<std::uint32_t> Sizes;
  std::int64_t Place;
};

#else

constexpr const char* HeadAttributes = "header_type=\"UInt64\"";

/// Writes the number of bytes and the values.
class Values
{
public:
  Values(OutputFile& file, std::uint64_t size) : Text(file)
  {
    this->Text.Add({ reinterpret_cast<const char*>(&size), sizeof(size) });
  }
  void Add(std::string_view bytes) { this->Text.Add(bytes); }
  void Finish() { this->Text.Finish(); }

private:
  Base64 Text;
};

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
  std::size_t size, const AddParts& addValues, bool isHidden)
{
  file.Add(std::string("<") + element + " " + attributes + " format=\"binary\">\n");
  Values values(file, size);
  addValues([&values](std::string_view bytes) { values.Add(bytes); });
  values.Finish();
  file.Add(isHidden
      ? "\n<InformationKey name=\"GUI_HIDE\" location=\"vtkAbstractArray\">1</InformationKey>\n"
      : "\n");
  file.Add(std::string("</") + element + ">\n");
}

void AddElement(OutputFile& file, const char* element, const std::string& attributes,
  std::string_view bytes, bool isHidden)
{
  AddElement(
    file, element, attributes, bytes.size(), [bytes](const AddBytes& add) { add(bytes); },
    isHidden);
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
/// @param addValues  addValues(array, add) adds the values of an array
template <class AddValues>
void AddArrays(OutputFile& file, const char* element, const std::vector<MeshArray>& arrays,
  Index tuples, const AddValues& addValues)
{
  file.Add(std::string("<") + element + DescribeVtuRoles(arrays) + ">\n");
  for (const MeshArray& array : arrays)
  {
    const Index size = WidthOfType(array.Type) * array.Components * tuples;
    AddVtuArray(file, DescribeVtuArray(array), static_cast<std::size_t>(size),
      [&](const AddBytes& add) { addValues(array, add); });
  }
  file.Add(std::string("</") + element + ">\n");
}

/// Adds arrays in memory.
void AddArrays(
  OutputFile& file, const char* element, const std::vector<MeshArray>& arrays, Index tuples)
{
  AddArrays(file, element, arrays, tuples,
    [tuples](const MeshArray& array, const AddBytes& add)
    {
      add(View(static_cast<const char*>(array.Values),
        WidthOfType(array.Type) * array.Components * tuples));
    });
}

constexpr const char* CornerAttributes = "type=\"Int64\" Name=\"connectivity\"";

/// Adds the ends of elements in the array of connectivity.
/// @param nodes  number of nodes per element
void AddOffsets(OutputFile& file, Index nodes, Index elements)
{
  AddVtuArray(file, "type=\"Int64\" Name=\"offsets\"",
    sizeof(Index) * static_cast<std::size_t>(elements),
    [=](const AddBytes& add)
    {
      for (Index element = 0; element < elements; ++element)
      {
        const Index end = nodes * (element + 1);
        add(View(&end, 1));
      }
    });
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

void AddVtuArray(OutputFile& file, const std::string& attributes, std::size_t size,
  const std::function<void(const AddBytes& add)>& addValues)
{
  AddElement(file, "DataArray", attributes, size, addValues, false);
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

void AddVtuMesh(OutputFile& file, const MeshData& mesh, const MeshWithRuns& whole)
{
  AddArrays(file, "PointData", mesh.PointArrays, whole.NumberOfPoints(),
    [&whole](const MeshArray& array, const AddBytes& add) { AddPointValues(whole, array, add); });
  AddArrays(file, "CellData", mesh.ElementArrays, whole.NumberOfElements(),
    [&whole](const MeshArray& array, const AddBytes& add) { AddElementValues(whole, array, add); });
  file.Add("<Points>\n");
  AddVtuArray(file, VtuPointAttributes,
    3 * sizeof(double) * static_cast<std::size_t>(whole.NumberOfPoints()),
    [&whole](const AddBytes& add) { AddPoints(whole, add); });
  file.Add("</Points>\n");
}

void AddVtuElements(OutputFile& file, const MeshData& mesh)
{
  const Index count = mesh.NumberOfElements, nodes = mesh.NodesPerElement();
  AddVtuArray(file, CornerAttributes, sizeof(Index) * static_cast<std::size_t>(nodes * count),
    [&](const AddBytes& add)
    {
      if (mesh.MidsPerElement == 0)
      {
        add(View(mesh.Elements, nodes * count));
        return;
      }
      for (Index element = 0; element < count; ++element)
      {
        mesh.ForNodes(element,
          [&add](const Index* first, const Index* last) { add(View(first, last - first)); });
      }
    });
  AddOffsets(file, nodes, count);
}

void AddVtuElements(OutputFile& file, const MeshData& mesh, const MeshWithRuns& whole)
{
  const Index nodes = mesh.NodesPerElement(), count = whole.NumberOfElements();
  AddVtuArray(file, CornerAttributes, sizeof(Index) * static_cast<std::size_t>(nodes * count),
    [&whole](const AddBytes& add) { AddCorners(whole, add); });
  AddOffsets(file, nodes, count);
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
