#include "Meshes/Exodus/WriteNetcdf.h"

#include "Meshes/Exodus/WriteNetcdf4.h"
#include "Meshes/Files/OutputFile.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace vfm
{
namespace
{

// Codes of lists and types in the format. TypeOf and SizeOf (bytes) are indexed by NetcdfKind.
constexpr int ListOfDimensions = 10, ListOfVariables = 11, ListOfAttributes = 12;
constexpr int TypeOfInt = 4, TypeOfFloat = 5;
constexpr int TypeOf[] = { 2, TypeOfInt, 10, 6 };
constexpr int SizeOf[] = { 1, 4, 8, 8 };

Index Padded(Index size)
{
  return (size + 3) / 4 * 4;
}

Index CountBytes(const NetcdfLayout& layout, const NetcdfVariable& variable)
{
  Index size = SizeOf[static_cast<int>(variable.Kind)];
  for (std::size_t dimension : variable.Dimensions)
  {
    size *= std::max<Index>(layout.Dimensions[dimension].Length, 1);
  }
  return size;
}

/// Appends a number, most significant byte first.
void AppendNumber(std::string& text, std::uint64_t number, int bytes)
{
  for (int b = bytes - 1; b >= 0; --b)
  {
    text += static_cast<char>(number >> (8 * b) & 0xff);
  }
}

template <class Number>
void AppendBits(std::string& text, Number value)
{
  std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t> bits;
  std::memcpy(&bits, &value, sizeof(Number));
  AppendNumber(text, bits, sizeof(Number));
}

/// Header of a classic file ("NetCDF Classic Format Specification", CDF-2 and CDF-5).
class ClassicHeader
{
public:
  ClassicHeader(const NetcdfLayout& layout, bool isWide) :
    Layout(layout), CountSize(isWide ? 8 : 4), Text(isWide ? "CDF\5" : "CDF\2")
  {
    this->AddCount(1); // records
    this->AddList(ListOfDimensions, layout.Dimensions.size());
    for (const NetcdfDimension& dimension : layout.Dimensions)
    {
      this->AddText(dimension.Name);
      this->AddCount(dimension.Length);
    }
    this->AddList(ListOfAttributes, layout.Attributes.size());
    for (const auto& [name, value] : layout.Attributes)
    {
      this->AddText(name);
      this->AddValue(value);
    }
    this->AddVariables();
  }

  const std::string& Bytes() const { return this->Text; }
  /// Returns the variables in the order of their places in the file: variables with records last.
  const std::vector<const NetcdfVariable*>& Order() const { return this->Ordered; }

private:
  void AddCount(Index count)
  {
    AppendNumber(this->Text, static_cast<std::uint64_t>(count), this->CountSize);
  }
  void AddList(int kind, std::size_t count)
  {
    AppendNumber(this->Text, count > 0 ? kind : 0, 4);
    this->AddCount(static_cast<Index>(count));
  }
  void AddText(const std::string& text)
  {
    this->AddCount(static_cast<Index>(text.size()));
    this->Text += text;
    this->Text.append(Padded(text.size()) - text.size(), '\0');
  }
  void AddValue(const std::string& text)
  {
    AppendNumber(this->Text, TypeOf[0], 4);
    this->AddText(text);
  }
  void AddValue(const std::variant<std::string, int, float>& value)
  {
    if (const auto* text = std::get_if<std::string>(&value))
    {
      this->AddValue(*text);
      return;
    }
    const auto* integer = std::get_if<int>(&value);
    AppendNumber(this->Text, integer ? TypeOfInt : TypeOfFloat, 4);
    this->AddCount(1);
    integer ? AppendBits(this->Text, *integer) : AppendBits(this->Text, std::get<float>(value));
  }
  /// Adds a variable, except the place of its values, which depends on the size of the header.
  void AddVariable(const NetcdfVariable& variable)
  {
    this->AddText(variable.Name);
    this->AddCount(static_cast<Index>(variable.Dimensions.size()));
    for (std::size_t dimension : variable.Dimensions)
    {
      this->AddCount(static_cast<Index>(dimension));
    }
    this->AddList(ListOfAttributes, variable.Attributes.size());
    for (const NetcdfText& attribute : variable.Attributes)
    {
      this->AddText(attribute.Name);
      this->AddValue(attribute.Value);
    }
    AppendNumber(this->Text, TypeOf[static_cast<int>(variable.Kind)], 4);
    this->AddCount(Padded(CountBytes(this->Layout, variable)));
  }
  void AddVariables()
  {
    std::vector<std::size_t> places;
    this->AddList(ListOfVariables, this->Layout.Variables.size());
    for (const NetcdfVariable& variable : this->Layout.Variables)
    {
      this->AddVariable(variable);
      places.push_back(this->Text.size());
      AppendNumber(this->Text, 0, 8);
    }
    Index begin = static_cast<Index>(this->Text.size());
    for (bool ofRecords : { false, true })
    {
      for (std::size_t v = 0; v < places.size(); ++v)
      {
        const NetcdfVariable& variable = this->Layout.Variables[v];
        if (this->HasRecords(variable) == ofRecords)
        {
          std::string number;
          AppendNumber(number, static_cast<std::uint64_t>(begin), 8);
          this->Text.replace(places[v], 8, number);
          begin += Padded(CountBytes(this->Layout, variable));
          this->Ordered.push_back(&variable);
        }
      }
    }
  }
  bool HasRecords(const NetcdfVariable& variable) const
  {
    return !variable.Dimensions.empty() &&
      this->Layout.Dimensions[variable.Dimensions[0]].Length == 0;
  }

  const NetcdfLayout& Layout;
  const int CountSize;
  std::string Text;
  std::vector<const NetcdfVariable*> Ordered;
};

void AddValues(OutputFile& file, NetcdfKind kind, const NetcdfValues& values)
{
  if (const auto* text = std::get_if<std::string>(&values))
  {
    file.Add(*text);
    file.Add(std::string(Padded(text->size()) - text->size(), '\0'));
    return;
  }
  std::string bytes;
  const auto add = [&](const auto& numbers, const auto& append)
  {
    for (const auto& number : numbers)
    {
      bytes.clear();
      append(number);
      file.Add(bytes);
    }
  };
  if (const auto* reals = std::get_if<std::vector<double>>(&values))
  {
    add(*reals, [&](double real) { AppendBits(bytes, real); });
    return;
  }
  const int size = SizeOf[static_cast<int>(kind)];
  add(std::get<std::vector<Index>>(values),
    [&](Index number) { AppendNumber(bytes, static_cast<std::uint64_t>(number), size); });
}

void WriteClassic(
  const NetcdfLayout& layout, const std::string& path, bool isWide, OutputSet& files)
{
  OutputFile file(path, files);
  const ClassicHeader header(layout, isWide);
  file.Add(header.Bytes());
  for (const NetcdfVariable* variable : header.Order())
  {
    variable->Put([&](const NetcdfValues& values) { AddValues(file, variable->Kind, values); });
  }
  file.Close();
}

} // namespace

void WriteNetcdf(
  const NetcdfLayout& layout, const std::string& path, NetcdfFormat format, OutputSet& files)
{
  const bool isWide = format == NetcdfFormat::Wide;
  if (!isWide || !TryWriteNetcdf4(layout, path, files))
  {
    WriteClassic(layout, path, isWide, files);
  }
}

} // namespace vfm
