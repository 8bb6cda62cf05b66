#include "ModifyMesh.h"

#include "Base/Sorted.h"
#include "Materials/UseLabels.h"
#include "Modify/AddLayers.h"
#include "Modify/MeshOfData.h"
#include "Modify/SplitInterfaces.h"
#include "Options/SetOptions.h"
#include "Ranks/MergeByKey.h"
#include "Ranks/WorkTogether.h"
#include "Report/GatherMesh.h"
#include "Report/MeshMaterials.h"

namespace vfm
{
namespace
{

/// Throws InputError if a mesh lacks what all modifications need.
void CheckMesh(const MeshData& mesh)
{
  Require(mesh.Material, "MaterialId", mesh);
  Require(mesh.Fragment, "FragmentId", mesh);
  Require(mesh.GeometryDimension, "GeometryDimension", mesh);
  Require(mesh.GeometryId, "GeometryId", mesh);
  if (mesh.MidsPerElement > 0)
  {
    throw InputError("The mesh has elements of second order. Layers are cut and interfaces are "
                     "split before mid nodes are added: set Element Order where it is meshed.");
  }
  if (mesh.OriginalPointIds)
  {
    throw InputError("The interfaces of the mesh are split already (OriginalPointIds).");
  }
}

/// Throws InputError if a mesh cannot get layers.
void CheckForLayers(const MeshData& mesh, const MesherOptions& options)
{
  if (FindArray(mesh.ElementArrays, "Layer"))
  {
    throw InputError("The mesh has layers already (array Layer).");
  }
  if (options.FirstLayer > 0.0 && options.FirstLayerUnit == ThicknessUnit::Cells)
  {
    throw InputError("FirstLayerUnit must be Length: a mesh does not know the width of its cells.");
  }
  if (FindField(mesh.Fields, "PeriodLengths"))
  {
    if (!mesh.PeriodicPartner && mesh.NumberOfPoints > 0)
    {
      throw InputError("Opposite sides of the mesh are joined: layers must be cut before, by the "
                       "filter that makes the mesh.");
    }
    if (FindField(mesh.Fields, "DomainFrame"))
    {
      throw InputError("The mesh is periodic along the axes of a rotated image: layers must be "
                       "cut by the filter that makes the mesh.");
    }
  }
  for (const MeshArray& array : ListOtherPointArrays(mesh))
  {
    throw InputError("The mesh has the point array " + array.Name +
      ", of which layers would have no values. Remove it first.");
  }
}

/// Throws InputError if an element occurs on several ranks.
/// @pre Collective
void CheckElementIds(const MeshData& mesh, Ranks& ranks)
{
  std::vector<std::array<Index, 1>> keys;
  for (Index e = 0; e < mesh.NumberOfElements; ++e)
  {
    keys.push_back({ { mesh.ElementIds[e] } });
  }
  const std::vector<int> counts =
    MergeByKey(keys, std::vector<int>(keys.size(), 1), std::plus<int>(), ranks);
  WorkTogether(ranks,
    [&]
    {
      const auto repeated = std::find_if(counts.begin(), counts.end(), [](int n) { return n > 1; });
      if (repeated != counts.end())
      {
        throw InputError("The element " + std::to_string(keys[repeated - counts.begin()][0]) +
          " (GlobalCellIds) is on several ranks.");
      }
    });
}

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

/// Returns the values of point arrays at the points of the split mesh.
std::vector<TransferredArray> CopyPointArrays(const MeshData& before, const Mesh& mesh)
{
  std::vector<Index> sources;
  for (Index id : mesh.UnsplitPointIds())
  {
    sources.push_back(
      std::lower_bound(before.PointIds, before.PointIds + before.NumberOfPoints, id) -
      before.PointIds);
  }
  std::vector<TransferredArray> copies;
  for (const MeshArray& array : ListOtherPointArrays(before))
  {
    const Index width = array.Components * WidthOfType(array.Type);
    Buffer<char> values(sources.size() * width);
    for (std::size_t p = 0; p < sources.size(); ++p)
    {
      const char* from = static_cast<const char*>(array.Values) + width * sources[p];
      std::copy_n(from, width, values.data() + width * p);
    }
    copies.push_back(
      { array.Name, array.Type, array.Components, array.ComponentNames, false, std::move(values) });
  }
  return copies;
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
      CheckMesh(data);
      if (options.Layers > 1)
      {
        CheckForLayers(data, options);
      }
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
