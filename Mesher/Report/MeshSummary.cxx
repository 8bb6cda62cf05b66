#include "Report/MeshSummary.h"

#include "Base/ExactSum.h"
#include "Elements/MeshWithRuns.h"
#include "Ranks/Agreement.h"
#include "Report/ElementMoments.h"
#include "Report/MeshMaterials.h"
#include "Report/PointCounts.h"

#include <algorithm>
#include <limits>

namespace vfm
{
namespace
{

std::vector<double> GetField(const MeshData& mesh, const std::string& name)
{
  return NumbersOfField(mesh.Fields, name);
}

/// Sums a field of numbers per material, or one component of it.
double SumOfMaterials(const MeshData& mesh, const std::string& name, int component = 0)
{
  const FieldArray* field = FindField(mesh.Fields, name);
  const std::vector<double> values = GetField(mesh, name);
  double sum = 0.0;
  for (std::size_t at = component; at < values.size(); at += field->Components)
  {
    sum += values[at];
  }
  return sum;
}

/// Returns the conserved quantities of a mesh, from its fields.
std::vector<StateTotal> FindStateTotals(const MeshData& mesh)
{
  struct Quantity
  {
    const char *Name, *Field;
    int Component = 0;
  };
  constexpr Quantity quantities[] = { { "mass", "Mass" }, { "momentum x", "Momentum" },
    { "momentum y", "Momentum", 1 }, { "momentum z", "Momentum", 2 },
    { "kinetic energy", "KineticEnergy" }, { "internal energy", "InternalEnergy" } };
  std::vector<StateTotal> totals;
  for (const Quantity& q : quantities)
  {
    const std::string field = q.Field;
    if (FindField(mesh.Fields, "Input" + field))
    {
      totals.push_back({ q.Name, SumOfMaterials(mesh, "Input" + field, q.Component),
        SumOfMaterials(mesh, "Mesh" + field, q.Component),
        SumOfMaterials(mesh, "Unmeshed" + field, q.Component),
        SumOfMaterials(mesh, "Particle" + field, q.Component) });
    }
  }
  return totals;
}

/// Returns the sums of particles, from the fields of a mesh.
std::optional<ParticleSummary> FindParticles(const MeshData& mesh)
{
  if (!FindField(mesh.Fields, "Particles"))
  {
    return std::nullopt;
  }
  ParticleSummary particles;
  particles.Count = static_cast<Index>(SumOfMaterials(mesh, "Particles"));
  particles.Volume = SumOfMaterials(mesh, "ParticleVolume");
  if (FindField(mesh.Fields, "ParticleMass"))
  {
    particles.Mass = SumOfMaterials(mesh, "ParticleMass");
  }
  particles.LostEnergy = SumOfMaterials(mesh, "ParticleLostKineticEnergy");
  return particles;
}

double GetNumber(const MeshData& mesh, const char* name)
{
  const std::vector<double> values = GetField(mesh, name);
  return values.empty() ? 0.0 : values[0];
}

/// Sums over the elements of a part of the mesh on this rank.
struct PartSums
{
  Index Elements = 0;
  double Minimum = std::numeric_limits<double>::infinity();
  int Material = -1;
  ExactSum Quality, Volume; ///< volumes in units of the mean element of the mesh
};

/// Sums over the parts of this rank's elements.
/// @param partOf part of each element, from 0
/// @param unit unit of volumes
std::vector<PartSums> SumParts(const MeshData& mesh, const std::vector<ElementMoments>& moments,
  const std::vector<int>& partOf, std::size_t numberOfParts, double unit)
{
  std::vector<PartSums> parts(numberOfParts);
  const MeshArray* quality = FindArray(mesh.ElementArrays, "ScaledJacobian");
  for (std::size_t e = 0; e < partOf.size(); ++e)
  {
    PartSums& part = parts[partOf[e]];
    const auto element = static_cast<Index>(e);
    ++part.Elements;
    part.Material = mesh.Material[e];
    part.Volume.Add(moments[e].Volume / unit);
    if (quality)
    {
      part.Minimum = std::min(part.Minimum, ValueAt(*quality, element));
      part.Quality.Add(ValueAt(*quality, element));
    }
  }
  return parts;
}

/// Merges the parts of all ranks; points: number of points of each part.
std::vector<PartSummary> MergeParts(
  const std::vector<PartSums>& parts, const std::vector<Index>& points, double unit, Ranks& ranks)
{
  std::vector<std::int64_t> elements;
  std::vector<ExactSum> quality, volume;
  std::vector<double> extremes;
  for (const PartSums& part : parts)
  {
    elements.push_back(part.Elements);
    quality.push_back(part.Quality);
    volume.push_back(part.Volume);
    extremes.push_back(-part.Minimum);
    extremes.push_back(part.Material);
  }
  ranks.Sum(elements);
  const std::vector<double> qualities = SumOverRanks(quality, ranks);
  const std::vector<double> volumes = SumOverRanks(volume, ranks);
  ranks.Max(extremes);
  std::vector<PartSummary> united(parts.size());
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    united[p].Material = static_cast<int>(extremes[2 * p + 1]);
    united[p].Elements = elements[p];
    united[p].Points = points[p];
    united[p].MinimumQuality = elements[p] > 0 ? -extremes[2 * p] : 0.0;
    united[p].MeanQuality = elements[p] > 0 ? qualities[p] / static_cast<double>(elements[p]) : 0.0;
    united[p].Volume = volumes[p] * unit;
  }
  return united;
}

/// Adds the hexes that a mesh leaves out.
/// @param place  place(material, fragment) returns the part, from 0
template <class Place>
void AddRuns(const MeshWithRuns& whole, const Place& place, double unit,
  std::vector<PartSums>& parts, std::vector<Index>& points)
{
  for (const CellRuns::Run& run : whole.Cells())
  {
    PartSums& part = parts[place(run.Material, run.Fragment)];
    part.Elements += run.Count;
    part.Material = run.Material;
    part.Volume.Add(whole.VolumeOf(run) / unit);
    part.Minimum = std::min(part.Minimum, 1.0);
    part.Quality.Add(1.0, run.Count);
  }
  for (const MeshWithRuns::NodeRun& run : whole.Nodes())
  {
    points[place(run.Material, run.Fragment)] += run.Count;
  }
}

/// Summarises the parts of a mesh.
/// @param place  place(material, fragment) returns the part, from 0
template <class Place>
std::vector<PartSummary> SummariseParts(const MeshData& mesh, const MeshWithRuns* whole,
  const std::vector<ElementMoments>& moments, const Place& place, std::size_t numberOfParts,
  double unit, Ranks& ranks)
{
  std::vector<int> partOf(mesh.NumberOfElements);
  std::transform(
    mesh.Material, mesh.Material + mesh.NumberOfElements, mesh.Fragment, partOf.begin(), place);
  std::vector<PartSums> parts = SumParts(mesh, moments, partOf, numberOfParts, unit);
  std::vector<Index> points = CountPoints(mesh, partOf, numberOfParts, ranks);
  if (whole)
  {
    AddRuns(*whole, place, unit, parts, points);
  }
  return MergeParts(parts, points, unit, ranks);
}

/// Returns the mean volume of an element, a unit that makes sums independent of the scale
/// of lengths.
double FindUnit(const std::vector<double>& volumes, Index elements, Ranks& ranks)
{
  const std::int64_t count = SumOverRanks(elements, ranks);
  double total = 0.0;
  for (double volume : volumes)
  {
    total += volume;
  }
  return count > 0 && total > 0.0 ? total / static_cast<double>(count) : 1.0;
}

void NameMaterials(
  const MeshData& mesh, const std::vector<double>& ids, std::vector<PartSummary>& materials)
{
  const std::vector<double> targets = GetField(mesh, "TargetVolume");
  const std::map<int, std::string> names = NamesOfMaterials(mesh);
  for (std::size_t m = 0; m < ids.size(); ++m)
  {
    materials[m].Material = static_cast<int>(ids[m]);
    materials[m].Name = NameOfMaterial(names, materials[m].Material);
    materials[m].TargetVolume = targets[m];
  }
}

/// Returns the surfaces of the input, of materials that have one.
std::vector<SurfaceSummary> FindSurfaces(const MeshData& mesh,
  const std::vector<PartSummary>& materials, const std::vector<PartSummary>& fragments)
{
  const std::vector<double> thickness = GetField(mesh, "SurfaceThickness"),
                            widths = GetField(mesh, "SuggestedWidth"),
                            lost = GetField(mesh, "LostSurface"), solids = GetField(mesh, "Solids");
  std::vector<SurfaceSummary> surfaces;
  for (std::size_t m = 0; m < thickness.size(); ++m)
  {
    if (thickness[m] > 0.0)
    {
      const int id = materials[m].Material;
      const auto pieces = std::count_if(fragments.begin(), fragments.end(),
        [id](const PartSummary& fragment) { return fragment.Material == id; });
      surfaces.push_back({ materials[m].Name, id, thickness[m], widths[m], lost[m],
        static_cast<Index>(solids[m]), static_cast<Index>(pieces) });
    }
  }
  return surfaces;
}

} // namespace

