/// Writes a mesh with particles in all formats, for a test in Python that reads them.
///
/// usage: ParticleFiles FOLDER
///
/// Folders in it: hex, tet, plain (no mass, no velocity of nodes); in each mesh.SUFFIX, for Exodus
/// and OpenFOAM also from three ranks (parts.e, parts/mesh.foam), and particles.txt: a line
/// per particle, ascending by id: id material x y z radius volume mass velocity energy.
#include "Meshes/Files/OutputFile.h"
#include "Meshes/Particles/GatherParticles.h"
#include "Meshes/WriteMesh.h"
#include "WithParticles.h"

#include <iostream>

using namespace vfm;
using namespace vfm::testing;

namespace
{

void WriteExpected(const std::string& path)
{
  WithParticles(1, MakeHexMesh,
    [&](const MeshData& mesh, Ranks& ranks)
    {
      const auto ordered = OrderParticles(mesh.Particles, ranks);
      const ParticleData& particles = *ordered;
      OutputFile file(path);
      const auto velocity = GetArray(particles.Arrays, "Velocity");
      for (Index p = 0; p < particles.NumberOfParticles; ++p)
      {
        file.Add(particles.Ids[p]);
        const Vector3 x = particles.PositionAt(p);
        for (double value :
          { 1.0 * particles.Material[p], x[0], x[1], x[2], particles.Radius[p], particles.Volume[p],
            particles.Mass[p], ValueAt(velocity, p, 0), ValueAt(velocity, p, 1),
            ValueAt(velocity, p, 2), ValueAt(GetArray(particles.Arrays, "energy"), p) })
        {
          file.Add(" ");
          file.AddReal(value);
        }
        file.Add("\n");
      }
      file.Close();
    });
}

void WriteFolder(const std::string& folder, MeshMaker make, const ParticleForm& form)
{
  std::filesystem::create_directories(folder + "/parts");
  WriteExpected(folder + "/particles.txt");
  WithParticles(
    1, make,
    [&](const MeshData& mesh, Ranks& ranks)
    {
      for (const FormatRow& format : GetFormatTable())
      {
        if (form.HasMass || format.Format != MeshFormat::Lammps)
        {
          const std::string name = format.Format == MeshFormat::Vtp ? "/only" : "/mesh";
          WriteMesh(mesh, folder + name + format.Suffixes[0], ranks);
        }
      }
    },
    form);
  WithParticles(
    3, make,
    [&](const MeshData& mesh, Ranks& ranks)
    {
      WriteMesh(mesh, folder + "/parts.e", ranks);
      WriteMesh(mesh, folder + "/parts/mesh.foam", ranks);
      WriteMesh(mesh, folder + "/parts.pvtu", ranks);
    },
    form);
}

} // namespace

int main(int count, char** arguments)
{
  if (count != 2)
  {
    std::cerr << "usage: ParticleFiles FOLDER\n";
    return 1;
  }
  const std::string folder = arguments[1];
  WriteFolder(folder + "/hex", MakeHexMesh, {});
  WriteFolder(folder + "/tet", MakeTetMesh, {});
  WriteFolder(folder + "/plain", MakeHexMesh, { false, false, NumberOfTestParticles });
  return 0;
}
