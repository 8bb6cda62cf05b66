#include "Report/MeshFields.h"

#include "Base/ParseText.h"
#include "Elements/FlatMesh.h"
#include "Levels/WideCells.h"
#include "Materials/MaterialTexts.h"
#include "Report/MeshData.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace vfm
{
namespace
{

bool IsTetMesh(const Mesh& mesh)
{
  return !mesh.HasHexes() && !IsFlat(mesh);
}

void AddCount(FieldArrays& fields, const char* name, Index count)
{
  fields.push_back({ name, std::vector<Index>{ count } });
}

void AddNumber(FieldArrays& fields, const char* name, double value)
{
  fields.push_back({ name, std::vector<double>{ value } });
}

void AddQuality(FieldArrays& fields, const Mesh& mesh, const MeshReport& report)
{
  AddNumber(fields, "MinimumScaledJacobian", report.MinimumScaledJacobian);
  AddNumber(fields, "MeanScaledJacobian", report.MeanScaledJacobian);
  if (IsTetMesh(mesh))
  {
    AddNumber(fields, "MinimumDihedralAngle", report.MinimumDihedralAngle);
    AddNumber(fields, "MaximumDihedralAngle", report.MaximumDihedralAngle);
    fields.push_back({ "DihedralAngles",
      std::vector<Index>(report.DihedralAngles.begin(), report.DihedralAngles.end()) });
  }
}

/// Adds a column; get: returns the value of an item.
template <class Item, class Get>
void AddColumn(
  FieldArrays& fields, const char* name, const std::vector<Item>& items, const Get& get)
{
  std::vector<decltype(get(items[0]))> values;
  for (const Item& item : items)
  {
    values.push_back(get(item));
  }
  fields.push_back({ name, std::move(values) });
}

/// Adds the counts of a mesh of several levels.
void AddLevels(FieldArrays& fields, const MeshReport& report)
{
  using Level = MeshReport::Level;
  if (report.Levels.empty())
  {
    return;
  }
  const std::vector<Level>& levels = report.Levels;
  AddColumn(fields, "RefinedCells", levels, [](const Level& l) { return l.Families; });
  AddColumn(
    fields, "CellsAddedForBalance", levels, [](const Level& l) { return l.AddedForBalance; });
  AddColumn(
    fields, "CellsAddedForValidity", levels, [](const Level& l) { return l.AddedForValidity; });
  AddColumn(fields, "LevelCells", levels, [](const Level& l) { return l.Cells; });
  AddCount(fields, "TransitionCells", report.TransitionCells);
}

std::vector<double> FindVolumeErrors(const MeshReport& report)
{
  std::vector<double> errors;
  for (std::size_t m = 0; m < report.TargetVolume.size(); ++m)
  {
    const double target = report.TargetVolume[m];
    errors.push_back(target > 0.0 ? report.MeshVolume[m] / target - 1.0 : 0.0);
  }
  return errors;
}

/// Adds one value per material; names: names of the arrays of names and ids.
void AddMaterials(FieldArrays& fields, const MeshReport& report, const Materials& table,
  bool meshVoid, std::array<const char*, 2> names)
{
  fields.push_back({ names[0], TakeMeshed(table.Names, meshVoid) });
  fields.push_back({ names[1], TakeMeshed(table.Labels, meshVoid) });
  fields.push_back({ "TargetVolume", TakeMeshed(report.TargetVolume, meshVoid) });
  fields.push_back({ "MeshVolume", TakeMeshed(report.MeshVolume, meshVoid) });
  fields.push_back({ "VolumeError", TakeMeshed(FindVolumeErrors(report), meshVoid) });
  if (!report.DisplacedVolume.empty())
  {
    fields.push_back({ "DisplacedVolume", TakeMeshed(report.DisplacedVolume, meshVoid) });
  }
  fields.push_back({ "LostCells", TakeMeshed(report.LostCells, meshVoid) });
  fields.push_back({ "GainedCells", TakeMeshed(report.GainedCells, meshVoid) });
}

} // namespace

FieldArrays ListReport(const Mesh& mesh, const MeshReport& report, const Materials& table,
  const MeshOptions& options, const CorrectedCells& corrected, const FieldArrays& targets)
{
  FieldArrays fields;
  AddMaterials(fields, report, table, options.MeshVoid, { { "MaterialNames", "MaterialIds" } });
  AppendFields(targets, fields);
  AddCount(fields, "NormalisedCells", corrected.Normalised);
  AddCount(fields, "ClippedCells", corrected.Clipped);
  AddCount(fields, "RemovedRegions", report.RemovedRegions);
  AddCount(fields, "RemovedCells", report.RemovedCells);
  AddCount(fields, "ChosenCells", report.ChosenCells);
  AddCount(fields, "FlippedCells", report.FlippedCells);
  AddCount(fields, "ResolveRounds", report.ResolveRounds);
  AddCount(fields, "ThinPartCells", report.ThinPartCells);
  AddCount(fields, "NarrowVoidCells", report.NarrowVoidCells);
  AddCount(fields, "NumberOfFragments", report.NumberOfFragments);
  AddCount(fields, "NumberOfSurfaces", report.NumberOfSurfaces);
  AddCount(fields, "NumberOfCurves", report.NumberOfCurves);
  AddCount(fields, "NumberOfVertices", report.NumberOfVertices);
  if (options.SharpEdges != SharpEdgeMode::Off)
  {
    AddCount(fields, "EdgePoints", report.EdgePoints);
    AddCount(fields, "CornerPoints", report.CornerPoints);
  }
  if (IsTetMesh(mesh))
  {
    AddCount(fields, "RefusedParts", report.RefusedParts);
  }
  AddLevels(fields, report);
  if (options.ComputeQuality)
  {
    AddQuality(fields, mesh, report);
  }
  return fields;
}

FieldArrays ListMaterials(
  const MeshReport& report, const Materials& table, const MeshOptions& options)
{
  using Material = MeshReport::Material;
  FieldArrays columns;
  AddMaterials(columns, report, table, options.MeshVoid, { { "Name", "MaterialId" } });
  const std::vector<Material> parts = TakeMeshed(report.Materials, options.MeshVoid);
  AddColumn(columns, "Elements", parts, [](const Material& m) { return m.Elements; });
  AddColumn(columns, "Fragments", parts, [](const Material& m) { return m.Fragments; });
  if (options.ComputeQuality)
  {
    AddColumn(columns, "MinimumScaledJacobian", parts,
      [](const Material& m) { return m.MinimumScaledJacobian; });
    AddColumn(
      columns, "MeanScaledJacobian", parts, [](const Material& m) { return m.MeanScaledJacobian; });
  }
  return columns;
}

namespace
{

void AddPatchNames(const GeometryTables& tables, FieldArrays& fields)
{
  if (!tables.PatchNames.empty())
  {
    fields.push_back({ "PatchNames", tables.PatchNames });
  }
}

} // namespace

FieldArrays ListSides(const GeometryTables& tables)
{
  const std::vector<int>& parts = tables.SurfaceParts;
  if (std::all_of(parts.begin(), parts.end(), [](int part) { return part <= 0; }))
  {
    return {};
  }
  const FieldArray facets = FieldOfRows("EdgeFacets", tables.EdgeFacets);
  if (!tables.HasAllSurfaces)
  {
    std::vector<int> sides, ids;
    for (std::size_t s = 0; s < parts.size(); ++s)
    {
      if (parts[s] > 0)
      {
        ids.push_back(tables.SurfaceIds[s]);
        sides.push_back(parts[s]);
      }
    }
    return { { "SurfaceIds", ids }, { "SurfaceParts", sides }, facets };
  }
  FieldArrays fields{ { "SurfaceParts", parts }, facets };
  AddPatchNames(tables, fields);
  return fields;
}

std::vector<std::array<Index, 5>> ReadEdgeFacets(const FieldArrays& fields)
{
  std::vector<std::array<Index, 5>> rows;
  const FieldArray* field = FindField(fields, "EdgeFacets");
  const auto* numbers = field ? std::get_if<std::vector<Index>>(&field->Values) : nullptr;
  for (std::size_t at = 0; numbers && field->Components == 5 && at + 5 <= numbers->size(); at += 5)
  {
    rows.emplace_back();
    std::copy_n(numbers->begin() + static_cast<std::ptrdiff_t>(at), 5, rows.back().begin());
  }
  return rows;
}

void AppendFields(FieldArrays more, FieldArrays& to)
{
  std::move(more.begin(), more.end(), std::back_inserter(to));
}

void ReplaceFields(const FieldArrays& newer, FieldArrays& fields)
{
  for (FieldArray& field : fields)
  {
    if (const FieldArray* found = FindField(newer, field.Name))
    {
      field = *found;
    }
  }
}

FieldArrays ListSurfaces(const GeometryTables& tables)
{
  FieldArrays fields{ FieldOfRows("SurfaceVolumes", tables.SurfaceVolumes),
    FieldOfRows("SurfaceMaterials", tables.SurfaceMaterials),
    { "SurfaceSides", tables.SurfaceSides }, { "SurfaceParts", tables.SurfaceParts },
    { "SurfaceAreas", tables.SurfaceAreas },
    FieldOfRows("SurfaceCentroids", tables.SurfaceCentroids),
    FieldOfRows("SurfaceNormals", tables.SurfaceNormals),
    FieldOfRows("VolumeSurfaces", tables.VolumeSurfaces) };
  AddPatchNames(tables, fields);
  if (!tables.HasAllSurfaces)
  {
    fields.push_back({ "SurfaceIds", tables.SurfaceIds });
  }
  return fields;
}

FieldArrays ListCurves(const GeometryTables& tables)
{
  FieldArrays fields{ { "CurveEnds", tables.CurveEnds },
    FieldOfRows("SurfaceCurves", tables.SurfaceCurves) };
  if (!tables.HasAllCurves)
  {
    fields.push_back({ "CurveIds", tables.CurveIds });
  }
  return fields;
}

FieldArrays ListVertices(const GeometryTables& tables)
{
  return { FieldOfRows("CurveVertices", tables.CurveVertices) };
}

FieldArrays ListDomain(
  const CartesianGrid& grid, const ImageFrame& frame, const std::array<bool, 3>& isPeriodic)
{
  std::vector<double> bounds, lengths;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double least = grid.Coordinates(axis).front(), most = grid.Coordinates(axis).back();
    bounds.insert(bounds.end(), { least, most });
    lengths.push_back(isPeriodic[axis] ? most - least : 0.0);
  }
  FieldArrays fields{ { "DomainBounds", std::move(bounds) } };
  if (isPeriodic != std::array<bool, 3>())
  {
    fields.push_back({ "PeriodLengths", std::move(lengths) });
  }
  if (!frame.IsIdentity())
  {
    std::vector<double> numbers(frame.Axes.begin(), frame.Axes.end());
    numbers.insert(numbers.end(), frame.Origin.begin(), frame.Origin.end());
    fields.push_back({ "DomainFrame", std::move(numbers) });
  }
  return fields;
}

