#include "ReportOutput.h"

#include "FieldValues.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

namespace vfm
{
namespace
{

bool IsTetMesh(const Mesh& mesh)
{
  return mesh.Corners == 4;
}

/// Of the materials that are meshed.
template <class Value>
std::vector<Value> TakeMeshed(const std::vector<Value>& values, bool meshVoid)
{
  const std::size_t first = meshVoid ? 0 : 1;
  return { values.begin() + std::min(first, values.size()), values.end() };
}

void AddCount(vtkFieldData* field, const char* name, Index count)
{
  AddFieldValues<vtkIdTypeArray>(field, name, std::vector<Index>{ count });
}

void AddNumber(vtkFieldData* field, const char* name, double value)
{
  AddFieldValues<vtkDoubleArray>(field, name, std::vector<double>{ value });
}

void AddQuality(vtkFieldData* field, const Mesh& mesh, const MeshReport& report)
{
  AddNumber(field, "MinimumScaledJacobian", report.MinimumScaledJacobian);
  AddNumber(field, "MeanScaledJacobian", report.MeanScaledJacobian);
  if (IsTetMesh(mesh))
  {
    AddNumber(field, "MinimumDihedralAngle", report.MinimumDihedralAngle);
    AddNumber(field, "MaximumDihedralAngle", report.MaximumDihedralAngle);
    AddFieldValues<vtkIdTypeArray>(field, "DihedralAngles",
      std::vector<Index>(report.DihedralAngles.begin(), report.DihedralAngles.end()));
  }
}

/// Of a mesh of several levels.
void AddLevels(vtkFieldData* field, const MeshReport& report)
{
  if (report.Levels.empty())
  {
    return;
  }
  std::vector<Index> families, forBalance, forValidity, cells;
  for (const MeshReport::Level& level : report.Levels)
  {
    families.push_back(level.Families);
    forBalance.push_back(level.AddedForBalance);
    forValidity.push_back(level.AddedForValidity);
    cells.push_back(level.Cells);
  }
  AddFieldValues<vtkIdTypeArray>(field, "RefinedCells", families);
  AddFieldValues<vtkIdTypeArray>(field, "CellsAddedForBalance", forBalance);
  AddFieldValues<vtkIdTypeArray>(field, "CellsAddedForValidity", forValidity);
  AddFieldValues<vtkIdTypeArray>(field, "LevelCells", cells);
  AddCount(field, "TransitionCells", report.TransitionCells);
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

/// get: the value of a material.
template <class Array, class Get>
void AddColumn(const std::vector<MeshReport::Material>& materials, const char* name,
  vtkTable* table, const Get& get)
{
  std::vector<decltype(get(materials[0]))> values;
  for (const MeshReport::Material& material : materials)
  {
    values.push_back(get(material));
  }
  table->AddColumn(MakeColumn<Array>(name, values));
}

} // namespace

void SetReportOutput(const Mesh& mesh, const MeshReport& report, const Materials& table,
  const MeshOptions& options, const MendedCells& mended, vtkDataObject* output)
{
  const bool isVoid = options.MeshVoid;
  vtkFieldData* field = output->GetFieldData();
  AddFieldValues<vtkStringArray>(field, "MaterialNames", TakeMeshed(table.Names, isVoid));
  AddFieldValues<vtkIntArray>(field, "MaterialIds", TakeMeshed(table.Labels, isVoid));
  AddFieldValues<vtkDoubleArray>(field, "TargetVolume", TakeMeshed(report.TargetVolume, isVoid));
  AddFieldValues<vtkDoubleArray>(field, "MeshVolume", TakeMeshed(report.MeshVolume, isVoid));
  AddFieldValues<vtkDoubleArray>(
    field, "VolumeError", TakeMeshed(FindVolumeErrors(report), isVoid));
  AddFieldValues<vtkDoubleArray>(
    field, "FragmentTargetVolume", TakeMeshed(report.FragmentTargetVolume, false));
  AddCount(field, "NormalisedCells", mended.Normalised);
  AddCount(field, "ClippedCells", mended.Clipped);
  AddCount(field, "RemovedRegions", report.RemovedRegions);
  AddCount(field, "RemovedCells", report.RemovedCells);
  AddCount(field, "ChosenCells", report.ChosenCells);
  AddCount(field, "FlippedCells", report.FlippedCells);
  AddCount(field, "ResolveRounds", report.ResolveRounds);
  AddCount(field, "NumberOfFragments", report.NumberOfFragments);
  AddCount(field, "NumberOfSurfaces", report.NumberOfSurfaces);
  AddCount(field, "NumberOfCurves", report.NumberOfCurves);
  AddCount(field, "NumberOfVertices", report.NumberOfVertices);
  if (options.Edges != SharpEdges::Off)
  {
    AddCount(field, "EdgePoints", report.EdgePoints);
    AddCount(field, "CornerPoints", report.CornerPoints);
  }
  if (IsTetMesh(mesh))
  {
    AddCount(field, "RefusedParts", report.RefusedParts);
  }
  AddLevels(field, report);
  if (options.ComputeQuality)
  {
    AddQuality(field, mesh, report);
  }
}

void SetMaterialTable(
  const MeshReport& report, const Materials& table, const MeshOptions& options, vtkTable* output)
{
  using Material = MeshReport::Material;
  const bool isVoid = options.MeshVoid;
  output->AddColumn(MakeColumn<vtkStringArray>("Name", TakeMeshed(table.Names, isVoid)));
  output->AddColumn(MakeColumn<vtkIntArray>("MaterialId", TakeMeshed(table.Labels, isVoid)));
  output->AddColumn(
    MakeColumn<vtkDoubleArray>("TargetVolume", TakeMeshed(report.TargetVolume, isVoid)));
  output->AddColumn(
    MakeColumn<vtkDoubleArray>("MeshVolume", TakeMeshed(report.MeshVolume, isVoid)));
  output->AddColumn(
    MakeColumn<vtkDoubleArray>("VolumeError", TakeMeshed(FindVolumeErrors(report), isVoid)));
  const std::vector<Material> parts = TakeMeshed(report.Materials, isVoid);
  AddColumn<vtkIdTypeArray>(
    parts, "Elements", output, [](const Material& m) { return m.Elements; });
  AddColumn<vtkIdTypeArray>(
    parts, "Fragments", output, [](const Material& m) { return m.Fragments; });
  if (options.ComputeQuality)
  {
    AddColumn<vtkDoubleArray>(parts, "MinimumScaledJacobian", output,
      [](const Material& m) { return m.MinimumScaledJacobian; });
    AddColumn<vtkDoubleArray>(
      parts, "MeanScaledJacobian", output, [](const Material& m) { return m.MeanScaledJacobian; });
  }
}

std::string DescribeLostMaterials(const MeshReport& report, const Materials& table)
{
  constexpr std::size_t MostNames = 20;
  std::vector<std::string> lost;
  for (std::size_t m = 1; m < report.TargetVolume.size(); ++m)
  {
    if (report.TargetVolume[m] > 0.0 && report.MeshVolume[m] == 0.0)
    {
      lost.push_back("'" + table.Names[m] + "' (id " + std::to_string(table.Labels[m]) + ")");
    }
  }
  std::string list;
  for (std::size_t l = 0; l < std::min(lost.size(), MostNames); ++l)
  {
    list += (l > 0 ? ", " : "") + lost[l];
  }
  if (lost.size() > MostNames)
  {
    list += " and " + std::to_string(lost.size() - MostNames) + " more";
  }
  return lost.empty()
    ? ""
    : std::to_string(lost.size()) + (lost.size() == 1 ? " material has" : " materials have") +
      " no element, since no cell is left to them: " + list +
      ". In finer cells they may be kept (Refinement).";
}

} // namespace vfm
