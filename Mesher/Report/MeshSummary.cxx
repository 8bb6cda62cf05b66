#include "Report/MeshSummary.h"

#include "Base/ExactSum.h"
#include "Base/Sorted.h"
#include "Elements/MeshWithRuns.h"
#include "Ranks/Agreement.h"
#include "Report/ElementMoments.h"
#include "Report/FragmentWays.h"
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

/// Adds the hexes that a mesh leaves out, which are cells.
/// @param mesh  the mesh without them
/// @param place  place(material, fragment) returns the part, from 0
template <class Place>
void AddRuns(const MeshData& mesh, const MeshWithRuns& whole, const Place& place, double unit,
  std::vector<PartSums>& parts)
{
  const bool hasQuality = FindArray(mesh.ElementArrays, "ScaledJacobian") != nullptr;
  for (const CellRuns::Run& run : whole.Cells())
  {
    PartSums& part = parts[place(run.Material, run.Fragment)];
    part.Elements += run.Count;
    part.Material = run.Material;
    part.Volume.Add(whole.VolumeOf(run) / unit);
    part.Minimum = hasQuality ? std::min(part.Minimum, 1.0) : part.Minimum;
    part.Quality.Add(1.0, hasQuality ? run.Count : 0);
  }
}

/// Adds the points that a mesh leaves out.
template <class Place>
void AddPointsOfRuns(const MeshWithRuns& whole, const Place& place, std::vector<Index>& points)
{
  for (const MeshWithRuns::NodeRun& run : whole.Nodes())
  {
    points[place(run.Material, run.Fragment)] += run.Count;
  }
}

/// Sums of parts as lists, to combine them over ranks.
struct PartLists
{
  std::vector<std::int64_t> Elements;
  std::vector<ExactSum> Sums;   ///< quality and volume of each part
  std::vector<double> Extremes; ///< negated minimum of the quality, and material of each part
};
constexpr std::size_t SumsPerPart = 2, ExtremesPerPart = 2;

PartLists ListSums(const std::vector<PartSums>& parts)
{
  PartLists lists;
  for (const PartSums& part : parts)
  {
    lists.Elements.push_back(part.Elements);
    lists.Sums.insert(lists.Sums.end(), { part.Quality, part.Volume });
    lists.Extremes.push_back(-part.Minimum);
    lists.Extremes.push_back(part.Material);
  }
  return lists;
}

/// Returns a part from its values over all ranks.
/// @param sums  values of its SumsPerPart sums
/// @param extremes  its ExtremesPerPart values
PartSizes MakePart(
  Index elements, Index points, const double* sums, const double* extremes, double unit)
{
  PartSizes part;
  part.Material = static_cast<int>(extremes[1]);
  part.Elements = elements;
  part.Points = points;
  part.MinimumQuality = elements > 0 ? -extremes[0] : 0.0;
  part.MeanQuality = elements > 0 ? sums[0] / static_cast<double>(elements) : 0.0;
  part.Volume = sums[1] * unit;
  return part;
}

/// Summarises the parts of a mesh.
/// @param place  place(material, fragment) returns the part, from 0
/// @pre Collective
template <class Place>
std::vector<PartSummary> SummariseParts(const MeshData& mesh, const MeshWithRuns* whole,
  const std::vector<ElementMoments>& moments, const Place& place, std::size_t numberOfParts,
  double unit, Ranks& ranks)
{
  std::vector<int> partOf(mesh.NumberOfElements);
  std::transform(
    mesh.Material, mesh.Material + mesh.NumberOfElements, mesh.Fragment, partOf.begin(), place);
  std::vector<PartSums> own = SumParts(mesh, moments, partOf, numberOfParts, unit);
  std::vector<Index> points = CountPoints(mesh, partOf, numberOfParts, ranks);
  if (whole)
  {
    AddRuns(mesh, *whole, place, unit, own);
    AddPointsOfRuns(*whole, place, points);
  }
  PartLists lists = ListSums(own);
  ranks.Sum(lists.Elements);
  const std::vector<double> sums = SumOverRanks(lists.Sums, ranks);
  ranks.Max(lists.Extremes);
  std::vector<PartSummary> parts(numberOfParts);
  for (std::size_t p = 0; p < numberOfParts; ++p)
  {
    static_cast<PartSizes&>(parts[p]) = MakePart(lists.Elements[p], points[p],
      &sums[SumsPerPart * p], &lists.Extremes[ExtremesPerPart * p], unit);
  }
  return parts;
}

