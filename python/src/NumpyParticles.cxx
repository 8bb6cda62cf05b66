#include "NumpyParticles.h"

#include "NumpyFields.h"

#include <algorithm>

namespace vfm
{
namespace
{

namespace nb = nanobind;

/// Returns the values of an array, or null if it is missing.
/// @throws InputError if it has another type or number of components
template <class T>
const T* FindValues(
  const std::vector<MeshArray>& arrays, const std::string& name, int type, int components = 1)
{
  const MeshArray* array = FindArray(arrays, name);
  if (array && (array->Type != type || array->Components != components))
  {
    throw InputError("The array '" + name +
      "' of particles has another type or shape than in a "
      "mesh that hexes() or tets() made.");
  }
  return array ? static_cast<const T*>(array->Values) : nullptr;
}

void RequireArrays(const std::vector<MeshArray>& arrays)
{
  for (const char* name : { "Position", "Id", "Material", "Radius", "Volume" })
  {
    if (!FindArray(arrays, name))
    {
      throw InputError(std::string("The particles have no array '") + name + "'.");
    }
  }
}

std::vector<MeshArray> ListArrays(const NamedArrays& arrays)
{
  std::vector<MeshArray> list;
  std::optional<Index> rows;
  for (const auto& [name, values] : arrays)
  {
    const NumpyView view(name, values);
    if (view.Rows != rows.value_or(view.Rows))
    {
      throw InputError("The array '" + name + "' of particles has another length than others.");
    }
    rows = view.Rows;
    list.push_back(
      { name, name == "Id" ? ValueType::Id : view.Type, view.Components, {}, view.Values });
  }
  return list;
}

} // namespace

nb::dict TakeParticles(Particles& particles)
{
  FieldArrays known{ { "Position", std::move(particles.Positions), 3 },
    { "Id", std::move(particles.Ids) }, { "Material", std::move(particles.Material) },
    { "Radius", std::move(particles.Radius) }, { "Volume", std::move(particles.Volume) } };
  if (particles.HasMass)
  {
    known.push_back({ "Mass", std::move(particles.Mass) });
  }
  nb::dict arrays = ToDict(known);
  for (TransferredArray& array : particles.Arrays)
  {
    if (!arrays.contains(array.Name.c_str()))
    {
      arrays[array.Name.c_str()] = ToNumpy(array);
    }
  }
  return arrays;
}

ParticleData ViewParticles(const NamedArrays& arrays)
{
  ParticleData data;
  data.Arrays = ListArrays(arrays);
  RequireArrays(data.Arrays);
  data.NumberOfParticles = static_cast<Index>(arrays.front().second.shape(0));
  data.Positions = FindValues<double>(data.Arrays, "Position", ValueType::Double, 3);
  data.Ids = FindValues<Index>(data.Arrays, "Id", ValueType::Id);
  data.Material = FindValues<int>(data.Arrays, "Material", ValueType::Int);
  data.Radius = FindValues<double>(data.Arrays, "Radius", ValueType::Double);
  data.Volume = FindValues<double>(data.Arrays, "Volume", ValueType::Double);
  data.Mass = FindValues<double>(data.Arrays, "Mass", ValueType::Double);
  data.Arrays.erase(std::find_if(data.Arrays.begin(), data.Arrays.end(),
    [](const MeshArray& array) { return array.Name == "Position"; }));
  return data;
}

} // namespace vfm
