#include "WriteTable.h"

#include "TextFile.h"

#include <charconv>

namespace vfm
{
namespace
{

std::string Quoted(const std::string& text)
{
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

/// The shortest text that reads back as the same number.
std::string PrintNumber(double value)
{
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof(text), value).ptr);
}

std::string PrintValue(const FieldArray& column, std::size_t row)
{
  if (const auto* texts = std::get_if<std::vector<std::string>>(&column.Values))
  {
    return Quoted((*texts)[row]);
  }
  return std::visit(
    [row](const auto& values)
    {
      if constexpr (std::is_convertible_v<decltype(values[row]), double>)
      {
        return PrintNumber(static_cast<double>(values[row]));
      }
      return std::string();
    },
    column.Values);
}

} // namespace

void WriteTable(const std::vector<FieldArray>& columns, const std::string& path)
{
  TextFile file(path);
  const auto addLine = [&](const auto& print)
  {
    for (std::size_t c = 0; c < columns.size(); ++c)
    {
      file.Add(c > 0 ? "," : "");
      file.Add(print(columns[c]));
    }
    file.Add("\n");
  };
  addLine([](const FieldArray& column) { return Quoted(column.Name); });
  const std::size_t rows = columns.empty()
    ? 0
    : std::visit([](const auto& values) { return values.size(); }, columns[0].Values);
  for (std::size_t row = 0; row < rows; ++row)
  {
    addLine([row](const FieldArray& column) { return PrintValue(column, row); });
  }
  file.Close();
}

} // namespace vfm
