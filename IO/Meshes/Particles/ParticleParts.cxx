#include "Meshes/Particles/ParticleParts.h"

#include "Meshes/Particles/GatherParticles.h"
#include "Ranks/Agreement.h"
#include "Report/MeshArrays.h"
#include "Report/MeshMaterials.h"
#include "Report/Sets/MaterialBins.h"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace vfm
{
namespace
{

/// Extends the values of points by those at the nodes of particles.
class NodeValues
{
public:
  NodeValues(const MeshData& mesh, const std::vector<Index>& ids) : TheMesh(mesh), Ids(ids) {}

  /// Returns the values of an array of the mesh, followed by those at the particles.
  template <class Value>
  std::vector<Value> Extend(const MeshArray& array) const
  {
    const auto* values = static_cast<const Value*>(array.Values);
    std::vector<Value> all(values, values + array.Components * this->TheMesh.NumberOfPoints);
    const std::vector<MeshArray>& arrays = this->TheMesh.Particles->Arrays;
    const MeshArray* source =
      IsVelocity(array) ? FindVelocity(arrays) : FindArray(arrays, array.Name);
    source = source && source->Components == array.Components ? source : nullptr;
    for (Index particle = 0; particle < this->TheMesh.Particles->NumberOfParticles; ++particle)
    {
      for (int c = 0; c < array.Components; ++c)
      {
        all.push_back(source ? static_cast<Value>(ValueAt(*source, particle, c))
                             : this->KnownValue<Value>(array, particle));
      }
    }
    return all;
  }

private:
  /// Returns the value of a known array: particles are nodes inside of a volume.
  template <class Value>
  Value KnownValue(const MeshArray& array, Index particle) const
  {
    const bool isId = array.Values == this->TheMesh.PointIds || array.Name == "GlobalPointIds" ||
      array.Name == "PeriodicPartner" || array.Name == "OriginalPointIds";
    return static_cast<Value>(isId          ? this->Ids[particle]
        : array.Name == "GeometryDimension" ? 3
                                            : 0);
  }

  const MeshData& TheMesh;
  const std::vector<Index>& Ids;
};

} // namespace

std::vector<int> ListMaterials(const MeshData& mesh)
{
  const ParticleData& particles = *mesh.Particles;
  std::vector<int> all(particles.Material, particles.Material + particles.NumberOfParticles);
  for (double id : NumbersOfField(mesh.Fields, "MaterialIds"))
  {
    if (id > 0.0) // 0 is the void
    {
      all.push_back(static_cast<int>(id));
    }
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::vector<ParticlePart> FindParticleParts(
  const MeshData& mesh, const std::vector<CohesiveBlock>& cohesive, Ranks& ranks)
{
  if (!mesh.Particles)
  {
    return {};
  }
  const int* own = mesh.Particles->Material;
  const std::vector<int> materials =
    UnionOverRanks(ranks, std::vector<int>(own, own + mesh.Particles->NumberOfParticles));
  const std::vector<int> all = UnionOverRanks(ranks, ListMaterials(mesh));
  if (materials.empty())
  {
    return {};
  }
  Index last = std::max({ FindVoidId(mesh, ranks), FindLastBinId(mesh), all.back() });
  last = cohesive.empty() ? last : std::max<Index>(last, cohesive.back().Id);
  if (last + static_cast<Index>(all.size()) > std::numeric_limits<int>::max())
  {
    throw InputError("No id is left for the particles: the ids of materials are too large.");
  }
  const std::map<int, std::string> names = NamesOfMaterials(mesh);
  std::vector<ParticlePart> parts;
  for (int material : materials)
  {
    const Index place = std::lower_bound(all.begin(), all.end(), material) - all.begin();
    parts.push_back({ material, static_cast<int>(last + 1 + place),
      NameOfMaterial(names, material) + "_particles", {} });
    for (Index particle = 0; particle < mesh.Particles->NumberOfParticles; ++particle)
    {
      if (own[particle] == material)
      {
        parts.back().Particles.push_back(particle);
      }
    }
  }
  return parts;
}

std::vector<std::string> NameParts(const std::vector<ParticlePart>& parts,
  std::string (*form)(const std::string&), UniqueNames& used)
{
  std::vector<std::string> names;
  std::transform(parts.begin(), parts.end(), std::back_inserter(names),
    [&](const ParticlePart& part) { return used.Add(form(part.Name)); });
  return names;
}

StoredMesh AddParticleNodes(const MeshData& mesh, const std::vector<Index>& ids)
{
  const ParticleData& particles = *mesh.Particles;
  StoredMesh all{ mesh, {} };
  MeshData& data = all.Data;
  data.NumberOfPoints += particles.NumberOfParticles;
  std::vector<double> points(mesh.Points, mesh.Points + 3 * mesh.NumberOfPoints);
  points.insert(
    points.end(), particles.Positions, particles.Positions + 3 * particles.NumberOfParticles);
  data.Points = all.Store(std::move(points));
  const NodeValues values(mesh, ids);
  std::map<const void*, const void*> extended;
  for (MeshArray& array : data.PointArrays)
  {
    array.Values = extended[array.Values] = VisitType(array.Type,
      [&](auto tag) -> const void*
      { return all.Store(values.Extend<typename decltype(tag)::Type>(array)); });
  }
  VisitPointArrays(
    [&](const KnownArray& array, auto& known)
    {
      using Value = std::remove_cv_t<std::remove_pointer_t<std::decay_t<decltype(known)>>>;
      const auto found = extended.find(known);
      if (found != extended.end())
      {
        known = static_cast<const Value*>(found->second);
      }
      else if (known)
      {
        known = all.Store(values.Extend<Value>({ array.Name, array.Type, 1, {}, known }));
      }
    },
    data);
  return all;
}

} // namespace vfm
