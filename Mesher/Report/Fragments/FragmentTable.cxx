#include "Report/Fragments/FragmentTable.h"

#include "Base/ExactSum.h"
#include "Ranks/Agreement.h"
#include "Report/ElementCorners.h"
#include "Report/ElementMoments.h"
#include "Report/GatherMesh.h"
#include "Report/MeshFacets.h"
#include "Report/MeshMaterials.h"
#include "Report/Fragments/PeriodicPieces.h"

#include <limits>
#include <numeric>

namespace vfm
{
namespace
{

using Moments = std::vector<ElementMoments>;

/// Units of the mesh in which sums are taken, so that their relative error does not depend
/// on scale.
struct Units
{
  Vector3 Origin;
  double Length, Volume, Density, Speed;
};

/// Density and velocity of each element; empty if not selected.
struct ElementState
{
  std::vector<double> Density;
  std::vector<Vector3> Velocity;
};

const MeshArray& GetColumns(const MeshData& mesh, const std::string& name, int components)
{
  const MeshArray& array = GetArray(mesh.ElementArrays, name);
  if (array.Components != components)
  {
    throw InputError("The array " + name + " has " + std::to_string(array.Components) +
      " components, not " + (components == 1 ? "one" : std::to_string(components)) + ".");
  }
  return array;
}

std::vector<double> FindDensities(const MeshData& mesh, const std::vector<std::string>& names)
{
  std::vector<const MeshArray*> arrays;
  for (const std::string& name : names)
  {
    arrays.push_back(&GetColumns(mesh, name, 1));
  }
  const std::vector<double> ids = NumbersOfField(mesh.Fields, "MaterialIds");
  if (arrays.size() > 1 && arrays.size() != ids.size())
  {
    throw InputError("There are " + std::to_string(arrays.size()) + " density arrays and " +
      std::to_string(ids.size()) +
      " materials. Choose one array for all materials, or one per material in their order.");
  }
  std::vector<double> densities(arrays.empty() ? 0 : mesh.NumberOfElements, 0.0);
  for (std::size_t e = 0; e < densities.size(); ++e)
  {
    const auto material = std::find(ids.begin(), ids.end(), mesh.Material[e]);
    const std::size_t place = arrays.size() > 1 ? material - ids.begin() : 0;
    densities[e] = place < arrays.size() ? ValueAt(*arrays[place], static_cast<Index>(e)) : 0.0;
  }
  return densities;
}

ElementState FindState(const MeshData& mesh, const FragmentArrays& names)
{
  ElementState state{ FindDensities(mesh, names.Densities), {} };
  if (!names.Velocity.empty())
  {
    const MeshArray& array = GetColumns(mesh, names.Velocity, 3);
    for (Index e = 0; e < mesh.NumberOfElements; ++e)
    {
      state.Velocity.push_back(
        { { ValueAt(array, e, 0), ValueAt(array, e, 1), ValueAt(array, e, 2) } });
    }
  }
  return state;
}

/// Sums over the elements of a fragment on this rank.
struct Sums
{
  Index Elements = 0;
  ExactSum Volume, Mass;
  std::array<ExactSum, 3> Moment, Momentum;
};

constexpr double Nowhere = -std::numeric_limits<double>::infinity();
constexpr int Extremes = 7; // values of a fragment: material, then bounds with negated minima

/// Extends bounds by a point; extremes: six values, minima negated.
void WidenBounds(const double* point, double* extremes)
{
  for (int a = 0; a < 3; ++a)
  {
    extremes[2 * a] = std::max(extremes[2 * a], -point[a]);
    extremes[2 * a + 1] = std::max(extremes[2 * a + 1], point[a]);
  }
}

/// Collective. Finds the units from the maxima over all ranks.
Units FindUnits(
  const MeshData& mesh, const Moments& moments, const ElementState& state, Ranks& ranks)
{
  std::vector<double> extremes(9, Nowhere); // bounds, largest volume, density, speed
  for (Index point = 0; point < mesh.NumberOfPoints; ++point)
  {
    WidenBounds(mesh.Point(point), extremes.data());
  }
  for (const ElementMoments& element : moments)
  {
    extremes[6] = std::max(extremes[6], element.Volume);
  }
  for (double density : state.Density)
  {
    extremes[7] = std::max(extremes[7], std::abs(density));
  }
  for (const Vector3& velocity : state.Velocity)
  {
    extremes[8] = std::max(extremes[8], Norm(velocity));
  }
  ranks.Max(extremes);
  const auto orOne = [](double unit) { return unit > 0.0 ? unit : 1.0; };
  Units units{ { { -extremes[0], -extremes[2], -extremes[4] } }, 0.0, extremes[6],
    orOne(extremes[7]), orOne(extremes[8]) };
  for (int a = 0; a < 3; ++a)
  {
    units.Length = std::max(units.Length, extremes[2 * a + 1] + extremes[2 * a]);
  }
  return units;
}

/// Returns the moments of elements moved by translations; unmoved if there are none.
Moments Translate(Moments moments, const std::vector<Vector3>& translations)
{
  for (std::size_t e = 0; e < translations.size(); ++e)
  {
    moments[e].Moment = moments[e].Moment + moments[e].Volume * translations[e];
  }
  return moments;
}

/// Extends the bounds of fragments by the corners of their elements.
void WidenByElements(
  const MeshData& mesh, const std::vector<Vector3>& translations, std::vector<double>& extremes)
{
  const ElementCorners corners(mesh);
  for (Index e = 0; e < mesh.NumberOfElements; ++e)
  {
    const std::array<Vector3, 8> positions = corners.Find(e);
    const Vector3 move = translations.empty() ? Vector3{} : translations[e];
    for (int c = 0; c < mesh.Corners; ++c)
    {
      const Vector3 moved = positions[c] + move;
      WidenBounds(moved.data(), &extremes[Extremes * (mesh.Fragment[e] - 1) + 1]);
    }
  }
}

/// Sums over the elements of this rank; extremes: sets the material, the first of Extremes values
/// per fragment.
void SumElements(const MeshData& mesh, const Moments& moments, const ElementState& state,
  const Units& units, std::vector<Sums>& sums, std::vector<double>& extremes)
{
  for (Index e = 0; e < mesh.NumberOfElements; ++e)
  {
    const int fragment = mesh.Fragment[e] - 1;
    Sums& sum = sums[fragment];
    const double volume = moments[e].Volume / units.Volume;
    const double mass = state.Density.empty() ? 0.0 : volume * (state.Density[e] / units.Density);
    ++sum.Elements;
    sum.Volume.Add(volume);
    sum.Mass.Add(mass);
    extremes[Extremes * fragment] = mesh.Material[e];
    for (int a = 0; a < 3; ++a)
    {
      const double moment = moments[e].Moment[a] / units.Volume - volume * units.Origin[a];
      sum.Moment[a].Add(moment / units.Length);
      sum.Momentum[a].Add(
        state.Velocity.empty() ? 0.0 : mass * (state.Velocity[e][a] / units.Speed));
    }
  }
}

/// Collective. Makes fragments from the sums and extremes of all ranks.
std::vector<FragmentSummary> MergeFragments(
  const std::vector<Sums>& sums, std::vector<double>& extremes, const Units& units, Ranks& ranks)
{
  std::vector<std::int64_t> elements;
  std::vector<ExactSum> parts;
  for (const Sums& sum : sums)
  {
    elements.push_back(sum.Elements);
    parts.insert(parts.end(), { sum.Volume, sum.Mass });
    parts.insert(parts.end(), sum.Moment.begin(), sum.Moment.end());
    parts.insert(parts.end(), sum.Momentum.begin(), sum.Momentum.end());
  }
  ranks.Sum(elements);
  const std::vector<double> totals = SumOverRanks(parts, ranks);
  ranks.Max(extremes);
  std::vector<FragmentSummary> fragments(sums.size());
  for (std::size_t f = 0; f < fragments.size(); ++f)
  {
    const double* total = &totals[8 * f];
    const double* extreme = &extremes[Extremes * f];
    FragmentSummary& fragment = fragments[f];
    fragment.Material = static_cast<int>(extreme[0]);
    fragment.Elements = elements[f];
    fragment.Volume = total[0] * units.Volume;
    fragment.Mass = total[1] * units.Volume * units.Density;
    for (int a = 0; a < 3; ++a)
    {
      fragment.Centroid[a] = units.Origin[a] + units.Length * total[2 + a] / total[0];
      fragment.Momentum[a] = total[5 + a] * units.Volume * units.Density * units.Speed;
      fragment.Bounds[2 * a] = -extreme[2 * a + 1];
      fragment.Bounds[2 * a + 1] = extreme[2 * a + 2];
    }
  }
  return fragments;
}

/// Collective. Finds the fragments that share faces, also across sides of a periodic domain.
void FindNeighbours(MeshData mesh, Ranks& ranks, std::vector<FragmentSummary>& fragments)
{
  using Pair = std::array<int, 2>;
  std::vector<Pair> pairs;
  mesh.PointIds = mesh.PeriodicPartner ? mesh.PeriodicPartner : mesh.PointIds;
  for (const MeshFacet& face : FindMeshFaces(mesh, mesh.Fragment, ranks))
  {
    if (face.Behind != NothingBehind)
    {
      pairs.push_back({ { mesh.Fragment[face.Element], face.Behind } });
    }
  }
  for (const Pair& pair : UnionOverRanks(ranks, std::move(pairs)))
  {
    fragments[pair[0] - 1].Neighbours.push_back(pair[1]);
  }
}

std::string JoinIds(const std::vector<int>& ids)
{
  std::string text;
  for (int id : ids)
  {
    text += (text.empty() ? "" : " ") + std::to_string(id);
  }
  return text;
}

/// Makes the columns of the table; mesh: source of fields.
FieldArrays ListFragments(
  const std::vector<FragmentSummary>& fragments, const MeshData& mesh, bool hasMass)
{
  FieldArrays columns;
  const auto add = [&](const std::string& name, const auto& get)
  {
    std::vector<std::decay_t<decltype(get(fragments[0]))>> values;
    std::transform(fragments.begin(), fragments.end(), std::back_inserter(values), get);
    columns.push_back({ name, std::move(values) });
  };
  using Row = const FragmentSummary&;
  std::vector<int> ids(fragments.size());
  std::iota(ids.begin(), ids.end(), 1);
  columns.push_back({ "FragmentId", std::move(ids) });
  add("MaterialId", [](Row row) { return row.Material; });
  const std::map<int, std::string> names = NamesOfMaterials(mesh);
  add("Material", [&names](Row row) { return NameOfMaterial(names, row.Material); });
  add("Elements", [](Row row) { return row.Elements; });
  std::vector<double> targets = NumbersOfField(mesh.Fields, "FragmentTargetVolume");
  if (FindField(mesh.Fields, "FragmentTargetVolume") && targets.size() >= fragments.size())
  {
    targets.resize(fragments.size());
    columns.push_back({ "FractionVolume", std::move(targets) });
  }
  add("MeshVolume", [](Row row) { return row.Volume; });
  for (int a = 0; a < 3; ++a)
  {
    add(std::string("Centroid") + "XYZ"[a], [a](Row row) { return row.Centroid[a]; });
  }
  for (int side = 0; side < 6; ++side)
  {
    add(std::string(side % 2 ? "Max" : "Min") + "XYZ"[side / 2],
      [side](Row row) { return row.Bounds[side]; });
  }
  if (hasMass)
  {
    add("Mass", [](Row row) { return row.Mass; });
  }
  add("Neighbours", [](Row row) { return JoinIds(row.Neighbours); });
  return columns;
}

} // namespace

std::vector<FragmentSummary> FindFragments(
  const MeshData& mesh, const FragmentArrays& arrays, Ranks& ranks)
{
  ElementState state;
  Moments moments;
  int last = 0;
  WorkTogether(ranks,
    [&]
    {
      if (mesh.NumberOfElements > 0)
      {
        Require(mesh.Fragment, "FragmentId", mesh);
        Require(mesh.Material, "MaterialId", mesh);
        state = FindState(mesh, arrays);
        moments = FindElementMoments(mesh);
        const auto [least, most] =
          std::minmax_element(mesh.Fragment, mesh.Fragment + mesh.NumberOfElements);
        if (*least < 1)
        {
          throw InputError("FragmentId " + std::to_string(*least) + " is less than 1.");
        }
        last = *most;
      }
    });
  const auto count = static_cast<std::size_t>(ranks.Max(last));
  const Units units = FindUnits(mesh, moments, state, ranks);
  std::vector<Sums> sums(count);
  std::vector<double> extremes(Extremes * count, Nowhere);
  const std::vector<Vector3> translations = FindTranslations(mesh, ranks);
  moments = Translate(std::move(moments), translations);
  SumElements(mesh, moments, state, units, sums, extremes);
  WidenByElements(mesh, translations, extremes);
  std::vector<FragmentSummary> fragments = MergeFragments(sums, extremes, units, ranks);
  FindNeighbours(mesh, ranks, fragments);
  return fragments;
}

FieldArrays MakeFragmentTable(
  const MeshData& mesh, const std::vector<std::string>& densities, Ranks& ranks)
{
  const std::vector<FragmentSummary> fragments = FindFragments(mesh, { densities, "" }, ranks);
  const MeshData head = fragments.empty() ? mesh : ShareHead(mesh, ranks);
  return ranks.Rank() == 0 ? ListFragments(fragments, head, !densities.empty()) : FieldArrays();
}

} // namespace vfm