namespace
{

constexpr double LargestQuietError = 0.01; // relative error of a volume without a warning
// Displaced share of a volume without a warning: in the cells of the input, and in wider ones,
// where the surfaces of small bodies move more.
constexpr double LargestQuietShare = 0.05, LargestQuietShareOfWide = 0.1;

/// Returns the materials with elements of which more than a share `limit` of the volume is wrong,
/// by this volume, descending.
/// @param wrong  returns the volume of a material that is wrong
template <class Volume>
std::vector<std::size_t> FindAbove(double limit, const MeshReport& report, const Volume& wrong)
{
  std::vector<std::size_t> found;
  for (std::size_t m = 1; m < report.TargetVolume.size(); ++m)
  {
    if (report.MeshVolume[m] > 0.0 && wrong(m) > limit * report.TargetVolume[m])
    {
      found.push_back(m);
    }
  }
  std::stable_sort(found.begin(), found.end(),
    [&wrong](std::size_t a, std::size_t b) { return wrong(a) > wrong(b); });
  return found;
}

/// Returns a material with its volume error, number of fragments and flips.
std::string DescribeError(const MeshReport& report, const Materials& table, std::size_t m)
{
  return NameMaterial(table, m) + " by " +
    PercentOf(report.MeshVolume[m] / report.TargetVolume[m] - 1.0, true) +
    " (fragments: " + std::to_string(report.Materials[m].Fragments) +
    ", cells lost: " + std::to_string(report.LostCells[m]) +
    ", gained: " + std::to_string(report.GainedCells[m]) + ")";
}

} // namespace