/// Returns the fragments whose rows this rank has (FragmentWays).
/// @pre Collective
std::vector<FragmentSizes> SummariseFragments(const MeshData& mesh, const MeshWithRuns* whole,
  const std::vector<ElementMoments>& moments, double unit, Ranks& ranks)
{
  std::vector<int> ofRuns;
  for (const CellRuns::Run& run : whole ? whole->Cells() : std::vector<CellRuns::Run>())
  {
    ofRuns.push_back(run.Fragment);
  }
  const FragmentWays ways(mesh, ofRuns, ranks);
  std::vector<PartSums> own =
    SumParts(mesh, moments, ways.PlaceOfElement(), ways.Ids().size(), unit);
  if (whole)
  {
    AddRuns(
      mesh, *whole, [&ways](int, int fragment) { return FindSorted(ways.Ids(), fragment); }, unit,
      own);
  }
  PartLists lists = ListSums(own);
  lists.Elements = ways.Sum(std::move(lists.Elements), 1);
  lists.Sums = ways.Sum(std::move(lists.Sums), SumsPerPart);
  lists.Extremes = ways.Max(std::move(lists.Extremes), ExtremesPerPart);
  PointsOfFragments counted = CountFragmentPoints(mesh, ranks);
  const KeyMerge<int> pointWays(
    std::move(counted.Fragments), [&ways](int id) { return ways.HomeOf(id); }, ranks);
  std::vector<Index> points =
    pointWays.ToHome(std::move(counted.Counts), 1, [](Index& a, Index b) { a += b; });
  if (whole) // of a single rank, which has all rows
  {
    AddPointsOfRuns(
      *whole, [&ways](int, int fragment) { return FindSorted(ways.HomeIds(), fragment); }, points);
  }
  std::vector<FragmentSizes> fragments(ways.HomeIds().size());
  for (std::size_t f = 0; f < fragments.size(); ++f)
  {
    const double sums[] = { lists.Sums[SumsPerPart * f].Value(),
      lists.Sums[SumsPerPart * f + 1].Value() };
    static_cast<PartSizes&>(fragments[f]) =
      MakePart(lists.Elements[f], points[f], sums, &lists.Extremes[ExtremesPerPart * f], unit);
    fragments[f].Id = ways.HomeIds()[f];
  }
  return fragments;
}

/// Returns the largest fragments of all ranks.
/// @param own  fragments of this rank
/// @pre Collective
std::vector<FragmentSizes> FindLargest(std::vector<FragmentSizes> own, Ranks& ranks)
{
  const std::size_t count = std::min(MaximumFragments, own.size());
  std::partial_sort(own.begin(), own.begin() + static_cast<Index>(count), own.end());
  own.resize(count);
  return UnionOverRanks(ranks, std::move(own), MaximumFragments);
}

/// Returns the number of fragments of each material.
/// @param ids  materials
/// @param own  fragments of this rank
/// @pre Collective
std::vector<std::int64_t> CountFragments(
  const std::vector<double>& ids, const std::vector<FragmentSizes>& own, Ranks& ranks)
{
  std::vector<std::int64_t> counts(ids.size(), 0);
  for (const FragmentSizes& fragment : own)
  {
    const auto at = std::find(ids.begin(), ids.end(), fragment.Material);
    if (at != ids.end())
    {
      ++counts[at - ids.begin()];
    }
  }
  ranks.Sum(counts);
  return counts;
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
/// @param fragments  number of fragments of each material
std::vector<SurfaceSummary> FindSurfaces(const MeshData& mesh,
  const std::vector<PartSummary>& materials, const std::vector<std::int64_t>& fragments)
{
  const std::vector<double> thickness = GetField(mesh, "SurfaceThickness"),
                            widths = GetField(mesh, "SuggestedWidth"),
                            lost = GetField(mesh, "LostSurface"), solids = GetField(mesh, "Solids");
  std::vector<SurfaceSummary> surfaces;
  for (std::size_t m = 0; m < thickness.size(); ++m)
  {
    if (thickness[m] > 0.0)
    {
      surfaces.push_back({ materials[m].Name, materials[m].Material, thickness[m], widths[m],
        lost[m], static_cast<Index>(solids[m]), fragments[m] });
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
  const std::vector<FragmentSizes> fragments =
    SummariseFragments(mesh, whole, moments, unit, ranks);
  summary.NumberOfFragments = static_cast<Index>(GetNumber(mesh, "NumberOfFragments"));
  summary.LargestFragments = FindLargest(fragments, ranks);
  summary.Total = SummariseParts(
    mesh, whole, moments, [](int, int) { return 0; }, 1, unit, ranks)[0];
  summary.Total.Material = -1;
  for (const PartSummary& material : summary.Materials)
  {
    summary.Total.TargetVolume += material.TargetVolume;
  }
  summary.Surfaces = FindSurfaces(mesh, summary.Materials, CountFragments(ids, fragments, ranks));
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
