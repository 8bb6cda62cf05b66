#include "Report/Fragments/FragmentTable.h"

#include "Base/Sorted.h"
#include "Ranks/Agreement.h"
#include "Report/ElementCorners.h"
#include "Report/ElementMoments.h"
#include "Report/FragmentTargets.h"
#include "Report/FragmentWays.h"
#include "Report/Fragments/FragmentPairs.h"
#include "Report/Fragments/PeriodicPieces.h"
#include "Report/Gather/GatherMesh.h"
#include "Report/Gather/PackMesh.h"
#include "Report/MeshMaterials.h"

#include <limits>
#include <map>
#include <utility>

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

constexpr std::size_t VolumeSums = 4; // volume and first moments
constexpr std::size_t MassSums = 4;   // mass and momentum

/// Values of each fragment of this rank, or, combined over all ranks, of each of its rows.
struct FragmentValues
{
  std::vector<Index> Elements;
  std::vector<ExactSum> Volumes; ///< VolumeSums per fragment
  std::vector<ExactSum> Masses;  ///< MassSums per fragment; empty without densities
  std::vector<double> Extremes;  ///< ExtremeValues per fragment
  std::vector<double> Targets;   ///< target volume, below 0 where it is unknown
};

constexpr double Nowhere = -std::numeric_limits<double>::infinity();
constexpr std::size_t ExtremeValues = 7; // material, then bounds with negated minima

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

/// Returns the extremes of each fragment of this rank, from its elements and their corners.
std::vector<double> FindExtremes(
  const MeshData& mesh, const std::vector<Vector3>& translations, const FragmentWays& ways)
{
  std::vector<double> extremes(ExtremeValues * ways.Ids().size(), Nowhere);
  const ElementCorners corners(mesh);
  for (Index e = 0; e < mesh.NumberOfElements; ++e)
  {
    double* const values = &extremes[ExtremeValues * ways.PlaceOfElement()[e]];
    values[0] = mesh.Material[e];
    const std::array<Vector3, 8> positions = corners.Find(e);
    const Vector3 move = translations.empty() ? Vector3{} : translations[e];
    for (int c = 0; c < mesh.Corners; ++c)
    {
      const Vector3 moved = positions[c] + move;
      WidenBounds(moved.data(), values + 1);
    }
  }
  return extremes;
}

std::vector<Index> CountElements(const FragmentWays& ways)
{
  std::vector<Index> counts(ways.Ids().size(), 0);
  for (int place : ways.PlaceOfElement())
  {
    ++counts[place];
  }
  return counts;
}

std::vector<ExactSum> SumVolumes(
  const Moments& moments, const Units& units, const FragmentWays& ways)
{
  std::vector<ExactSum> sums(VolumeSums * ways.Ids().size());
  for (std::size_t e = 0; e < moments.size(); ++e)
  {
    ExactSum* const of = &sums[VolumeSums * ways.PlaceOfElement()[e]];
    const double volume = moments[e].Volume / units.Volume;
    of[0].Add(volume);
    for (int a = 0; a < 3; ++a)
    {
      const double moment = moments[e].Moment[a] / units.Volume - volume * units.Origin[a];
      of[1 + a].Add(moment / units.Length);
    }
  }
  return sums;
}

std::vector<ExactSum> SumMasses(
  const Moments& moments, const ElementState& state, const Units& units, const FragmentWays& ways)
{
  std::vector<ExactSum> sums(MassSums * ways.Ids().size());
  for (std::size_t e = 0; e < moments.size(); ++e)
  {
    ExactSum* const of = &sums[MassSums * ways.PlaceOfElement()[e]];
    const double mass = moments[e].Volume / units.Volume * (state.Density[e] / units.Density);
    of[0].Add(mass);
    for (int a = 0; a < 3 && !state.Velocity.empty(); ++a)
    {
      of[1 + a].Add(mass * (state.Velocity[e][a] / units.Speed));
    }
  }
  return sums;
}

