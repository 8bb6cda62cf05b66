/// Quality reports: content, escapes, equal bytes from any number of ranks, no file after a
/// failure.
#include "Report/WriteReport.h"
#include "FileCases.h"
#include "Report/HistogramSvg.h"
#include "Report/HtmlText.h"

#include <numeric>
#include <regex>

using namespace vfm;
using namespace vfm::testing;

namespace
{

ReportHead MakeHead()
{
  return { "Quality of <a> & \"b\"", { { "Input", "a<b>.vti" } }, { { "IsoValue", "0.3" } },
    { "Careful: x < 1 & y > 2." } };
}

/// Returns the page of the mesh of a number of ranks.
std::string WritePage(int ranks, MeshMaker make, const ReportHead& head = MakeHead())
{
  const Folder folder;
  const std::string path = folder / "mesh.html";
  WithMesh(ranks, make,
    [&](const FileCase& part, Ranks& group)
    {
      const bool isFirst = group.Rank() == 0; // other ranks have no texts
      WriteReport(part.Mesh, part.Materials, isFirst ? head : ReportHead(), path, group);
    });
  EXPECT_EQ(folder.CountFiles(), 1u);
  return ReadBytes(path);
}

std::size_t CountIn(const std::string& text, const std::string& word)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
  {
    ++count;
  }
  return count;
}

/// Returns the part of a page below a heading.
std::string SectionOf(const std::string& page, const std::string& title)
{
  const std::size_t begin = page.find("<h2>" + title + "</h2>");
  return begin == std::string::npos ? ""
                                    : page.substr(begin, page.find("</section>", begin) - begin);
}

/// Returns the texts of all cells and headers of tables.
std::vector<std::string> CellsOf(const std::string& text)
{
  const std::regex cell("<t[hd][^>]*>([^<]*)</t[hd]>");
  std::vector<std::string> cells;
  for (std::sregex_iterator at(text.begin(), text.end(), cell), end; at != end; ++at)
  {
    cells.push_back((*at)[1]);
  }
  return cells;
}

/// Expects that the elements of a page are closed in order; void elements have no end.
void ExpectNested(const std::string& page)
{
  const std::regex tag("<(/?)([a-z0-9]+)[^>]*?(/?)>");
  std::vector<std::string> open;
  for (std::sregex_iterator at(page.begin(), page.end(), tag), end; at != end; ++at)
  {
    const std::string name = (*at)[2];
    if ((*at)[1].length() > 0)
    {
      ASSERT_FALSE(open.empty());
      EXPECT_EQ(open.back(), name);
      open.pop_back();
    }
    else if ((*at)[3].length() == 0 && name != "meta")
    {
      open.push_back(name);
    }
  }
  EXPECT_TRUE(open.empty());
}

Index SumCounts(const Histogram& histogram)
{
  return std::accumulate(histogram.Counts.begin(), histogram.Counts.end(), Index{ 0 });
}

} // namespace

TEST(WriteReport, PagesAreTheSameFromAnyNumberOfRanks)
{
  for (const MeshMaker make : { MakeHexMesh, MakeTetMesh })
  {
    const std::string page = WritePage(1, make);
    EXPECT_GT(page.size(), 5000u);
    EXPECT_EQ(page, WritePage(2, make));
    EXPECT_EQ(page, WritePage(3, make));
  }
}

TEST(WriteReport, PagesNeedNothingElse)
{
  for (const MeshMaker make : { MakeHexMesh, MakeTetMesh })
  {
    const std::string page = WritePage(1, make);
    EXPECT_EQ(page.find("<!DOCTYPE html>\n<html lang=\"en\">"), 0u);
    for (const char* word : { "<script", "http:", "https:", "src=", "href=", "url(", "@import" })
    {
      EXPECT_EQ(page.find(word), std::string::npos) << word;
    }
    ExpectNested(page);
  }
}

TEST(WriteReport, TextsAreEscaped)
{
  const std::string page = WritePage(3, MakeHexMesh);
  EXPECT_EQ(page.find("<more>"), std::string::npos);
  EXPECT_EQ(page.find("<a>"), std::string::npos);
  EXPECT_EQ(CountIn(page, "Quality of &lt;a> &amp; &quot;b&quot;"), 2u); // title and heading
  EXPECT_NE(page.find("<dt>Input</dt><dd>a&lt;b>.vti</dd>"), std::string::npos);
  EXPECT_NE(page.find("<dt>IsoValue</dt><dd>0.3</dd>"), std::string::npos);
  EXPECT_NE(page.find("<li>Careful: x &lt; 1 &amp; y > 2.</li>"), std::string::npos);
  const std::string materials = SectionOf(page, "Materials");
  EXPECT_NE(materials.find("&quot;two&quot; &amp; &lt;more>"), std::string::npos);
  EXPECT_NE(
    SectionOf(page, "Side sets").find("&quot;two&quot; &amp; &lt;more>"), std::string::npos);
  EXPECT_EQ(HtmlText("a\x01\t\n\x7f"), "a\xef\xbf\xbd&#9;&#10;\xef\xbf\xbd");
}

