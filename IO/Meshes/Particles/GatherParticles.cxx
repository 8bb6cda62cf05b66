#include "Meshes/Particles/GatherParticles.h"

#include "Meshes/Files/MeshModel.h"
#include "Ranks/Agreement.h"
#include "Ranks/NumberKeys.h"
#include "Report/Gather/GatherMesh.h"

#include <algorithm>
#include <numeric>

namespace vfm
{
namespace
{

/// Particles with their memory.
struct StoredParticles
{
  ParticleData Data;
  StoredMesh Cells;
  std::vector<Index> Nodes;
};

/// Returns the particles as a mesh that GatherMesh gathers: members of ParticleData are point
/// arrays, its arrays are arrays of elements.
MeshData ViewToGather(const ParticleData& particles, std::vector<Index>& nodes)
{
  MeshData cells = ViewAsVertices(particles, nodes);
  cells.ElementArrays = std::move(cells.PointArrays);
  cells.ElementArrays.push_back({ "GlobalCellIds", ValueType::Id, 1, {}, particles.Ids });
  cells.PointArrays = { { "GlobalPointIds", ValueType::Id, 1, {}, particles.Ids },
    { "Material", ValueType::Int, 1, {}, particles.Material },
    { "Radius", ValueType::Double, 1, {}, particles.Radius },
    { "Volume", ValueType::Double, 1, {}, particles.Volume } };
  if (particles.Mass)
  {
    cells.PointArrays.push_back({ "Mass", ValueType::Double, 1, {}, particles.Mass });
  }
  return cells;
}

/// Returns the values of an array; not null if it has no values.
template <class T>
const T* ValuesOf(const MeshData& cells, const char* name)
{
  const MeshArray* array = FindArray(cells.PointArrays, name);
  static const T none{};
  return !array ? nullptr : array->Values ? static_cast<const T*>(array->Values) : &none;
}

ParticleData ViewAsParticles(const MeshData& cells)
{
  ParticleData particles;
  particles.NumberOfParticles = cells.NumberOfPoints;
  particles.Positions = cells.Points;
  particles.Ids = ValuesOf<Index>(cells, "GlobalPointIds");
  particles.Material = ValuesOf<int>(cells, "Material");
  particles.Radius = ValuesOf<double>(cells, "Radius");
  particles.Volume = ValuesOf<double>(cells, "Volume");
  particles.Mass = ValuesOf<double>(cells, "Mass");
  particles.Arrays = cells.ElementArrays;
  if (!particles.Arrays.empty())
  {
    particles.Arrays.pop_back(); // GlobalCellIds
  }
  return particles;
}

/// Gathers the particles among these ranks.
std::shared_ptr<const ParticleData> GatherAmong(const MeshData& cells, Ranks& ranks)
{
  auto stored = std::make_shared<StoredParticles>();
  stored->Cells = GatherMesh(cells, ranks);
  stored->Data = ViewAsParticles(stored->Cells.Data);
  return { stored, &stored->Data };
}

} // namespace

std::shared_ptr<const ParticleData> OrderParticles(const ParticleData* particles, Ranks& ranks)
{
  if (!ranks.Any(particles != nullptr))
  {
    return nullptr;
  }
  static const ParticleData none;
  std::vector<Index> nodes;
  MeshData cells = ViewToGather(particles ? *particles : none, nodes);
  if (ranks.Any(cells.NumberOfElements > 0))
  {
    cells = ShareHead(cells, ranks);
  }
  std::shared_ptr<const ParticleData> ordered;
  WorkTogether(ranks,
    [&]
    {
      Ranks alone;
      ordered = GatherAmong(cells, alone);
    });
  return ordered;
}

std::shared_ptr<const ParticleData> GatherParticles(const ParticleData* particles, Ranks& ranks)
{
  if (!ranks.Any(particles != nullptr))
  {
    return nullptr;
  }
  static const ParticleData none;
  std::vector<Index> nodes;
  const MeshData cells = ViewToGather(particles ? *particles : none, nodes);
  const Index count = SumOverRanks(cells.NumberOfElements, ranks);
  std::shared_ptr<const ParticleData> whole = GatherAmong(cells, ranks);
  WorkTogether(ranks,
    [&]
    {
      if (ranks.Rank() == 0 && whole->NumberOfParticles != count)
      {
        throw InputError("Several particles have the same id.");
      }
    });
  return whole;
}

std::vector<Index> NumberParticles(const ParticleData& particles, Ranks& ranks)
{
  const std::vector<Index> ids(particles.Ids, particles.Ids + particles.NumberOfParticles);
  return NumberItems(ids, FirstOfKey(), ranks).Numbers;
}

const MeshArray* FindVelocity(const std::vector<MeshArray>& arrays)
{
  const auto found = std::find_if(arrays.begin(), arrays.end(), IsVelocity);
  return found == arrays.end() ? nullptr : &*found;
}

MeshData ViewAsVertices(const ParticleData& particles, std::vector<Index>& nodes)
{
  nodes.resize(particles.NumberOfParticles);
  std::iota(nodes.begin(), nodes.end(), Index(0));
  MeshData cells;
  cells.Corners = 1;
  cells.NumberOfPoints = cells.NumberOfElements = particles.NumberOfParticles;
  cells.Points = particles.Positions;
  cells.Elements = nodes.data();
  cells.PointIds = cells.ElementIds = particles.Ids;
  cells.PointArrays = particles.Arrays;
  return cells;
}

} // namespace vfm
