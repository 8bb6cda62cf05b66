#include "Report/WriteReport.h"

#include "FileSuffix.h"
#include "Meshes/Files/OutputFile.h"
#include "Options/SetOptions.h"
#include "Ranks/WorkTogether.h"
#include "Report/FlatData.h"
#include "Report/PointCounts.h"
#include "Report/Sets/MeshSets.h"

namespace vfm
{
namespace
{

constexpr std::size_t ListedElements = 10;

/// Counts the facets of each side set over all ranks.
std::vector<SideCount> CountSides(const MeshData& mesh, Ranks& ranks)
{
  const MeshSets sets = FindMeshSets(mesh, ranks);
  std::vector<std::int64_t> facets;
  for (const SideSet& set : sets.SideSets)
  {
    facets.push_back(static_cast<std::int64_t>(set.Sides.size()));
  }
  ranks.Sum(facets);
  std::vector<SideCount> counts;
  for (std::size_t s = 0; s < facets.size(); ++s)
  {
    counts.push_back({ sets.SideSets[s].Id, sets.SideSets[s].Name, facets[s] });
  }
  return counts;
}

Index CountAllPoints(const MeshData& mesh, Ranks& ranks)
{
  return CountPoints(mesh, std::vector<int>(mesh.NumberOfElements, 0), 1, ranks)[0];
}

ReportContent CollectContent(
  const MeshData& mesh, const FieldArrays& materials, const ReportHead& head, Ranks& ranks)
{
  Require(mesh.PointIds, "GlobalPointIds", mesh);
  if (IsFlat(mesh))
  {
    throw InputError("Quality reports are not written for meshes of a plane (option Flat). Without "
                     "Flat the layer has solid elements.");
  }
  ReportContent content;
  content.Head = head;
  content.Time = mesh.Time;
  content.IsTets = mesh.Corners == 4;
  content.Points = CountAllPoints(mesh, ranks);
  content.Fields = mesh.Fields;
  content.Materials = materials;
  content.Quality = FindQualityDistribution(mesh, ListedElements, ranks);
  content.SideSets = CountSides(mesh, ranks);
  return content;
}

} // namespace

std::string FindReportProblem(const std::string& path)
{
  return HasSuffix(path, ".html") || HasSuffix(path, ".htm")
    ? ""
    : "The report " + path + " is of an unknown format. Supported formats: .html, .htm.";
}

TextPairs ListReportOptions(const MesherOptions& options)
{
  TextPairs texts;
  for (const Option* option : ListChangedOptions(options))
  {
    texts.emplace_back(option->Name, GetOption(options, *option));
  }
  return texts;
}

void WriteReport(const MeshData& mesh, const FieldArrays& materials, const ReportHead& head,
  const std::string& path, Ranks& ranks)
{
  WorkTogether(ranks,
    [&]
    {
      const std::string problem = FindReportProblem(path);
      if (!problem.empty())
      {
        throw InputError(problem);
      }
      PrefixErrors("Cannot write the report " + path + ": ",
        [&]
        {
          const std::string page = PrintReportPage(CollectContent(mesh, materials, head, ranks));
          if (ranks.Rank() == 0)
          {
            OutputFile file(path);
            file.Add(page);
            file.Close();
          }
        });
    });
}

} // namespace vfm
