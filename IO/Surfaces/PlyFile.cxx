#include "Surfaces/PlyFile.h"

#include "Ranks/Errors.h"
#include "Surfaces/FileBytes.h"
#include "Surfaces/PolygonTriangles.h"
#include "Surfaces/TextScan.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>

namespace vfm
{
namespace
{

/// Type of a number: its size in bytes, and its kind.
struct PlyType
{
  int Bytes = 0;
  char Kind = 'i'; ///< i signed, u unsigned, f real
};

struct PlyProperty
{
  std::string Name;
  PlyType Type;
  std::optional<PlyType> Count; ///< of a list
};

struct PlyElement
{
  std::string Name;
  Index Count = 0;
  std::vector<PlyProperty> Properties;
};

enum class PlyForm
{
  Text,
  Little,
  Big
};

struct PlyHeader
{
  PlyForm Form = PlyForm::Text;
  std::vector<PlyElement> Elements;
};

PlyType FindType(const TextScan& text, std::string_view name)
{
  static const std::map<std::string_view, PlyType> types{ { "char", { 1, 'i' } },
    { "uchar", { 1, 'u' } }, { "short", { 2, 'i' } }, { "ushort", { 2, 'u' } },
    { "int", { 4, 'i' } }, { "uint", { 4, 'u' } }, { "float", { 4, 'f' } },
    { "double", { 8, 'f' } }, { "int8", { 1, 'i' } }, { "uint8", { 1, 'u' } },
    { "int16", { 2, 'i' } }, { "uint16", { 2, 'u' } }, { "int32", { 4, 'i' } },
    { "uint32", { 4, 'u' } }, { "int64", { 8, 'i' } }, { "uint64", { 8, 'u' } },
    { "float32", { 4, 'f' } }, { "float64", { 8, 'f' } } };
  const auto found = types.find(name);
  if (found == types.end())
  {
    text.Reject(QuoteText(name) + " is not a type of PLY.");
  }
  return found->second;
}

PlyForm FindForm(const TextScan& text, std::string_view name)
{
  if (name == "ascii")
  {
    return PlyForm::Text;
  }
  if (name != "binary_little_endian" && name != "binary_big_endian")
  {
    text.Reject(QuoteText(name) + " is not a format of PLY.");
  }
  return name == "binary_big_endian" ? PlyForm::Big : PlyForm::Little;
}

void ReadProperty(TextScan& text, PlyHeader& header)
{
  if (header.Elements.empty())
  {
    text.Reject("a property has no element.");
  }
  PlyProperty property;
  std::string_view type = text.WordOfLine();
  if (type == "list")
  {
    property.Count = FindType(text, text.WordOfLine());
    type = text.WordOfLine();
  }
  property.Type = FindType(text, type);
  property.Name = text.WordOfLine();
  header.Elements.back().Properties.push_back(property);
}

/// Reads the header up to the line behind end_header.
PlyHeader ReadHeader(TextScan& text, std::size_t size)
{
  PlyHeader header;
  if (text.Word() != "ply")
  {
    throw InputError("it is not a PLY file: it does not begin with 'ply'.");
  }
  text.RestOfLine();
  for (std::string_view word = text.Word(); word != "end_header"; word = text.Word())
  {
    if (word.empty())
    {
      text.Reject("the header does not end.");
    }
    if (word == "format")
    {
      header.Form = FindForm(text, text.WordOfLine());
    }
    else if (word == "element")
    {
      const std::string name(text.WordOfLine());
      header.Elements.push_back(
        { name, text.Integer(0, static_cast<Index>(size), "number of elements"), {} });
    }
    else if (word == "property")
    {
      ReadProperty(text, header);
    }
    text.RestOfLine();
  }
  text.RestOfLine();
  return header;
}

/// Numbers of the elements, one after another.
class PlyNumbers
{
public:
  PlyNumbers(TextScan& text, PlyForm form) : Text(text), Form(form), Bytes(text.Rest()) {}