TEST(WriteReport, ValuesAreThoseOfTheMesher)
{
  WithMesh(1, MakeTetMesh,
    [](const FileCase& part, Ranks& ranks)
    {
      const Folder folder;
      WriteReport(part.Mesh, part.Materials, {}, folder / "mesh.htm", ranks);
      const std::string page = ReadBytes(folder / "mesh.htm");
      const MeshReport& report = part.Report;
      const std::vector<std::string> cells = CellsOf(SectionOf(page, "Materials"));
      const auto at = std::find(cells.begin(), cells.end(), "one");
      ASSERT_LE(11, cells.end() - at);
      EXPECT_EQ(at[1], "1");
      EXPECT_EQ(at[2], PrintCount(report.Materials[1].Elements));
      EXPECT_EQ(at[3], PrintNumber(report.TargetVolume[1]));
      EXPECT_EQ(at[4], PrintNumber(report.MeshVolume[1]));
      EXPECT_EQ(at[6], PrintCount(report.Materials[1].Fragments));
      EXPECT_EQ(at[7], PrintCount(report.LostCells[1]));
      EXPECT_EQ(at[8], PrintCount(report.GainedCells[1]));
      EXPECT_EQ(at[9], PrintFixed(report.Materials[1].MinimumScaledJacobian, 4));
      EXPECT_EQ(at[10], PrintFixed(report.Materials[1].MeanScaledJacobian, 4));
      const std::string counts = SectionOf(page, "Counts");
      EXPECT_NE(counts.find("<dt>Tetrahedra</dt><dd>" + PrintCount(part.Mesh.NumberOfElements)),
        std::string::npos);
      EXPECT_NE(counts.find("<dt>Points</dt><dd>" + PrintCount(part.Mesh.NumberOfPoints)),
        std::string::npos);
      EXPECT_NE(counts.find("<dt>Surfaces</dt><dd>" + PrintCount(report.NumberOfSurfaces)),
        std::string::npos);
      const std::string angles = SectionOf(page, "Dihedral angles");
      EXPECT_NE(angles.find("smallest angle is " + PrintFixed(report.MinimumDihedralAngle, 1)),
        std::string::npos);
      EXPECT_EQ(CellsOf(angles)[2 + 2 * 9 + 1], PrintCount(report.DihedralAngles[9]));
      EXPECT_NE(SectionOf(page, "Side sets").find("x_min"), std::string::npos);
      EXPECT_NE(page.find("<dt>Time</dt><dd>0.5</dd>"), std::string::npos);
    });
}

TEST(WriteReport, SurfacesOfTheInputAreListed)
{
  ReportContent content;
  content.Materials = { { "Name", std::vector<std::string>{ "hull", "fluid" } },
    { "MaterialId", std::vector<int>{ 1, 2 } }, { "TargetVolume", std::vector<double>{ 1, 1 } },
    { "MeshVolume", std::vector<double>{ 1, 1 } }, { "VolumeError", std::vector<double>{ 0, 0 } },
    { "LostCells", std::vector<Index>{ 0, 0 } }, { "GainedCells", std::vector<Index>{ 0, 0 } },
    { "Elements", std::vector<Index>{ 9, 9 } }, { "Fragments", std::vector<Index>{ 3, 1 } } };
  const std::string heading = "Surfaces of the input";
  EXPECT_EQ(SectionOf(PrintReportPage(content), heading), "");
  AppendFields({ { "SurfaceThickness", std::vector<double>{ 0.75, 0 } },
                 { "SuggestedWidth", std::vector<double>{ 0.3, 0 } },
                 { "LostSurface", std::vector<double>{ 0.125, 0 } },
                 { "Solids", std::vector<Index>{ 1, 0 } } },
    content.Materials);
  const std::string page = PrintReportPage(content);
  ExpectNested(page);
  const std::vector<std::string> cells = CellsOf(SectionOf(page, heading));
  ASSERT_EQ(cells.size(), 12u); // the fluid has no surface
  EXPECT_EQ((std::vector<std::string>(cells.begin() + 6, cells.end())),
    (std::vector<std::string>{ "hull", "0.75", "0.3", "12.5", "1", "3" }));
}

TEST(WriteReport, HexesHaveNoAngles)
{
  const std::string page = WritePage(2, MakeHexMesh, {});
  EXPECT_EQ(page.find("Dihedral"), std::string::npos);
  EXPECT_NE(page.find("There are no warnings."), std::string::npos);
  EXPECT_NE(page.find("All options have their defaults."), std::string::npos);
  EXPECT_EQ(CountIn(SectionOf(page, "Worst elements"), "<tr>"), 11u); // head and ten elements
}

