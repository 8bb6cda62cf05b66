#include "Report/MeshData.h"

#include "Report/MeshArrays.h"

#include <algorithm>
#include <type_traits>

namespace vfm
{
namespace
{

template <class Arrays>
auto FindByName(Arrays& arrays, std::string_view name)
{
  const auto found = std::find_if(
    arrays.begin(), arrays.end(), [name](const auto& array) { return array.Name == name; });
  return found == arrays.end() ? nullptr : &*found;
}

/// Sets a pointer to the values of an array of one component as T, or to null.
template <class T>
void SetPointer(StoredMesh& mesh, const std::vector<MeshArray>& arrays, const char* name,
  Index count, const T*& pointer)
{
  pointer = nullptr;
  const MeshArray* array = FindArray(arrays, name);
  if (!array || array->Components != 1 || !array->Values)
  {
    return;
  }
  VisitType(array->Type,
    [&](auto tag)
    {
      using Value = typename decltype(tag)::Type;
      const auto* values = static_cast<const Value*>(array->Values);
      if constexpr (std::is_integral_v<Value> && sizeof(Value) == sizeof(T))
      {
        pointer = reinterpret_cast<const T*>(values);
      }
      else
      {
        std::vector<T> converted(count);
        std::transform(values, values + count, converted.begin(),
          [](Value value) { return static_cast<T>(value); });
        pointer = mesh.Store(std::move(converted));
      }
    });
}

} // namespace

std::vector<Index> MidsOfFace(const MeshData& mesh, Index element, int face)
{
  std::vector<Index> points;
  const MidNodes nodes(mesh.Corners, mesh.MidsPerElement);
  const Index* mids = mesh.MidPoints + mesh.MidsPerElement * element;
  for (int e = 0; mesh.MidsPerElement > 0 && e < ElementFaces(mesh.Corners).Corners; ++e)
  {
    points.push_back(mids[nodes.EdgeOfFace(face, e)]);
  }
  if (nodes.HasFaces())
  {
    points.push_back(mids[nodes.Edges + face]);
  }
  return points;
}

MeshData ViewMesh(const Mesh& mesh)
{
  MeshData data;
  static_cast<NodeCounts&>(data) = mesh;
  data.NumberOfPoints = static_cast<Index>(mesh.PointIds.size());
  data.NumberOfElements = static_cast<Index>(mesh.ElementIds.size());
  data.Points = mesh.Points.data();
  data.Elements = mesh.Elements.data();
  data.MidPoints = mesh.MidPoints.data();
  data.Facets = &mesh.Facets;
  const auto viewIn = [](std::vector<MeshArray>& arrays)
  {
    return [&arrays](const KnownArray& array, const auto& values, auto& view)
    {
      view = values.data();
      if (array.IsOutput(values))
      {
        arrays.push_back({ array.Name, array.Type, 1, {}, view });
      }
    };
  };
  VisitElementArrays(viewIn(data.ElementArrays), mesh, data);
  VisitPointArrays(viewIn(data.PointArrays), mesh, data);
  return data;
}

void FindKnownArrays(StoredMesh& mesh)
{
  const auto setFrom = [&mesh](const std::vector<MeshArray>& arrays, Index count)
  {
    return [&mesh, &arrays, count](const KnownArray& array, auto& values)
    { SetPointer(mesh, arrays, array.Name, count, values); };
  };
  MeshData& data = mesh.Data;
  VisitPointArrays(setFrom(data.PointArrays, data.NumberOfPoints), data);
  VisitElementArrays(setFrom(data.ElementArrays, data.NumberOfElements), data);
}

MeshData TakeKnownArrays(MeshData mesh, const std::function<bool(const MeshArray&)>& isTaken)
{
  for (std::vector<MeshArray>* arrays : { &mesh.PointArrays, &mesh.ElementArrays })
  {
    arrays->erase(std::remove_if(arrays->begin(), arrays->end(),
                    [&](const MeshArray& array)
                    {
                      const std::optional<KnownArray> known = FindKnownArray(array.Name);
                      return (!known || known->IsShown) && !(isTaken && isTaken(array));
                    }),
      arrays->end());
  }
  return mesh;
}

const MeshArray* FindArray(const std::vector<MeshArray>& arrays, std::string_view name)
{
  return FindByName(arrays, name);
}

void RejectMissing(const std::string& name)
{
  throw InputError(
    "The mesh has no array " + name + ". A mesh of Volume Fraction To Hex or To Tet is needed.");
}

const MeshArray& GetArray(const std::vector<MeshArray>& arrays, std::string_view name)
{
  const MeshArray* array = FindArray(arrays, name);
  if (!array)
  {
    RejectMissing(std::string(name));
  }
  return *array;
}

double ValueAt(const MeshArray& array, Index tuple, int component)
{
  return VisitType(array.Type,
    [&](auto tag)
    {
      using Value = typename decltype(tag)::Type;
      return static_cast<double>(
        static_cast<const Value*>(array.Values)[array.Components * tuple + component]);
    });
}

const FieldArray* FindField(const std::vector<FieldArray>& fields, const std::string& name)
{
  return FindByName(fields, name);
}

std::vector<double> NumbersOfField(const std::vector<FieldArray>& fields, const std::string& name)
{
  const FieldArray* field = FindField(fields, name);
  if (!field)
  {
    return {};
  }
  return std::visit(
    [](const auto& values) -> std::vector<double>
    {
      using Value = typename std::decay_t<decltype(values)>::value_type;
      if constexpr (std::is_arithmetic_v<Value>)
      {
        return std::vector<double>(values.begin(), values.end());
      }
      return {};
    },
    field->Values);
}

} // namespace vfm
