#include "State/Particles.h"

#include "State/StateArrays.h"

#include <algorithm>

namespace vfm
{
namespace
{

template <class T>
const T* PointerTo(const std::vector<T>& values)
{
  return values.empty() ? nullptr : values.data();
}

} // namespace

ParticleData ViewParticles(const Particles& particles)
{
  ParticleData data;
  data.NumberOfParticles = particles.Size();
  data.Positions = PointerTo(particles.Positions);
  data.Ids = PointerTo(particles.Ids);
  data.Material = PointerTo(particles.Material);
  data.Radius = PointerTo(particles.Radius);
  data.Volume = PointerTo(particles.Volume);
  data.Mass = PointerTo(particles.Mass);
  const auto add = [&](const MeshArray& array)
  {
    const bool isOfState = std::any_of(particles.Arrays.begin(), particles.Arrays.end(),
      [&array](const TransferredArray& state) { return state.Name == array.Name; });
    if (!isOfState)
    {
      data.Arrays.push_back(array);
    }
  };
  add({ "Id", ValueType::Id, 1, {}, data.Ids });
  add({ "Material", ValueType::Int, 1, {}, data.Material });
  add({ "Radius", ValueType::Double, 1, {}, data.Radius });
  add({ "Volume", ValueType::Double, 1, {}, data.Volume });
  if (particles.HasMass)
  {
    add({ "Mass", ValueType::Double, 1, {}, data.Mass });
  }
  for (const TransferredArray& array : particles.Arrays)
  {
    data.Arrays.push_back({ array.Name, CarrierType(array.Type), array.Components,
      array.ComponentNames, array.Values.data() });
  }
  return data;
}

} // namespace vfm
