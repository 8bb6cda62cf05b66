#include "Meshes/OpenFoam/FoamCloud.h"

#include "Meshes/OpenFoam/FoamFile.h"
#include "Meshes/Particles/GatherParticles.h"
#include "Meshes/Particles/ParticleParts.h"

namespace vfm
{
namespace
{

constexpr const char* CloudFolder = "lagrangian/particles";

} // namespace

void WriteCloud(const ParticleData& particles, const std::string& folder, OutputSet& files)
{
  const std::string lagrangian = std::string("0/") + CloudFolder;
  const std::string uniform = std::string("0/uniform/") + CloudFolder;
  for (const std::string& name : { std::string("0"), std::string("0/lagrangian"), lagrangian,
         std::string("0/uniform"), std::string("0/uniform/lagrangian"), uniform })
  {
    files.MakeFolder(folder + "/" + name);
  }
  const auto write = [&](const char* object, const char* type, int components, const auto& value,
                       const char* after = "")
  {
    FoamFile file(folder, { type, lagrangian, object, "" }, false, files);
    file.Reals(particles.NumberOfParticles, components, value, after);
    file.Close();
  };
  write(
    "positions", "Cloud", 3,
    [&](Index particle, int axis) { return particles.Positions[3 * particle + axis]; }, " -1");
  write("d", "scalarField", 1, [&](Index particle, int) { return 2 * particles.Radius[particle]; });
  write("nParticle", "scalarField", 1, [](Index, int) { return 1.0; });
  if (particles.Mass)
  {
    write(
      "rho", "scalarField", 1, [&](Index particle, int) { return DensityOf(particles, particle); });
  }
  if (const MeshArray* velocity = FindVelocity(particles.Arrays))
  {
    write("U", "vectorField", 3,
      [&](Index particle, int axis) { return ValueAt(*velocity, particle, axis); });
  }
  FoamFile file(folder, { "dictionary", uniform, "cloudProperties", "" }, false, files);
  file.Text("geometry        positions;\n");
  file.Close();
}

} // namespace vfm
