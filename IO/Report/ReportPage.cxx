#include "Report/ReportPage.h"

#include "Report/HistogramSvg.h"
#include "Report/HtmlText.h"
#include "Report/MeshData.h"
#include "Report/MeshMaterials.h"
#include "Report/ReportStyle.h"

#include <algorithm>
#include <numeric>

namespace vfm
{
namespace
{

constexpr int QualityDecimals = 4, ErrorDigits = 3, AngleDecimals = 1;
constexpr const char* NoValue = "–";

std::string PrintSection(const std::string& title, const std::string& content)
{
  return "<section>\n<h2>" + HtmlText(title) + "</h2>\n" + content + "</section>\n";
}

std::string PrintParagraph(const std::string& text)
{
  return "<p>" + HtmlText(text) + "</p>\n";
}

const char* NameElements(const ReportContent& content)
{
  return content.IsTets ? "tetrahedra" : "hexahedra";
}

std::vector<std::string> TextsOf(const FieldArrays& fields, const std::string& name)
{
  const FieldArray* field = FindField(fields, name);
  const auto* texts = field ? std::get_if<std::vector<std::string>>(&field->Values) : nullptr;
  return texts ? *texts : std::vector<std::string>();
}

/// Returns the first number of a field; nothing if it is missing.
std::optional<double> NumberOf(const FieldArrays& fields, const std::string& name)
{
  const std::vector<double> numbers = NumbersOfField(fields, name);
  return numbers.empty() ? std::nullopt : std::optional<double>(numbers[0]);
}

double SumOf(const std::vector<double>& numbers)
{
  return std::accumulate(numbers.begin(), numbers.end(), 0.0);
}

std::string PrintIndex(double number)
{
  return PrintCount(static_cast<Index>(number));
}

/// Prints names and values as a list.
/// @param kind class of the list in the style
std::string PrintPairs(const TextPairs& pairs, const std::string& kind)
{
  std::string text = "<dl class=\"" + kind + "\">\n";
  for (const auto& [name, value] : pairs)
  {
    text += "<div><dt>" + HtmlText(name) + "</dt><dd>" + HtmlText(value) + "</dd></div>\n";
  }
  return text + "</dl>\n";
}

std::string PrintRun(const ReportContent& content)
{
  TextPairs facts = content.Head.Facts;
  if (content.Time)
  {
    facts.emplace_back("Time", PrintNumber(*content.Time));
  }
  facts.emplace_back("Made by", "VolumeFractionMesh " VFM_VERSION);
  return PrintSection("Run", PrintPairs(facts, "facts")) +
    PrintSection("Options",
      content.Head.Options.empty() ? PrintParagraph("All options have their defaults.")
                                   : PrintParagraph("These options differ from their defaults.") +
          PrintPairs(content.Head.Options, "facts"));
}

std::string PrintCounts(const ReportContent& content)
{
  const double elements = SumOf(NumbersOfField(content.Materials, "Elements"));
  TextPairs counts{ { content.IsTets ? "Tetrahedra" : "Hexahedra", PrintIndex(elements) },
    { "Points", PrintCount(content.Points) },
    { "Materials", std::to_string(TextsOf(content.Materials, "Name").size()) } };
  for (const char* name : { "Fragments", "Surfaces", "Curves", "Vertices" })
  {
    const std::optional<double> count = NumberOf(content.Fields, "NumberOf" + std::string(name));
    if (count)
    {
      counts.emplace_back(name, PrintIndex(*count));
    }
  }
  return PrintSection("Counts", PrintPairs(counts, "counts"));
}

std::string PrintWarnings(const std::vector<std::string>& warnings)
{
  if (warnings.empty())
  {
    return PrintSection("Warnings", PrintParagraph("There are no warnings."));
  }
  std::string list = "<ul class=\"warnings\">\n";
  for (const std::string& warning : warnings)
  {
    list += "<li>" + HtmlText(warning) + "</li>\n";
  }
  return PrintSection("Warnings", list + "</ul>\n");
}

/// Prints a volume error in percent; error: relative error.
std::string PrintError(double error, double target)
{
  return target > 0.0 ? (error > 0.0 ? "+" : "") + PrintNumber(100.0 * error, ErrorDigits)
                      : NoValue;
}

/// Counts of a material: the name of the column, and its title.
struct CountColumn
{
  const char *Name, *Head;
};

constexpr CountColumn CountColumns[] = { { "Fragments", "Fragments" },
  { "LostCells", "Lost cells" }, { "GainedCells", "Gained cells" } };

/// Prints the last row of the table of materials.
std::vector<std::string> SumMaterials(const ReportContent& content)
{
  const FieldArrays& materials = content.Materials;
  const double target = SumOf(NumbersOfField(materials, "TargetVolume"));
  const double volume = SumOf(NumbersOfField(materials, "MeshVolume"));
  std::vector<std::string> row{ "All", "", PrintIndex(SumOf(NumbersOfField(materials, "Elements"))),
    PrintNumber(target), PrintNumber(volume), PrintError(volume / target - 1.0, target) };
  for (const CountColumn& count : CountColumns)
  {
    row.push_back(PrintIndex(SumOf(NumbersOfField(materials, count.Name))));
  }
  for (const char* name : { "MinimumScaledJacobian", "MeanScaledJacobian" })
  {
    const std::optional<double> value = NumberOf(content.Fields, name);
    if (value)
    {
      row.push_back(PrintFixed(*value, QualityDecimals));
    }
  }
  return row;
}

std::string PrintMaterials(const ReportContent& content)
{
  const auto column = [&](const char* name) { return NumbersOfField(content.Materials, name); };
  const std::vector<double> ids = column("MaterialId"), targets = column("TargetVolume"),
                            volumes = column("MeshVolume"), errors = column("VolumeError"),
                            elements = column("Elements"), least = column("MinimumScaledJacobian"),
                            means = column("MeanScaledJacobian");
  const std::vector<std::string> names = TextsOf(content.Materials, "Name");
  HtmlTable table{ "Materials",
    { "Material", "Id", "Elements", "Fraction volume", "Mesh volume", "Error in %" }, {}, {} };
  for (const CountColumn& count : CountColumns)
  {
    table.Heads.push_back(count.Head);
  }
  if (!least.empty())
  {
    table.Heads.insert(table.Heads.end(), { "Smallest SJ", "Mean SJ" });
  }
  for (std::size_t m = 0; m < names.size(); ++m)
  {
    table.Rows.push_back({ HtmlText(names[m]), PrintFixed(ids[m], 0), PrintIndex(elements[m]),
      PrintNumber(targets[m]), PrintNumber(volumes[m]), PrintError(errors[m], targets[m]) });
    for (const CountColumn& count : CountColumns)
    {
      table.Rows.back().push_back(PrintIndex(column(count.Name).at(m)));
    }
    for (const std::vector<double>* values : { &least, &means })
    {
      if (!values->empty())
      {
        table.Rows.back().push_back(
          elements[m] > 0.0 ? PrintFixed((*values)[m], QualityDecimals) : NoValue);
      }
    }
  }
  if (names.size() > 1)
  {
    table.Foot = SumMaterials(content);
  }
  return PrintSection("Materials",
    PrintTable(table) +
      PrintParagraph("The fraction volume is the volume of the material in the input; the error "
                     "compares the mesh volume with it. Lost and gained cells changed their "
                     "material so that interfaces are manifold." +
        std::string(least.empty() ? "" : " SJ is the scaled Jacobian.")));
}

/// Prints the table of the surfaces of the input.
std::string PrintSurfaces(const ReportContent& content)
{
  const auto column = [&](const char* name) { return NumbersOfField(content.Materials, name); };
  const std::vector<double> thickness = column("SurfaceThickness"),
                            widths = column("SuggestedWidth"), lost = column("LostSurface"),
                            solids = column("Solids"), fragments = column("Fragments");
  const std::vector<std::string> names = TextsOf(content.Materials, "Name");
  HtmlTable table{ "Surfaces",
    { "Material", "Cells across", "Suggested cell width", "Lost area in %", "Solids", "Fragments" },
    {}, {} };
  for (std::size_t m = 0; m < thickness.size(); ++m)
  {
    if (thickness[m] > 0.0)
    {
      table.Rows.push_back({ HtmlText(names[m]), PrintNumber(thickness[m], ErrorDigits),
        PrintNumber(widths[m], ErrorDigits), PrintNumber(100.0 * lost[m], ErrorDigits),
        PrintIndex(solids[m]), PrintIndex(fragments[m]) });
    }
  }
  return table.Rows.empty()
    ? ""
    : PrintSection("Surfaces of the input",
        PrintTable(table) +
          PrintParagraph(
            "The thinnest 5 % of the surface have at most this number of cells across; in cells of "
            "the suggested width it is 2.5. Lost area is farther than a cell from the elements. "
            "More fragments than solids: thin places fell apart."));
}

/// Prints a histogram and, folded, the numbers that it shows.
std::string PrintHistogram(const Histogram& histogram, const HistogramTexts& texts)
{
  HtmlTable table{ "Counts of the histogram", { texts.Values, "Count" }, {}, {} };
  for (std::size_t bar = 0; bar < histogram.Counts.size(); ++bar)
  {
    table.Rows.push_back(
      { HtmlText(PrintInterval(histogram, bar, texts.Unit)), PrintCount(histogram.Counts[bar]) });
  }
  return "<figure>\n" + DrawHistogram(histogram, texts) +
    "</figure>\n<details>\n<summary>Counts of " + HtmlText(texts.Counts) + "</summary>\n" +
    PrintTable(table) + "</details>\n";
}

std::string PrintAngles(const ReportContent& content)
{
  Histogram angles{ 0.0, 180.0, {} };
  for (double count : NumbersOfField(content.Fields, "DihedralAngles"))
  {
    angles.Counts.push_back(static_cast<Index>(count));
  }
  if (angles.Counts.empty())
  {
    return "";
  }
  const auto angle = [&](const char* name)
  { return PrintFixed(NumberOf(content.Fields, name).value_or(0.0), AngleDecimals) + "°"; };
  return PrintSection("Dihedral angles",
    PrintParagraph("The smallest angle is " + angle("MinimumDihedralAngle") + ", the largest " +
      angle("MaximumDihedralAngle") + ".") +
      PrintHistogram(angles, { "Dihedral angle", "dihedral angles", "°" }));
}

std::string PrintQuality(const ReportContent& content)
{
  const std::optional<double> least = NumberOf(content.Fields, "MinimumScaledJacobian"),
                              mean = NumberOf(content.Fields, "MeanScaledJacobian");
  const Histogram& histogram = content.Quality.ScaledJacobian;
  if (!least || !mean || histogram.Counts.empty())
  {
    return PrintSection("Scaled Jacobian",
      PrintParagraph(least ? "The mesh has no elements."
                           : "The option ComputeQuality is off, so the quality is not known."));
  }
  return PrintSection("Scaled Jacobian",
    PrintParagraph("The smallest value is " + PrintFixed(*least, QualityDecimals) + ", the mean " +
      PrintFixed(*mean, QualityDecimals) + ". " +
      (content.IsTets ? "A regular tetrahedron has 1" : "A cube has 1") +
      ", an invalid element 0 or less.") +
      PrintHistogram(histogram, { "Scaled Jacobian", NameElements(content), "" }));
}

std::string PrintWorst(const ReportContent& content)
{
  if (content.Quality.Worst.empty())
  {
    return "";
  }
  std::map<int, std::string> names{ { 0, "Void" } };
  const std::vector<std::string> texts = TextsOf(content.Materials, "Name");
  const std::vector<double> ids = NumbersOfField(content.Materials, "MaterialId");
  for (std::size_t m = 0; m < texts.size(); ++m)
  {
    names[static_cast<int>(ids[m])] = texts[m];
  }
  HtmlTable table{ "Worst elements", { "Element", "Material", "Scaled Jacobian", "x", "y", "z" },
    {}, {}, 2 };
  for (const RatedElement& element : content.Quality.Worst)
  {
    table.Rows.push_back(
      { std::to_string(element.Id), HtmlText(NameOfMaterial(names, element.Material)),
        PrintFixed(element.Quality, QualityDecimals) });
    for (double x : element.Centroid)
    {
      table.Rows.back().push_back(PrintNumber(x));
    }
  }
  return PrintSection("Worst elements",
    PrintParagraph("The elements of the smallest scaled Jacobian, with their global ids "
                   "(GlobalCellIds) and centroids.") +
      PrintTable(table));
}

std::string PrintSideSets(const ReportContent& content)
{
  HtmlTable table{ "Side sets", { "Side set", "Id", "Facets" }, {}, {} };
  for (const SideCount& set : content.SideSets)
  {
    table.Rows.push_back({ HtmlText(set.Name), std::to_string(set.Id), PrintCount(set.Facets) });
  }
  return PrintSection("Side sets",
    table.Rows.empty() ? PrintParagraph("There are no side sets.") : PrintTable(table));
}

} // namespace

std::string PrintReportPage(const ReportContent& content)
{
  const std::string title = HtmlText(content.Head.Title);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<title>" +
    title + "</title>\n<style>\n" + ReportStyle + "</style>\n</head>\n<body>\n<main>\n<h1>" +
    title + "</h1>\n" + PrintCounts(content) + PrintWarnings(content.Head.Warnings) +
    PrintMaterials(content) + PrintSurfaces(content) + PrintQuality(content) +
    PrintAngles(content) + PrintWorst(content) + PrintSideSets(content) + PrintRun(content) +
    "</main>\n</body>\n</html>\n";
}

} // namespace vfm
