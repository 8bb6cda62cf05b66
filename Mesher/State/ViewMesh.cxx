#include "State/ViewMesh.h"

#include "Report/MeshArrays.h"
#include "State/StateArrays.h"

namespace vfm
{
namespace
{

int TypeOf(const Buffer<int>&)
{
  return ValueType::Int;
}

int TypeOf(const Buffer<Index>&)
{
  return ValueType::Id;
}

int TypeOf(const Buffer<float>&)
{
  return ValueType::Float;
}

MeshArray View(const TransferredArray& array)
{
  return { array.Name, CarrierType(array.Type), array.Components, array.ComponentNames,
    array.Values.data() };
}

} // namespace

MeshData ViewMesh(const Mesh& mesh, const OutputState& state, const std::vector<FieldArray>& fields)
{
  MeshData data;
  data.Corners = mesh.Corners;
  data.NumberOfPoints = static_cast<Index>(mesh.PointIds.size());
  data.NumberOfElements = static_cast<Index>(mesh.ElementIds.size());
  data.Points = mesh.Points.data();
  data.Elements = mesh.Elements.data();
  data.MidsPerElement = mesh.MidsPerElement;
  data.MidPoints = mesh.MidPoints.data();
  data.PointIds = mesh.PointIds.data();
  data.PeriodicPartner = mesh.PeriodicPartner.data();
  data.OriginalPointIds = mesh.OriginalPointIds.data();
  data.ElementIds = mesh.ElementIds.data();
  data.Material = mesh.Material.data();
  data.Fragment = mesh.Fragment.data();
  data.GeometryDimension = mesh.GeometryDimension.data();
  data.GeometryId = mesh.GeometryId.data();
  data.Facets = &mesh.Facets;
  const auto viewIn = [](std::vector<MeshArray>& arrays)
  {
    return [&arrays](const char* name, const auto& values) {
      arrays.push_back({ name, TypeOf(values), 1, {}, values.data() });
    };
  };
  VisitElementArrays(mesh, viewIn(data.ElementArrays));
  VisitPointArrays(mesh, viewIn(data.PointArrays));
  for (const TransferredArray& array : state.Arrays)
  {
    data.ElementArrays.push_back(View(array));
  }
  if (state.NodalVelocity)
  {
    data.PointArrays.push_back(View(*state.NodalVelocity));
  }
  data.Fields = fields;
  return data;
}

} // namespace vfm