std::string DescribeLostMaterials(const MeshReport& report, const Materials& table)
{
  std::vector<std::string> lost;
  for (std::size_t m = 1; m < report.TargetVolume.size(); ++m)
  {
    if (report.TargetVolume[m] > 0.0 && report.MeshVolume[m] == 0.0)
    {
      lost.push_back(NameMaterial(table, m));
    }
  }
  return lost.empty() ? ""
                      : CountMaterials(lost.size(), "has", "have") +
      " no element, since no cell is left to them: " + Enumerate(lost) +
      ". In finer cells they may be kept (Refinement).";
}

std::string DescribeInexactMaterials(
  const MeshReport& report, const Materials& table, bool areLabels)
{
  const auto missing = [&report](std::size_t m)
  { return std::fabs(report.MeshVolume[m] - report.TargetVolume[m]); };
  std::vector<std::string> errors;
  for (std::size_t m : FindAbove(LargestQuietError, report, missing))
  {
    errors.push_back(DescribeError(report, table, m));
  }
  return errors.empty() ? ""
                        : CountMaterials(errors.size(), "misses its", "miss their") +
      (errors.size() == 1 ? " volume" : " volumes") + " by more than 1 %: " + Enumerate(errors) +
      ". Lost and gained cells changed their material so that interfaces are manifold. " +
      (areLabels ? "LabelSmoothing, a" : "A") +
      " larger MinimumRegionCells, or finer cells there (Refinement with RefineFlippedCells) may "
      "help.";
}

