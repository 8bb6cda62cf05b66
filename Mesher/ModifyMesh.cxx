#include "ModifyMesh.h"

#include "Materials/UseLabels.h"
#include "Modify/AddLayers.h"
#include "Modify/MeshOfData.h"
#include "Modify/SplitInterfaces.h"
#include "Options/SetOptions.h"
#include "Ranks/WorkTogether.h"
#include "Report/Gather/GatherMesh.h"
#include "Report/MeshMaterials.h"

namespace vfm
{
namespace
{

/// Returns the names of materials by label.
std::map<int, std::string> NamesOf(const std::vector<int>& labels, const MeshData& mesh)
{
  const std::map<int, std::string> known = NamesOfMaterials(mesh);
  std::map<int, std::string> names = known;
  for (int label : labels)
  {
    names[label] = NameOfMaterial(known, label);
  }
  return names;
}

/// Replaces the fields that layers change, and lists such columns of the table of materials.
void UpdateFields(const std::vector<int>& labels, ModifiedMesh& result)
{
  const MeshReport& report = result.Report;
  std::vector<Index> elements;
  std::vector<double> minimum, mean;
  for (const MeshReport::Material& material : report.Materials)
  {
    elements.push_back(material.Elements);
    minimum.push_back(material.MinimumScaledJacobian);
    mean.push_back(material.MeanScaledJacobian);
  }
  result.MaterialFields = { { "MaterialId", labels }, { "Elements", elements },
    { "MinimumScaledJacobian", minimum }, { "MeanScaledJacobian", mean } };
  FieldArrays newer = ListSides(result.TheMesh.Tables);
  newer.push_back({ "MinimumScaledJacobian", std::vector<double>{ report.MinimumScaledJacobian } });
  newer.push_back({ "MeanScaledJacobian", std::vector<double>{ report.MeanScaledJacobian } });
  ReplaceFields(newer, result.Fields);
}

/// Cuts layers into a mesh whose materials are numbers of labels.
void CutLayersOf(const MeshData& data, const MesherOptions& given, const std::vector<int>& labels,
  const MaterialPairs* pairs, Runtime& runtime, ModifiedMesh& result)
{
  Mesh& mesh = result.TheMesh;
  if (mesh.Surfaces.SurfaceId.empty())
  {
    AddSurfaces(data, runtime.Group(), mesh);
  }
  MesherOptions options = given;
  options.ComputeQuality = runtime.Group().Any(!mesh.ScaledJacobian.empty());
  Vector3 periods{};
  const std::vector<double> lengths = NumbersOfField(data.Fields, "PeriodLengths");
  std::copy(lengths.begin(), lengths.begin() + (lengths.size() == 3 ? 3 : 0), periods.begin());
  result.Report.Materials.resize(labels.size());
  AddLayers(options, { 0.0, periods, labels, pairs }, runtime, mesh, result.State, result.Report);
  UpdateFields(labels, result);
}

/// Checks options and mesh, and returns the state.
/// @pre Collective
OutputState CheckInput(const MeshData& data, const MesherOptions& options,
  const std::vector<std::string>& extensive, Ranks& ranks)
{
  OutputState state;
  WorkTogether(ranks,
    [&]
    {
      CheckOptions(options);
      CheckMesh(data, options);
      state = MakeStateOf(data, extensive);
    });
  CheckElementIds(data, ranks);
  return state;
}

/// Returns the materials of all ranks, ascending, with void.
/// @pre Collective
std::vector<int> ListLabels(const MeshData& data, Ranks& ranks)
{
  std::vector<int> labels = FindMaterials(data, ranks);
  if (labels.front() != 0)
  {
    labels.insert(labels.begin(), 0);
  }
  return labels;
}

} // namespace

ModifiedMesh ModifyMesh(ModifyInput input, const MesherOptions& given, Runtime& runtime)
{
  Ranks& ranks = runtime.Group();
  const StoredMesh ordered = OrderMesh(input.Data, ranks);
  const MeshData& data = ordered.Data;
  MesherOptions options = given;
  options.Elements = data.HasHexes() ? ElementKind::Hexes : ElementKind::Tets;
  ModifiedMesh result;
  result.Fields = data.Fields;
  result.State = CheckInput(data, options, input.Extensive, ranks);
  const std::vector<int> labels = ListLabels(data, ranks);
  std::optional<MaterialPairs> split, layers;
  WorkTogether(ranks,
    [&]
    {
      const std::map<int, std::string> names = NamesOf(labels, data);
      split = ReadPairs("SplitInterfaces", options.SplitInterfaces, names);
      layers = ReadPairs("LayerInterfaces", options.LayerInterfaces, names);
    });
  result.TheMesh = MakeMeshOf(data, labels, ranks);
  SetGeometry(labels, std::move(input.Surfaces), std::move(input.Curves), result.TheMesh);
  if (options.Layers > 1)
  {
    CutLayersOf(data, options, labels, layers ? &*layers : nullptr, runtime, result);
  }
  UseLabels({ {}, labels }, result.TheMesh);
  if (split)
  {
    result.Cohesive =
      SplitMesh(*split, options, input.Warn, runtime, result.Fields, result.TheMesh, result.State);
  }
  result.PointArrays = CopyPointArrays(data, result.TheMesh);
  return result;
}

} // namespace vfm
