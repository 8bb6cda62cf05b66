#include "WriteTable.h"

#include "TextFile.h"

#include "vtkDataArray.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

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

std::string PrintValue(vtkAbstractArray* column, vtkIdType row)
{
  if (auto texts = vtkStringArray::SafeDownCast(column))
  {
    return Quoted(texts->GetValue(row));
  }
  auto numbers = vtkDataArray::SafeDownCast(column);
  return numbers ? PrintNumber(numbers->GetComponent(row, 0)) : "";
}

} // namespace

void WriteTable(vtkTable* table, const std::string& path)
{
  TextFile file(path);
  const auto addLine = [&](const auto& print)
  {
    for (vtkIdType c = 0; c < table->GetNumberOfColumns(); ++c)
    {
      file.Add(c > 0 ? "," : "");
      file.Add(print(table->GetColumn(c)));
    }
    file.Add("\n");
  };
  addLine([](vtkAbstractArray* column) { return Quoted(column->GetName()); });
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    addLine([row](vtkAbstractArray* column) { return PrintValue(column, row); });
  }
  file.Close();
}

} // namespace vfm