MeshSummary Summarise(const MeshData& mesh, Ranks& ranks, const MeshWithRuns* whole)
{
  const std::vector<double> ids = GetField(mesh, "MaterialIds");
  const double unit = FindUnit(
    GetField(mesh, "MeshVolume"), whole ? whole->NumberOfElements() : mesh.NumberOfElements, ranks);
  const auto fragments = static_cast<std::size_t>(GetNumber(mesh, "NumberOfFragments"));
  const std::vector<ElementMoments> moments = FindElementMoments(mesh);
  MeshSummary summary;
  summary.IsTets = FindField(mesh.Fields, "RefusedParts") != nullptr;
  summary.HasQuality = FindField(mesh.Fields, "MinimumScaledJacobian") != nullptr;
  summary.Materials = SummariseParts(
    mesh, whole, moments,
    [&ids](int material, int)
    { return static_cast<int>(std::find(ids.begin(), ids.end(), material) - ids.begin()); },
    ids.size(), unit, ranks);
  NameMaterials(mesh, ids, summary.Materials);
  summary.Fragments = SummariseParts(
    mesh, whole, moments, [](int, int fragment) { return fragment - 1; }, fragments, unit, ranks);
  summary.Total = SummariseParts(
    mesh, whole, moments, [](int, int) { return 0; }, 1, unit, ranks)[0];
  for (const PartSummary& material : summary.Materials)
  {
    summary.Total.TargetVolume += material.TargetVolume;
  }
  summary.Surfaces = FindSurfaces(mesh, summary.Materials, summary.Fragments);
  summary.State = FindStateTotals(mesh);
  summary.LostToElements = SumOfMaterials(mesh, "LostKineticEnergy");
  summary.LostToNodes = SumOfMaterials(mesh, "LostNodalKineticEnergy");
  summary.Particles = FindParticles(mesh);
  summary.MinimumAngle = GetNumber(mesh, "MinimumDihedralAngle");
  summary.MaximumAngle = GetNumber(mesh, "MaximumDihedralAngle");
  for (double count : GetField(mesh, "DihedralAngles"))
  {
    summary.Angles.push_back(static_cast<Index>(count));
  }
  return summary;
}

} // namespace vfm