std::string DescribeDisplacedMaterials(
  const MeshReport& report, const Materials& table, const WideReport& wide, bool hasParticles)
{
  if (report.DisplacedVolume.empty())
  {
    return "";
  }
  const auto displaced = [&report](std::size_t m)
  { return report.DisplacedVolume[m] * report.TargetVolume[m]; };
  std::vector<std::string> shares;
  const double limit = wide.IsUsed() ? LargestQuietShareOfWide : LargestQuietShare;
  for (std::size_t m : FindAbove(limit, report, displaced))
  {
    shares.push_back(NameMaterial(table, m) + " " + PercentOf(report.DisplacedVolume[m]));
  }
  return shares.empty() ? ""
                        : CountMaterials(shares.size(), "has", "have") + " more than " +
      PercentOf(limit) + " of " + (shares.size() == 1 ? "its volume" : "their volumes") +
      " in another place than in the input: " + Enumerate(shares) +
      ". In the mesh this share is in other blocks of 4 x 4 x 4 cells, or in no element. " +
      (!wide.MaterialWidths.empty() ? "Smaller MaterialWidths or AllowedError"
          : wide.IsUsed()           ? "A smaller CellWidth"
                                    : "Finer cells in the input") +
      (hasParticles ? "" : ", or UnmeshedMaterial Particles for matter far from elements,") +
      " may help.";
}

FieldArrays ListReplaced(const WideReport& wide, bool meshVoid)
{
  if (!wide.IsUsed())
  {
    return {};
  }
  FieldArrays fields{ { "InputCells", TakeMeshed(wide.InputCells, meshVoid) },
    { "NewCells", TakeMeshed(wide.Cells, meshVoid) } };
  if (!wide.MaterialWidths.empty())
  {
    fields.push_back({ "MaterialWidths", TakeMeshed(wide.MaterialWidths, meshVoid) });
  }
  return fields;
}

std::string DescribeWideLosses(
  const MeshReport& report, const Materials& table, const WideReport& wide, bool areExact)
{
  std::vector<std::string> losses;
  double keeping = std::numeric_limits<double>::infinity();
  const bool haveOwn = !wide.MaterialWidths.empty();
  for (std::size_t m = 1; m < report.TargetVolume.size(); ++m)
  {
    const double target = report.TargetVolume[m], error = report.MeshVolume[m] - target;
    if (areExact ? std::fabs(error) > LargestQuietError * target
                 : target > 0.0 && report.MeshVolume[m] == 0.0)
    {
      std::ostringstream text;
      text << NameMaterial(table, m) << " by " << std::showpos << std::setprecision(2)
           << 100.0 * error / target << " %";
      losses.push_back(text.str());
      keeping = haveOwn ? keeping : std::min(keeping, wide.Keeping[m]);
    }
  }
  if (losses.empty())
  {
    return "";
  }
  const double width = *std::max_element(wide.Widths.begin(), wide.Widths.end());
  const std::string widest =
    wide.Halvings > 0 ? " to " + FormatNumber(std::ldexp(width, wide.Halvings)) : "";
  return "In cells of width " + FormatNumber(width) + widest + ", " +
    CountMaterials(losses.size(), "misses its", "miss their") +
    " volume by more than 1 %: " + Enumerate(losses) + ". " +
    (haveOwn ? "A smaller width in MaterialWidths, or a smaller AllowedError, should keep"
        : keeping > 0.0 ? "A CellWidth of " + FormatNumber(RoundDown(keeping)) + " should keep"
                        : "Only the cells of the input (CellWidth 0) keep") +
    (losses.size() == 1 ? " it." : " them.");
}

} // namespace vfm
