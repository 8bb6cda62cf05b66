#include "Meshes/Files/WriteTable.h"

#include "Meshes/Files/OutputFile.h"
#include "Ranks/WorkTogether.h"
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

/// Adds a line with a text per column to a file or a string.
template <class Add, class Text>
void AddLine(const std::vector<FieldArray>& columns, const Add& add, const Text& textOf)
{
  for (const FieldArray& column : columns)
  {
    add(&column == &columns[0] ? "" : ",");
    add(textOf(column));
  }
  add("\n");
}

template <class Add>
void AddRows(const std::vector<FieldArray>& columns, const Add& add)
{
  for (std::size_t row = 0; row < CountRows(columns); ++row)
  {
    AddLine(columns, add,
      [row](const FieldArray& column) {
        return std::visit([row](const auto& values) { return Print(values[row]); }, column.Values);
      });
  }
}

void SendRows(const std::vector<FieldArray>& columns, Ranks& ranks)
{
  std::vector<Bytes> lines(1);
  AddRows(columns,
    [&](std::string_view text) { lines[0].insert(lines[0].end(), text.begin(), text.end()); });
  ranks.Exchange({ 0 }, lines);
}

} // namespace

void WriteTable(const std::vector<FieldArray>& columns, const std::string& path, Ranks& ranks)
{
  WorkTogether(ranks,
    [&]
    {
      if (ranks.Rank() > 0)
      {
        SendRows(columns, ranks);
        return;
      }
      OutputFile file(path);
      const auto add = [&file](std::string_view text) { file.Add(text); };
      AddLine(columns, add, [](const FieldArray& column) { return Print(column.Name); });
      AddRows(columns, add);
      for (int rank = 1; rank < ranks.Count(); ++rank)
      {
        const Bytes lines = ranks.Exchange({ rank }, { Bytes() })[0];
        file.Add({ lines.data(), lines.size() });
      }
      file.Close();
    });
}

} // namespace vfm
