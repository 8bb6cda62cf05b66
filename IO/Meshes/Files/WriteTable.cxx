#include "Meshes/Files/WriteTable.h"

#include "Meshes/Files/OutputFile.h"
#include "Report/UniqueNames.h"

#include <charconv>

namespace vfm
{
namespace
{

/// Returns a text in UTF-8, in quotes where necessary.
std::string Print(const std::string& any)
{
  const std::string text = ToUtf8(any);
  if (text.find_first_of(",\"\r\n") == std::string::npos)
  {
    return text;
  }
  std::string quoted = "\"";
  for (char c : text)
  {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + "\"";
}

/// Returns the shortest text that is read back as the same number.
template <class Number>
std::string Print(Number value)
{
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof(text), value).ptr);
}

std::size_t CountRows(const std::vector<FieldArray>& columns)
{
  return columns.empty()
    ? 0
    : std::visit([](const auto& values) { return values.size(); }, columns[0].Values);
}

} // namespace

void WriteTable(const std::vector<FieldArray>& columns, const std::string& path)
{
  OutputFile file(path);
  const auto addLine = [&](const auto& print)
  {
    for (const FieldArray& column : columns)
    {
      file.Add(&column == &columns[0] ? "" : ",");
      file.Add(print(column));
    }
    file.Add("\n");
  };
  addLine([](const FieldArray& column) { return Print(column.Name); });
  for (std::size_t row = 0; row < CountRows(columns); ++row)
  {
    addLine(
      [row](const FieldArray& column) {
        return std::visit([row](const auto& values) { return Print(values[row]); }, column.Values);
      });
  }
  file.Close();
}

} // namespace vfm
