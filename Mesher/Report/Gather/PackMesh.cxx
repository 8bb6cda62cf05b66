#include "Report/Gather/PackMesh.h"

#include "Input/PackBytes.h"

namespace vfm
{
namespace
{

Index SizeOf(const MeshArray& array, Index tuples)
{
  return tuples * array.Components * WidthOfType(array.Type);
}

void AddArrays(const std::vector<MeshArray>& arrays, Index tuples, Packer& packer)
{
  packer.Add(static_cast<Index>(arrays.size()));
  for (const MeshArray& array : arrays)
  {
    packer.Add(array.Name);
    packer.Add(array.Type);
    packer.Add(array.Components);
    packer.Add(array.ComponentNames);
    packer.AddMany(static_cast<const char*>(array.Values), SizeOf(array, tuples));
  }
}

std::vector<MeshArray> TakeArrays(Index tuples, Unpacker& unpacker, StoredMesh& mesh)
{
  std::vector<MeshArray> arrays(unpacker.Take<Index>());
  for (MeshArray& array : arrays)
  {
    unpacker.TakeTo(array.Name);
    unpacker.TakeTo(array.Type);
    unpacker.TakeTo(array.Components);
    unpacker.TakeTo(array.ComponentNames);
    if (tuples > 0)
    {
      array.Values = mesh.Store(unpacker.TakeMany<char>(SizeOf(array, tuples)));
    }
  }
  return arrays;
}

void AddFields(const std::vector<FieldArray>& fields, Packer& packer)
{
  packer.Add(static_cast<Index>(fields.size()));
  for (const FieldArray& field : fields)
  {
    packer.Add(field.Name);
    packer.Add(field.Components);
    packer.Add(static_cast<int>(field.Values.index()));
    std::visit([&packer](const auto& values) { packer.Add(values); }, field.Values);
  }
}

/// Reads the values of a field whose variant has the index number.
template <std::size_t Number = 0>
void TakeValues(std::size_t number, Unpacker& unpacker, FieldArray& field)
{
  if constexpr (Number < std::variant_size_v<decltype(FieldArray::Values)>)
  {
    if (number == Number)
    {
      unpacker.TakeTo(field.Values.template emplace<Number>());
      return;
    }
    TakeValues<Number + 1>(number, unpacker, field);
  }
}

std::vector<FieldArray> TakeFields(Unpacker& unpacker)
{
  std::vector<FieldArray> fields(unpacker.Take<Index>());
  for (FieldArray& field : fields)
  {
    unpacker.TakeTo(field.Name);
    unpacker.TakeTo(field.Components);
    TakeValues(unpacker.Take<int>(), unpacker, field);
  }
  return fields;
}

} // namespace

Bytes PackMesh(const MeshData& mesh)
{
  Packer packer;
  packer.Add(mesh.Corners);
  packer.Add(mesh.MidsPerElement);
  packer.Add(mesh.NumberOfPoints);
  packer.Add(mesh.NumberOfElements);
  packer.AddMany(mesh.Points, 3 * mesh.NumberOfPoints);
  packer.AddMany(mesh.Elements, mesh.Corners * mesh.NumberOfElements);
  packer.AddMany(mesh.MidPoints, mesh.MidsPerElement * mesh.NumberOfElements);
  AddArrays(mesh.PointArrays, mesh.NumberOfPoints, packer);
  AddArrays(mesh.ElementArrays, mesh.NumberOfElements, packer);
  AddFields(mesh.Fields, packer);
  packer.Add(mesh.Facets != nullptr);
  if (mesh.Facets)
  {
    packer.Add(*mesh.Facets);
  }
  return std::move(packer.Packed);
}

Bytes PackHead(const MeshData& mesh)
{
  MeshData head = mesh;
  head.NumberOfPoints = head.NumberOfElements = 0;
  head.Facets = nullptr;
  return PackMesh(head);
}

StoredMesh UnpackMesh(const Bytes& bytes)
{
  Unpacker unpacker(bytes);
  StoredMesh mesh;
  MeshData& data = mesh.Data;
  unpacker.TakeTo(data.Corners);
  unpacker.TakeTo(data.MidsPerElement);
  unpacker.TakeTo(data.NumberOfPoints);
  unpacker.TakeTo(data.NumberOfElements);
  data.Points = mesh.Store(unpacker.TakeMany<double>(3 * data.NumberOfPoints));
  data.Elements = mesh.Store(unpacker.TakeMany<Index>(data.Corners * data.NumberOfElements));
  data.MidPoints =
    mesh.Store(unpacker.TakeMany<Index>(data.MidsPerElement * data.NumberOfElements));
  data.PointArrays = TakeArrays(data.NumberOfPoints, unpacker, mesh);
  data.ElementArrays = TakeArrays(data.NumberOfElements, unpacker, mesh);
  data.Fields = TakeFields(unpacker);
  if (unpacker.Take<bool>())
  {
    const auto facets = std::make_shared<std::vector<MeshFacet>>();
    unpacker.TakeTo(*facets);
    data.Facets = facets.get();
    mesh.Memory.push_back(facets);
  }
  FindKnownArrays(mesh);
  return mesh;
}

} // namespace vfm
