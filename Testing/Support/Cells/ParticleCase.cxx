#include "Cells/ParticleCase.h"

#include "RandomDraw.h"

namespace vfm
{
namespace testing
{

ParticleCase MakeParticles(
  Index count, const std::vector<double>& domain, int rank, int ranks, bool hasMass)
{
  constexpr double pi = 3.14159265358979323846;
  RandomDraw draw(7);
  ParticleCase made;
  for (Index p = 0; p < count; ++p)
  {
    Vector3 x;
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] = draw.Between(domain[2 * axis], domain[2 * axis + 1]);
      x[axis] = p == 0 ? domain[2 * axis] : x[axis];
    }
    const double volume = draw.Scale(1e-9, 1e-3), density = draw.Scale(10, 1e4);
    const double speed = draw.Scale(1, 1e3);
    const Vector3 velocity = speed * draw.Vector(-1, 1);
    const double energy = draw.Between(-5, 5);
    const Vector3 pull = draw.Vector(-1e9, 1e9), shear = draw.Vector(-1e-9, 1e-9);
    if (p % ranks != rank)
    {
      continue;
    }
    made.Positions.insert(made.Positions.end(), x.begin(), x.end());
    made.Ids.push_back((5 * p + 3) % count * 11); // different if 5 does not divide count
    made.Material.push_back(p % 3 == 0 ? 3 : 1);
    made.Volume.push_back(volume);
    made.Radius.push_back(std::cbrt(3 * volume / (4 * pi)));
    made.Mass.push_back(density * volume);
    made.Velocity.insert(made.Velocity.end(), velocity.begin(), velocity.end());
    made.Energy.push_back(energy);
    made.Stress.insert(made.Stress.end(), pull.begin(), pull.end());
    made.Stress.insert(made.Stress.end(), shear.begin(), shear.end());
  }
  ParticleData& data = made.Data;
  data.NumberOfParticles = static_cast<Index>(made.Ids.size());
  data.Positions = made.Positions.data();
  data.Ids = made.Ids.data();
  data.Material = made.Material.data();
  data.Radius = made.Radius.data();
  data.Volume = made.Volume.data();
  data.Mass = hasMass ? made.Mass.data() : nullptr;
  data.Arrays = { { "Id", ValueType::Id, 1, {}, data.Ids },
    { "MaterialId", ValueType::Int, 1, {}, data.Material },
    { "Radius", ValueType::Double, 1, {}, data.Radius },
    { "Volume", ValueType::Double, 1, {}, data.Volume },
    { "Velocity", ValueType::Double, 3, {}, made.Velocity.data() },
    { "energy", ValueType::Double, 1, {}, made.Energy.data() },
    { "stress", ValueType::Double, 6, {}, made.Stress.data() } };
  if (hasMass)
  {
    data.Arrays.insert(data.Arrays.begin() + 4, { "Mass", ValueType::Double, 1, {}, data.Mass });
  }
  return made;
}

} // namespace testing
} // namespace vfm