/// Collective. Returns the values of the rows of this rank from those of all ranks. Takes one list
/// after the other, so that few copies exist at a time.
FragmentValues Combine(FragmentValues own, bool hasMass, const FragmentWays& ways)
{
  FragmentValues rows;
  rows.Elements = ways.Sum(std::move(own.Elements), 1);
  rows.Volumes = ways.Sum(std::move(own.Volumes), VolumeSums);
  if (hasMass)
  {
    rows.Masses = ways.Sum(std::move(own.Masses), MassSums);
  }
  rows.Extremes = ways.Max(std::move(own.Extremes), ExtremeValues);
  rows.Targets = ways.Max(std::move(own.Targets), 1);
  return rows;
}

/// Sets the volume and the centroid of a fragment, and its mass and momentum unless masses is null.
void SetSums(
  const ExactSum* volumes, const ExactSum* masses, const Units& units, FragmentSummary& row)
{
  const double total = volumes[0].Value();
  row.Volume = total * units.Volume;
  row.Mass = masses ? masses[0].Value() * units.Volume * units.Density : 0.0;
  for (int a = 0; a < 3; ++a)
  {
    row.Centroid[a] = units.Origin[a] + units.Length * volumes[1 + a].Value() / total;
    row.Momentum[a] =
      masses ? masses[1 + a].Value() * units.Volume * units.Density * units.Speed : 0.0;
  }
}