  double Next(const PlyType& type)
  {
    if (this->Form == PlyForm::Text)
    {
      return this->Text.Number("value");
    }
    const std::size_t size = static_cast<std::size_t>(type.Bytes);
    if (this->Bytes.size() < size)
    {
      throw InputError("it is truncated: its elements require more bytes than it has.");
    }
    const double value = this->Decode(type);
    this->Bytes.remove_prefix(size);
    return value;
  }

private:
  template <class Value>
  double As() const
  {
    return static_cast<double>(ReadBytesAs<Value>(this->Bytes, 0, this->Form == PlyForm::Big));
  }
  double Decode(const PlyType& type) const
  {
    switch (type.Bytes)
    {
      case 1:
        return type.Kind == 'u' ? this->As<std::uint8_t>() : this->As<std::int8_t>();
      case 2:
        return type.Kind == 'u' ? this->As<std::uint16_t>() : this->As<std::int16_t>();
      case 4:
        return type.Kind == 'f' ? this->As<float>()
          : type.Kind == 'u'    ? this->As<std::uint32_t>()
                                : this->As<std::int32_t>();
      default:
        return type.Kind == 'f' ? this->As<double>()
          : type.Kind == 'u'    ? this->As<std::uint64_t>()
                                : this->As<std::int64_t>();
    }
  }

  TextScan& Text;
  PlyForm Form;
  std::string_view Bytes;
};

/// Returns an integer from 0 to most.
Index ToIndex(double value, double most, const char* what)
{
  if (!(value >= 0.0 && value <= most && value == std::floor(value)))
  {
    throw InputError("it is truncated or damaged: a " + std::string(what) + " is " +
      std::to_string(value) + ", where an integer from 0 to " +
      std::to_string(static_cast<Index>(most)) + " is required.");
  }
  return static_cast<Index>(value);
}

/// Reads the values of a property: one, or those of a list.
void ReadValues(
  const PlyProperty& property, std::size_t most, PlyNumbers& numbers, std::vector<double>& values)
{
  values.assign(property.Count
      ? ToIndex(numbers.Next(*property.Count), static_cast<double>(most), "length of a list")
      : 1,
    0.0);
  for (double& value : values)
  {
    value = numbers.Next(property.Type);
  }
}

void ReadPoint(const PlyElement& element, std::size_t size, PlyNumbers& numbers, SurfaceFile& file)
{
  Vector3 point{};
  std::vector<double> values;
  for (const PlyProperty& property : element.Properties)
  {
    ReadValues(property, size, numbers, values);
    const std::size_t axis = std::string("xyz").find(property.Name);
    if (property.Name.size() == 1 && axis < 3 && !property.Count)
    {
      point[axis] = values[0];
    }
  }
  file.Points.push_back(point);
}

/// Reads an element; corners receives the list of points of a face.
void ReadFace(const PlyElement& element, std::size_t size, PlyNumbers& numbers, Index points,
  std::vector<Index>& corners)
{
  corners.clear();
  std::vector<double> values;
  for (const PlyProperty& property : element.Properties)
  {
    ReadValues(property, size, numbers, values);
    if (property.Count && (property.Name == "vertex_indices" || property.Name == "vertex_index"))
    {
      for (double value : values)
      {
        corners.push_back(ToIndex(value, static_cast<double>(points) - 1.0, "point of a face"));
      }
    }
  }
}

} // namespace

SurfaceFile ReadPly(std::string_view bytes)
{
  TextScan text(bytes);
  const PlyHeader header = ReadHeader(text, bytes.size());
  PlyNumbers numbers(text, header.Form);
  SurfaceFile file;
  file.PatchNames = { "" };
  std::vector<Index> corners;
  for (const PlyElement& element : header.Elements)
  {
    for (Index e = 0; e < element.Count && !element.Properties.empty(); ++e)
    {
      if (element.Name == "vertex")
      {
        ReadPoint(element, bytes.size(), numbers, file);
        continue;
      }
      const Index points = static_cast<Index>(file.Points.size());
      ReadFace(element, bytes.size(), numbers, points, corners);
      if (element.Name == "face")
      {
        AddPolygon(corners, 0, file);
      }
    }
  }
  return file;
}

} // namespace vfm
