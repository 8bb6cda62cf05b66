#include "State/ViewMesh.h"

#include "State/StateArrays.h"

namespace vfm
{
namespace
{

MeshArray View(const TransferredArray& array)
{
  return { array.Name, CarrierType(array.Type), array.Components, array.ComponentNames,
    array.Values.data() };
}

} // namespace

MeshData ViewMesh(const Mesh& mesh, const OutputState& state, const std::vector<FieldArray>& fields)
{
  MeshData data = ViewMesh(mesh);
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