TEST(WriteReport, WithoutQualityThePageSaysSo)
{
  MeshOptions options;
  options.ComputeQuality = false;
  const Folder folder;
  WithMesh(
    2, MakeHexMesh,
    [&](const FileCase& part, Ranks& ranks)
    { WriteReport(part.Mesh, part.Materials, {}, folder / "mesh.html", ranks); },
    options);
  const std::string page = ReadBytes(folder / "mesh.html");
  EXPECT_NE(page.find("ComputeQuality is off"), std::string::npos);
  EXPECT_EQ(page.find("Worst elements"), std::string::npos);
  EXPECT_EQ(page.find("Smallest SJ"), std::string::npos);
}

TEST(WriteReport, WorstElementsAreThoseOfAllRanks)
{
  std::vector<double> all;
  WithMesh(1, MakeHexMesh,
    [&](const FileCase& part, Ranks&)
    {
      const MeshArray& quality = GetArray(part.Mesh.ElementArrays, "ScaledJacobian");
      for (Index e = 0; e < part.Mesh.NumberOfElements; ++e)
      {
        all.push_back(ValueAt(quality, e));
      }
    });
  std::sort(all.begin(), all.end());
  WithMesh(3, MakeHexMesh,
    [&](const FileCase& part, Ranks& ranks)
    {
      const QualityDistribution found = FindQualityDistribution(part.Mesh, 5, ranks);
      ASSERT_EQ(found.Worst.size(), 5u);
      for (std::size_t e = 0; e < 5; ++e)
      {
        EXPECT_EQ(found.Worst[e].Quality, all[e]);
      }
      EXPECT_EQ(found.ScaledJacobian.Counts.size(), 20u);
      EXPECT_EQ(SumCounts(found.ScaledJacobian), static_cast<Index>(all.size()));
      const auto below =
        std::count_if(all.begin(), all.end(), [](double value) { return value < 0.5; });
      EXPECT_EQ(
        SumCounts({ 0.0, 0.5,
          { found.ScaledJacobian.Counts.begin(), found.ScaledJacobian.Counts.begin() + 10 } }),
        below);
    });
}

TEST(WriteReport, NegativeValuesAreShown)
{
  const double points[] = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  const Index elements[] = { 0, 1, 2, 3, 0, 2, 1, 3 }, ids[] = { 7, 8 };
  const int materials[] = { 1, 1 };
  const double quality[] = { 0.5, -0.5 };
  MeshData mesh;
  mesh.Corners = 4;
  mesh.NumberOfPoints = 4;
  mesh.NumberOfElements = 2;
  mesh.Points = points;
  mesh.Elements = elements;
  mesh.ElementIds = ids;
  mesh.Material = materials;
  mesh.ElementArrays.push_back({ "ScaledJacobian", ValueType::Double, 1, {}, quality });
  Ranks alone;
  const QualityDistribution found = FindQualityDistribution(mesh, 1, alone);
  EXPECT_EQ(found.ScaledJacobian.Lower, -1.0);
  EXPECT_EQ(found.ScaledJacobian.Counts[10], 1);
  EXPECT_EQ(found.ScaledJacobian.Counts[30], 1);
  ASSERT_EQ(found.Worst.size(), 1u);
  EXPECT_EQ(found.Worst[0].Id, 8);
  EXPECT_NEAR(found.Worst[0].Centroid[0], 0.25, 1e-15);
}

TEST(WriteReport, RareValuesHaveAVisibleBar)
{
  const std::string drawn =
    DrawHistogram({ 0.0, 1.0, { 1, 0, 5000000, 10 } }, { "Scaled Jacobian", "hexahedra", "" });
  EXPECT_EQ(CountIn(drawn, "<rect"), 3u); // none without values
  EXPECT_NE(drawn.find("height=\"2\"><title>0 to 0.25: 1 hexahedra"), std::string::npos) << drawn;
  EXPECT_NE(drawn.find("0.5 to 0.75: 5,000,000 hexahedra"), std::string::npos);
  // The labels of the vertical axis end at their x and have about 6.8 units per character.
  const std::regex label("x=\"([0-9.]+)\" y=\"[0-9.]+\" text-anchor=\"end\">5,000,000<");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(drawn, found, label)) << drawn;
  EXPECT_GE(std::stod(found[1]), 9 * 6.5);
}

TEST(WriteReport, PagesThatCannotBeWrittenAreNotLeft)
{
  const Folder folder;
  std::filesystem::create_symlink("/dev/full", folder / "full.html");
  for (const auto& [name, reason] :
    std::vector<std::pair<std::string, std::string>>{
      { "mesh.pdf", "Supported formats: .html, .htm" },
      { "no/mesh.html", "No such file or directory" }, { "full.html", "No space left on device" } })
  {
    WithMesh(2, MakeHexMesh,
      [&, name = name, reason = reason](const FileCase& part, Ranks& ranks)
      {
        try
        {
          WriteReport(part.Mesh, part.Materials, MakeHead(), folder / name, ranks);
          ADD_FAILURE() << name;
        }
        catch (const InputError& error)
        {
          const std::string message = error.what();
          EXPECT_NE(message.find(folder / name), std::string::npos) << message;
          EXPECT_NE(message.find(reason), std::string::npos) << message;
        }
      });
  }
  EXPECT_EQ(folder.CountFiles(), 1u);
}
