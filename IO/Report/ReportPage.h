/**
 * ReportPage: prints a quality report as one HTML page without scripts or other files.
 */
#pragma once

#include "Report/MeshFields.h"
#include "Report/QualityDistribution.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vfm
{

/// Names and their values, as plain texts.
using TextPairs = std::vector<std::pair<std::string, std::string>>;

/// What a front end knows of the run that made a mesh.
struct ReportHead
{
  std::string Title;
  TextPairs Facts;   ///< input, output, and how materials were found
  TextPairs Options; ///< options of the mesher that differ from their defaults
  std::vector<std::string> Warnings;
};

/// A side set and its size.
struct SideCount
{
  int Id = 0;
  std::string Name;
  Index Facets = 0;
};

/// All content of the page. Lengths have the unit of the input.
struct ReportContent
{
  ReportHead Head;
  std::optional<double> Time;
  bool IsTets = false;
  Index Points = 0;            ///< distinct points of the mesh
  FieldArrays Fields;          ///< fields of the mesh (MesherResult::Fields)
  FieldArrays Materials;       ///< table of materials (MesherResult::MaterialFields)
  QualityDistribution Quality; ///< empty if the quality was not computed
  std::vector<SideCount> SideSets;
};

/// Prints the page: run, counts, warnings, materials, quality, worst elements and side sets.
std::string PrintReportPage(const ReportContent& content);

} // namespace vfm