/// Returns the rows of fragments with elements, without their neighbours.
std::vector<FragmentSummary> MakeRows(
  const FragmentValues& values, const Units& units, const FragmentWays& ways)
{
  std::vector<FragmentSummary> rows;
  rows.reserve(ways.HomeIds().size());
  for (std::size_t r = 0; r < ways.HomeIds().size(); ++r)
  {
    if (values.Elements[r] == 0)
    {
      continue;
    }
    const double* extreme = &values.Extremes[ExtremeValues * r];
    FragmentSummary row;
    row.Id = ways.HomeIds()[r];
    row.Material = static_cast<int>(extreme[0]);
    row.Elements = values.Elements[r];
    row.TargetVolume = values.Targets[r];
    SetSums(&values.Volumes[VolumeSums * r],
      values.Masses.empty() ? nullptr : &values.Masses[MassSums * r], units, row);
    for (int a = 0; a < 3; ++a)
    {
      row.Bounds[2 * a] = -extreme[2 * a + 1];
      row.Bounds[2 * a + 1] = extreme[2 * a + 2];
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Collective. Sets the neighbours of the rows of this rank.
/// @param pairs  fragments that share faces with elements of this rank
void SetNeighbours(std::vector<FragmentPair> pairs, const FragmentWays& ways, Ranks& ranks,
  std::vector<FragmentSummary>& rows)
{
  const KeyMerge<FragmentPair> all(
    std::move(pairs), [&ways](const FragmentPair& pair) { return ways.HomeOf(pair[0]); }, ranks);
  auto row = rows.begin();
  for (const FragmentPair& pair : all.HomeKeys())
  {
    row = std::find_if(row, rows.end(), [&](const auto& other) { return other.Id == pair[0]; });
    row->Neighbours.push_back(pair[1]);
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

/// Makes the columns of the table.
/// @param names  names of materials by id
FieldArrays ListFragments(const std::vector<FragmentSummary>& fragments,
  const std::map<int, std::string>& names, bool hasTargets, bool hasMass)
{
  FieldArrays columns;
  const auto add = [&](const std::string& name, const auto& get)
  {
    std::vector<std::decay_t<decltype(get(fragments[0]))>> values;
    values.reserve(fragments.size());
    std::transform(fragments.begin(), fragments.end(), std::back_inserter(values), get);
    columns.push_back({ name, std::move(values) });
  };
  using Row = const FragmentSummary&;
  add("FragmentId", [](Row row) { return row.Id; });
  add("MaterialId", [](Row row) { return row.Material; });
  add("Material", [&names](Row row) { return NameOfMaterial(names, row.Material); });
  add("Elements", [](Row row) { return row.Elements; });
  if (hasTargets)
  {
    add("FractionVolume", [](Row row) { return row.TargetVolume; });
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

/// Collective. Returns the names of materials on all ranks, also on those without elements.
std::map<int, std::string> ShareNames(const MeshData& mesh, Ranks& ranks)
{
  MeshData head; // with the names only
  head.NumberOfElements = mesh.NumberOfElements;
  std::copy_if(mesh.Fields.begin(), mesh.Fields.end(), std::back_inserter(head.Fields),
    [](const FieldArray& field)
    { return field.Name == "MaterialNames" || field.Name == "MaterialIds"; });
  const bool isEmpty = !ranks.Any(mesh.NumberOfElements > 0);
  return NamesOfMaterials(isEmpty ? head : ShareHead(head, ranks));
}

std::size_t CountRows(const FieldArrays& columns)
{
  return columns.empty()
    ? 0
    : std::visit([](const auto& values) { return values.size(); }, columns[0].Values);
}

/// Appends the rows of a table to another one with the same columns.
void AppendRows(FieldArrays more, FieldArrays& to)
{
  for (std::size_t c = 0; c < to.size(); ++c)
  {
    std::visit(
      [&](auto& values)
      {
        auto& from = std::get<std::decay_t<decltype(values)>>(more[c].Values);
        values.insert(
          values.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
      },
      to[c].Values);
  }
}

} // namespace

std::vector<FragmentSummary> FindFragments(
  const MeshData& mesh, const FragmentArrays& arrays, Ranks& ranks)
{
  ElementState state;
  Moments moments;
  WorkTogether(ranks,
    [&]
    {
      if (mesh.NumberOfElements > 0)
      {
        Require(mesh.Fragment, "FragmentId", mesh);
        Require(mesh.Material, "MaterialId", mesh);
        state = FindState(mesh, arrays);
        moments = FindElementMoments(mesh);
        const int least = *std::min_element(mesh.Fragment, mesh.Fragment + mesh.NumberOfElements);
        if (least < 1)
        {
          throw InputError("FragmentId " + std::to_string(least) + " is less than 1.");
        }
      }
    });
  const bool hasMass = !arrays.Densities.empty();
  std::vector<FragmentPair> pairs = FindFragmentPairs(mesh, ranks);
  const Units units = FindUnits(mesh, moments, state, ranks);
  const FragmentWays ways(mesh, ListRankFragments(mesh.Fields), ranks);
  const std::vector<Vector3> translations = FindTranslations(mesh, ranks);
  moments = Translate(std::move(moments), translations);
  FragmentValues own{ CountElements(ways), SumVolumes(moments, units, ways), {},
    FindExtremes(mesh, translations, ways), FindFragmentTargets(mesh.Fields, ways.Ids()) };
  if (hasMass)
  {
    own.Masses = SumMasses(moments, state, units, ways);
  }
  std::vector<FragmentSummary> rows = MakeRows(Combine(std::move(own), hasMass, ways), units, ways);
  SetNeighbours(std::move(pairs), ways, ranks, rows);
  return rows;
}

FieldArrays MakeFragmentTable(
  const MeshData& mesh, const std::vector<std::string>& densities, Ranks& ranks)
{
  const std::vector<FragmentSummary> rows = FindFragments(mesh, { densities, "" }, ranks);
  const bool lacksTargets = std::any_of(
    rows.begin(), rows.end(), [](const FragmentSummary& row) { return row.TargetVolume < 0.0; });
  const bool hasTargets = !ranks.Any(lacksTargets) && ranks.Any(HasFragmentTargets(mesh.Fields));
  return ListFragments(rows, ShareNames(mesh, ranks), hasTargets, !densities.empty());
}

FieldArrays GatherTable(FieldArrays part, TableMode mode, Ranks& ranks)
{
  const Index rows = SumOverRanks(static_cast<Index>(CountRows(part)), ranks);
  if (!HasWholeTable(mode, rows))
  {
    return part;
  }
  MeshData carrier;
  if (ranks.Rank() > 0)
  {
    carrier.Fields = std::move(part);
    part = FieldArrays();
  }
  for (Bytes& other : SendToFirst(PackHead(carrier), ranks))
  {
    AppendRows(UnpackMesh(std::exchange(other, Bytes())).Data.Fields, part);
  }
  return part;
}

} // namespace vfm
