#include "ModifyMesh.h"

#include "Base/Sorted.h"
#include "Input/UseLabels.h"
#include "Modify/AddLayers.h"
#include "Modify/MeshOfData.h"
#include "Modify/SplitInterfaces.h"
#include "Options/SetOptions.h"
#include "Ranks/MergeByKey.h"
#include "Ranks/WorkTogether.h"
#include "State/ViewMesh.h"
#include "Summary/GatherMesh.h"
#include "Summary/MeshMaterials.h"

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

/// Returns the pairs of materials in an option, or nothing if it is empty.
std::optional<MaterialPairs> ReadPairs(const std::string& option, const std::string& text,
  const std::vector<int>& labels, const MeshData& mesh)
{
  if (text.empty())
  {
    return std::nullopt;
  }
  const std::map<int, std::string> known = NamesOfMaterials(mesh);
  std::map<int, std::string> names = known;
  for (int label : labels)
  {
    names[label] = NameOfMaterial(known, label);
  }
  return MaterialPairs(option, text, names);
}

/// Measures materials again, and replaces the fields that layers change.
void UpdateFields(const Mesh& mesh, const MeshReport& report, FieldArrays& fields)
{
  FieldArrays newer = ListSides(mesh.Tables);
  if (!mesh.ScaledJacobian.empty())
  {
    newer.push_back({ "MinimumScaledJacobian", std::vector<double>{ report.MinimumScaledJacobian } });
    newer.push_back({ "MeanScaledJacobian", std::vector<double>{ report.MeanScaledJacobian } });
  }
  ReplaceFields(newer, fields);
}

void CutLayersOf(ModifyInput& input, const MeshData& data, const MesherOptions& given,
  const MaterialPairs* pairs, Runtime& runtime, ModifiedMesh& result)
{
  Mesh& mesh = result.TheMesh;
  if (!input.Surfaces.SurfaceId.empty())
  {
    mesh.Surfaces = std::move(input.Surfaces);
    mesh.Curves = std::move(input.Curves);
  }
  else
  {
    AddSurfaces(data, runtime.Group(), mesh);
  }
  MesherOptions options = given;
  options.ComputeQuality = runtime.Group().Any(!mesh.ScaledJacobian.empty());
  Vector3 periods{};
  const std::vector<double> lengths = NumbersOfField(data.Fields, "PeriodLengths");
  std::copy(lengths.begin(), lengths.begin() + (lengths.size() == 3 ? 3 : 0), periods.begin());
  result.Report.Materials.resize(result.Labels.size());
  AddLayers(
    options, { 0.0, periods, result.Labels, pairs }, runtime, mesh, result.State, result.Report);
  UpdateFields(mesh, result.Report, result.Fields);
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
    copies.push_back({ array.Name, array.Type, array.Components, array.ComponentNames, false,
      std::move(values) });
  }
  return copies;
}

} // namespace

ModifiedMesh ModifyMesh(ModifyInput input, const MesherOptions& given, Runtime& runtime)
{
  Ranks& ranks = runtime.Group();
  const StoredMesh ordered = OrderMesh(input.Data, ranks);
  const MeshData& data = ordered.Data;
  MesherOptions options = given;
  options.Elements = data.Corners == 8 ? ElementKind::Hexes : ElementKind::Tets;
  const bool hasLayers = options.Layers > 1;
  ModifiedMesh result;
  result.Fields = data.Fields;
  WorkTogether(ranks,
    [&]
    {
      CheckOptions(options);
      CheckMesh(data);
      if (hasLayers)
      {
        CheckForLayers(data, options);
      }
      result.State = MakeStateOf(data, input.Extensive);
    });
  CheckElementIds(data, ranks);
  result.Labels = FindMaterials(data, ranks);
  if (result.Labels.front() != 0)
  {
    result.Labels.insert(result.Labels.begin(), 0); // void
  }
  std::optional<MaterialPairs> split, layers;
  WorkTogether(ranks,
    [&]
    {
      split = ReadPairs("SplitInterfaces", options.SplitInterfaces, result.Labels, data);
      layers = ReadPairs("LayerInterfaces", options.LayerInterfaces, result.Labels, data);
    });
  result.TheMesh = MakeMeshOf(data, result.Labels, ranks);
  if (hasLayers)
  {
    CutLayersOf(input, data, options, layers ? &*layers : nullptr, runtime, result);
  }
  UseLabels({ {}, result.Labels }, result.TheMesh);
  if (split)
  {
    const std::string warning =
      SplitMesh(*split, options, runtime, result.Fields, result.TheMesh, result.State);
    result.Cohesive =
      FindCohesiveBlocks(ViewMesh(result.TheMesh, result.State, result.Fields), ranks);
    if (ranks.Rank() == 0 && !warning.empty() && input.Warn)
    {
      input.Warn(warning);
    }
  }
  result.PointArrays = CopyPointArrays(data, result.TheMesh);
  return result;
}

} // namespace vfm
