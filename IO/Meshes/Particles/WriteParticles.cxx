#include "Meshes/Particles/WriteParticles.h"

#include "Meshes/Files/OutputFile.h"
#include "Meshes/Particles/GatherParticles.h"
#include "Meshes/Particles/ParticleParts.h"
#include "Meshes/Surfaces/MaterialSkins.h"
#include "Meshes/Vtk/WriteVtp.h"
#include "Ranks/WorkTogether.h"
#include "Report/MeshMaterials.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <limits>

namespace vfm
{
namespace
{

/// Calls write on rank 0 with a mesh that has all particles and the fields of this one.
/// @pre Collective
void WriteGathered(
  const MeshData& mesh, Ranks& ranks, const std::function<void(const MeshData&)>& write)
{
  const std::shared_ptr<const ParticleData> particles = GatherParticles(mesh.Particles, ranks);
  WorkTogether(ranks,
    [&]
    {
      if (!particles)
      {
        throw InputError("The mesh was made without particles. Set UnmeshedMaterial to Particles.");
      }
      if (ranks.Rank() == 0)
      {
        MeshData whole = mesh;
        whole.Particles = particles.get();
        write(whole);
      }
    });
}

void WriteVertices(const MeshData& whole, const std::string& path, OutputSet& files)
{
  std::vector<Index> nodes;
  MeshData cells = ViewAsVertices(*whole.Particles, nodes);
  cells.Time = whole.Time;
  std::copy_if(whole.Fields.begin(), whole.Fields.end(), std::back_inserter(cells.Fields),
    [](const FieldArray& field)
    { return field.Name == "MaterialNames" || field.Name == "MaterialIds"; });
  WriteVtp(cells, path, files);
}

/// Adds numbers, each after a blank, and ends the line.
void AddNumbers(OutputFile& file, const double* numbers, int count)
{
  for (int i = 0; i < count; ++i)
  {
    file.Add(" ");
    file.AddReal(numbers[i]);
  }
  file.Add("\n");
}

/// Writes the box around all spheres.
void AddBox(OutputFile& file, const ParticleData& particles)
{
  const Index count = particles.NumberOfParticles;
  const double radius =
    count > 0 ? *std::max_element(particles.Radius, particles.Radius + count) : 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    double low = count > 0 ? std::numeric_limits<double>::infinity() : 0;
    double high = count > 0 ? -low : 1;
    for (Index particle = 0; particle < count; ++particle)
    {
      low = std::min(low, particles.Positions[3 * particle + axis]);
      high = std::max(high, particles.Positions[3 * particle + axis]);
    }
    file.AddReal(low - radius);
    file.Add(" ");
    file.AddReal(high + radius);
    const std::string name(1, "xyz"[axis]);
    file.Add(" " + name + "lo " + name + "hi\n");
  }
}

void WriteAtoms(OutputFile& file, const ParticleData& particles, const std::vector<int>& materials)
{
  file.Add("\nAtoms # sphere\n\n");
  for (Index particle = 0; particle < particles.NumberOfParticles; ++particle)
  {
    const auto type =
      std::lower_bound(materials.begin(), materials.end(), particles.Material[particle]);
    file.Add(particle + 1);
    file.Add(" ");
    file.Add(static_cast<std::int64_t>(type - materials.begin()) + 1);
    const double sphere[2] = { 2 * particles.Radius[particle], DensityOf(particles, particle) };
    const Vector3 x = particles.PositionAt(particle);
    const double all[5] = { sphere[0], sphere[1], x[0], x[1], x[2] };
    AddNumbers(file, all, 5);
  }
}

void WriteVelocities(OutputFile& file, const ParticleData& particles, const MeshArray& velocity)
{
  file.Add("\nVelocities\n\n");
  for (Index particle = 0; particle < particles.NumberOfParticles; ++particle)
  {
    file.Add(particle + 1);
    const double all[6] = { ValueAt(velocity, particle, 0), ValueAt(velocity, particle, 1),
      ValueAt(velocity, particle, 2), 0, 0, 0 };
    AddNumbers(file, all, 6);
  }
}

void WriteData(const MeshData& whole, const std::string& path)
{
  const ParticleData& particles = *whole.Particles;
  const Index count = particles.NumberOfParticles;
  if (count > 0 && !particles.Mass)
  {
    throw InputError("The particles have no mass, and LAMMPS needs their density. Give a density, "
                     "or write .vtp.");
  }
  const std::vector<int> materials = ListMaterials(whole);
  const std::map<int, std::string> names = NamesOfMaterials(whole);
  OutputFile file(path);
  file.Add(
    "LAMMPS data file, atom_style sphere: particles by VolumeFractionMesh " VFM_VERSION "\n");
  for (std::size_t type = 0; type < materials.size(); ++type)
  {
    file.Add("# type " + std::to_string(type + 1) + ": material " +
      std::to_string(materials[type]) + ", " +
      PrintableName(NameOfMaterial(names, materials[type])) + "\n");
  }
  file.Add("\n");
  file.Add(count);
  file.Add(" atoms\n" + std::to_string(materials.size()) + " atom types\n\n");
  AddBox(file, particles);
  if (count > 0)
  {
    WriteAtoms(file, particles, materials);
  }
  const MeshArray* velocity = FindVelocity(particles.Arrays);
  if (count > 0 && velocity)
  {
    WriteVelocities(file, particles, *velocity);
  }
  file.Close();
}

} // namespace

std::string PathOfParticles(const std::string& mesh)
{
  const std::filesystem::path path(mesh);
  std::string stem = path.stem().string();
  const std::size_t place = stem.find(MaterialPlace);
  stem = place == std::string::npos ? stem + "_particles"
                                    : stem.replace(place, std::strlen(MaterialPlace), "particles");
  return std::filesystem::path(path).replace_filename(stem + ".vtp").string();
}

void WriteParticlesBeside(const MeshData& whole, const std::string& path, OutputSet& files)
{
  if (whole.Particles)
  {
    WriteVertices(whole, PathOfParticles(path), files);
  }
}

void WriteVtpParticles(const MeshData& mesh, const std::string& path, Ranks& ranks)
{
  WriteGathered(mesh, ranks,
    [&](const MeshData& whole)
    {
      OutputSet files(path);
      WriteVertices(whole, path, files);
      files.Rename();
    });
}

void WriteLammps(const MeshData& mesh, const std::string& path, Ranks& ranks)
{
  WriteGathered(mesh, ranks, [&](const MeshData& whole) { WriteData(whole, path); });
}

} // namespace vfm
