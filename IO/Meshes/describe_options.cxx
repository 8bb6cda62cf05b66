/**
 * describe_options: prints the tables of options and formats as JSON, for scripts/generate.
 */
#include "Base/ParseText.h"
#include "Meshes/FormatTable.h"
#include "Options/SetOptions.h"

#include <iostream>

namespace vfm
{
namespace
{

/// Names of kinds, indexed by OptionKind.
constexpr const char* KindNames[] = { "switch", "integer", "real", "choice", "array", "file",
  "arrays", "kinds", "pairs", "ranges", "widths", "sizes", "boxes" };

std::string Quote(const std::string& text)
{
  std::string quoted = "\"";
  for (char c : text)
  {
    quoted += c == '"' || c == '\\' ? "\\" : "";
    quoted += c;
  }
  return quoted + "\"";
}

std::string List(const std::vector<std::string>& texts)
{
  std::vector<std::string> quoted;
  for (const std::string& text : texts)
  {
    quoted.push_back(Quote(text));
  }
  return "[" + JoinTexts(quoted) + "]";
}

const char* Truth(bool is)
{
  return is ? "true" : "false";
}

/// Returns a limit as JSON: a number, or null if infinite.
std::string End(double number)
{
  return std::abs(number) <= std::numeric_limits<double>::max() ? FormatNumber(number) : "null";
}

void Print(const Option& option, std::ostream& to)
{
  const MesherOptions defaults;
  const OptionRange& range = option.Range;
  to << "  {\"name\": " << Quote(option.Name) << ", \"kind\": \""
     << KindNames[static_cast<int>(option.Kind)] << "\", \"words\": " << List(option.Words)
     << ", \"least\": " << End(range.Least) << ", \"most\": " << End(range.Most)
     << ", \"special\": " << (range.Special ? FormatNumber(*range.Special) : "null")
     << ", \"meaning\": " << Quote(range.Meaning)
     << ",\n   \"allowed\": " << Quote(option.Allowed())
     << ", \"default\": " << Quote(GetOption(defaults, option))
     << ", \"number\": " << (option.GetNumber ? FormatNumber(option.GetNumber(defaults)) : "null")
     << ",\n   \"tets\": " << Truth(option.OnlyTets) << ", \"group\": " << Quote(option.Group)
     << ", \"shown\": " << Quote(option.Shown) << ", \"enabled\": " << Quote(option.Enabled)
     << ", \"advanced\": " << Truth(option.IsAdvanced) << ", \"listed\": " << Truth(option.IsListed)
     << ", \"vectors\": " << Truth(option.TakesVectors)
     << ", \"hidden_of_tets\": " << Truth(option.IsHiddenOfTets)
     << ", \"python\": " << Quote(option.Python) << ", \"argument\": " << Quote(option.Argument)
     << ",\n   \"text\": " << Quote(option.Meaning)
     << ",\n   \"text_of_tets\": " << Quote(option.MeaningOfTets) << "}";
}

void Print(const FormatRow& format, std::ostream& to)
{
  to << "  {\"suffixes\": " << List(format.Suffixes) << ", \"name\": " << Quote(format.Name)
     << ", \"content\": " << Quote(format.Content) << ", \"options\": " << List(format.Options)
     << ", \"per_rank\": " << Truth(format.IsPerRank)
     << ", \"in_package\": " << Truth(format.IsInPackage) << "}";
}

template <class Table>
void PrintTable(const char* name, const Table& table, std::ostream& to)
{
  to << Quote(name) << ": [\n";
  const char* separator = "";
  for (const auto& row : table)
  {
    to << separator;
    Print(row, to);
    separator = ",\n";
  }
  to << "\n]";
}

} // namespace
} // namespace vfm

int main()
{
  std::cout << "{";
  vfm::PrintTable("options", vfm::GetOptionTable(), std::cout);
  std::cout << ",\n";
  vfm::PrintTable("formats", vfm::GetFormatTable(), std::cout);
  std::cout << "}\n";
  return 0;
}
