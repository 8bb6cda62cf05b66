#include "Report/Sets/MaterialBins.h"

#include "Base/ExactSum.h"
#include "Base/ParseText.h"
#include "Ranks/Agreement.h"
#include "Report/ElementMoments.h"
#include "Report/MeshMaterials.h"
#include "Report/UniqueNames.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace vfm
{
namespace
{

constexpr const char* Columns[] = { "BinIds", "BinNames", "BinMaterials", "BinNumbers", "BinLower",
  "BinUpper", "BinMean", "BinVolume", "BinElements", "BinDensity", "BinModulus", "BinPoisson" };

std::string TextOf(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

/// Intervals of equal width.
struct Intervals
{
  double Lower, Upper;
  int Count;

  double Edge(int number) const
  {
    return number == this->Count ? this->Upper
                                 : this->Lower + (this->Upper - this->Lower) / this->Count * number;
  }
  /// Returns the interval of a value, from 0.
  int Find(double value) const
  {
    const double width = (this->Upper - this->Lower) / this->Count;
    int number = width > 0.0 ? static_cast<int>((value - this->Lower) / width) : 0;
    number = std::clamp(number, 0, this->Count - 1);
    // Rounding may give the interval next to that between the edges.
    number -= number > 0 && value < this->Edge(number) ? 1 : 0;
    number += number + 1 < this->Count && value >= this->Edge(number + 1) ? 1 : 0;
    return number;
  }
};

/// The elements that are grouped, with their values.
struct Selection
{
  std::vector<Index> Elements;
  std::vector<double> Values;
};

void CheckRule(const BinRule& rule)
{
  if (rule.Count < 1 || rule.Count > LargestBinCount)
  {
    throw InputError("The number of bins is " + std::to_string(rule.Count) + ": it must be 1 to " +
      std::to_string(LargestBinCount) + ".");
  }
  if (!rule.Law)
  {
    return;
  }
  const ElasticLaw& law = *rule.Law;
  for (const auto& [name, value] :
    { std::pair("factor a", law.Factor), { "exponent b", law.Exponent },
      { "Poisson's ratio", law.Poisson }, { "offset c0", law.Offset }, { "slope c1", law.Slope } })
  {
    if (!std::isfinite(value))
    {
      throw InputError(std::string("The ") + name + " of the law of bins is not finite.");
    }
  }
  if (law.Factor <= 0.0)
  {
    throw InputError(
      "The factor a of the law of bins is " + TextOf(law.Factor) + ": it must be above 0.");
  }
  if (law.Poisson <= -1.0 || law.Poisson >= 0.5)
  {
    throw InputError(
      "Poisson's ratio of bins is " + TextOf(law.Poisson) + ": it must be above -1 and below 0.5.");
  }
}

const MeshArray& FindValues(const MeshData& mesh, const std::string& name)
{
  const MeshArray* array = FindArray(mesh.ElementArrays, name);
  if (!array)
  {
    std::vector<std::string> names;
    for (const MeshArray& one : mesh.ElementArrays)
    {
      names.push_back(one.Name);
    }
    throw InputError("The mesh has no array '" + name + "' of elements for bins. It has " +
      (names.empty() ? "none" : JoinTexts(names)) + ".");
  }
  if (array->Components != 1)
  {
    throw InputError("The array '" + name + "' has " + std::to_string(array->Components) +
      " components: bins need one.");
  }
  return *array;
}

Selection Select(const MeshData& mesh, const MeshArray& array, const std::vector<int>& materials)
{
  Selection chosen;
  for (Index element = 0; element < mesh.NumberOfElements; ++element)
  {
    if (std::binary_search(materials.begin(), materials.end(), mesh.Material[element]))
    {
      chosen.Elements.push_back(element);
      chosen.Values.push_back(ValueAt(array, element));
    }
  }
  return chosen;
}

/// Returns the materials to group, ascending.
/// @pre Collective
std::vector<int> ChooseMaterials(const MeshData& mesh, const std::vector<int>& given, Ranks& ranks)
{
  std::vector<int> materials = FindMaterials(mesh, ranks), chosen = given;
  if (given.empty())
  {
    materials.erase(std::remove(materials.begin(), materials.end(), 0), materials.end());
    return materials;
  }
  std::sort(chosen.begin(), chosen.end());
  for (int material : chosen)
  {
    if (!std::binary_search(materials.begin(), materials.end(), material))
    {
      throw InputError(
        "No element has the material " + std::to_string(material) + ", which bins are to divide.");
    }
  }
  return chosen;
}

/// @pre Collective
Intervals FindIntervals(const std::vector<double>& values, const BinRule& rule, Ranks& ranks)
{
  const Index wrong = SumOverRanks(
    std::count_if(values.begin(), values.end(), [](double value) { return !std::isfinite(value); }),
    ranks);
  if (wrong > 0)
  {
    throw InputError("The array '" + rule.Array + "' has " + std::to_string(wrong) +
      " values that are not finite, so its range cannot be divided into bins.");
  }
  constexpr double none = -std::numeric_limits<double>::infinity();
  std::vector<double> extremes{ none, none };
  for (double value : values)
  {
    extremes = { std::max(extremes[0], -value), std::max(extremes[1], value) };
  }
  ranks.Max(extremes);
  const Intervals intervals{ -extremes[0], extremes[1], rule.Count };
  if (extremes[1] == none)
  {
    throw InputError("The mesh has no elements that bins can divide.");
  }
  if (rule.Count > 1 && !(intervals.Lower < intervals.Upper))
  {
    throw InputError("All values of the array '" + rule.Array + "' are " + TextOf(intervals.Lower) +
      ": such a range cannot be divided into bins.");
  }
  if (!std::isfinite(intervals.Upper - intervals.Lower))
  {
    throw InputError("The range of the array '" + rule.Array + "' is too large for bins.");
  }
  return intervals;
}

/// Returns the least power of two above the magnitudes of all ranks, so that ExactSum keeps their
/// digits; 1 if all are 0.
/// @pre Collective
double FindScale(const std::vector<double>& values, Ranks& ranks)
{
  double largest = 0.0;
  for (double value : values)
  {
    largest = std::max(largest, std::fabs(value));
  }
  largest = ranks.Max(largest);
  int exponent = 0;
  std::frexp(largest, &exponent);
  return largest > 0.0 ? std::ldexp(1.0, std::min(exponent, 1022)) : 1.0;
}

/// Sets the volume, the mean value and the number of elements of each group.
/// @param groups  number of the group in bins of each selected element
/// @pre Collective
void Measure(const MeshData& mesh, const Selection& chosen, const std::vector<std::size_t>& groups,
  Ranks& ranks, std::vector<MaterialBin>& bins)
{
  const std::vector<ElementMoments> moments = FindElementMoments(mesh);
  std::vector<double> volumes;
  std::transform(chosen.Elements.begin(), chosen.Elements.end(), std::back_inserter(volumes),
    [&](Index element) { return moments[element].Volume; });
  const double ofVolume = FindScale(volumes, ranks), ofValue = FindScale(chosen.Values, ranks);
  std::vector<ExactSum> sums(2 * bins.size());
  std::vector<std::int64_t> counts(bins.size(), 0);
  for (std::size_t e = 0; e < groups.size(); ++e)
  {
    const double volume = volumes[e] / ofVolume;
    sums[2 * groups[e]].Add(volume);
    sums[2 * groups[e] + 1].Add(volume * (chosen.Values[e] / ofValue));
    ++counts[groups[e]];
  }
  ranks.Sum(counts);
  const std::vector<double> totals = SumOverRanks(sums, ranks);
  for (std::size_t b = 0; b < bins.size(); ++b)
  {
    const double volume = totals[2 * b], integral = totals[2 * b + 1];
    bins[b].Volume = volume * ofVolume;
    // Rounding must not move the mean out of the interval.
    bins[b].Mean = std::clamp(
      volume > 0.0 ? integral / volume * ofValue : bins[b].Lower, bins[b].Lower, bins[b].Upper);
    bins[b].Elements = counts[b];
  }
}

ElasticConstants ApplyLaw(const ElasticLaw& law, const MaterialBin& bin)
{
  ElasticConstants constants{ law.Offset + law.Slope * bin.Mean, 0.0, law.Poisson };
  if (!(constants.Density > 0.0) || !std::isfinite(constants.Density))
  {
    throw InputError("The density of " + bin.Name + " is " + TextOf(constants.Density) +
      ", from the mean value " + TextOf(bin.Mean) +
      ": it must be above 0. Choose c0 and c1, or raise the lowest values.");
  }
  constants.Modulus = law.Factor * std::pow(constants.Density, law.Exponent);
  if (!(constants.Modulus > 0.0) || !std::isfinite(constants.Modulus))
  {
    throw InputError("The modulus of " + bin.Name + " is " + TextOf(constants.Modulus) +
      ", from the density " + TextOf(constants.Density) + ": it must be above 0 and finite.");
  }
  return constants;
}

std::string NameOf(const std::string& material, int number, int count)
{
  const std::string digits = std::to_string(number);
  const std::size_t width = std::max<std::size_t>(2, std::to_string(count).size());
  return material + "_bin_" + std::string(width - digits.size(), '0') + digits;
}

/// Makes the groups that have elements on any rank, without measurements, and sets the group of
/// each selected element.
/// @pre Collective
std::vector<MaterialBin> MakeBins(const MeshData& mesh, const Selection& chosen,
  const Intervals& intervals, Ranks& ranks, std::vector<std::size_t>& groups)
{
  using Key = std::pair<int, int>; // material and interval
  std::vector<Key> keys;
  for (std::size_t e = 0; e < chosen.Elements.size(); ++e)
  {
    keys.emplace_back(mesh.Material[chosen.Elements[e]], intervals.Find(chosen.Values[e]));
  }
  const auto pack = [&](const Key& key) { return Index(key.first) * LargestBinCount + key.second; };
  std::vector<Index> packed;
  std::transform(keys.begin(), keys.end(), std::back_inserter(packed), pack);
  const std::vector<Index> all = UnionOverRanks(ranks, packed);
  const int last = FindVoidId(mesh, ranks);
  if (static_cast<Index>(all.size()) > std::numeric_limits<int>::max() - Index(last))
  {
    throw InputError("No ids are left for bins: the ids of materials are too large.");
  }
  const std::map<int, std::string> names = NamesOfMaterials(mesh);
  std::vector<MaterialBin> bins;
  for (Index key : all)
  {
    const int material = static_cast<int>(key / LargestBinCount),
              number = static_cast<int>(key % LargestBinCount);
    bins.push_back({ last + 1 + static_cast<int>(bins.size()), material, number + 1,
      NameOf(NameOfMaterial(names, material), number + 1, intervals.Count), intervals.Edge(number),
      intervals.Edge(number + 1), 0.0, 0.0, 0 });
  }
  for (Index key : packed)
  {
    groups.push_back(
      static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), key) - all.begin()));
  }
  return bins;
}

/// Returns a column as integers.
std::vector<int> IntegersOf(const MeshData& mesh, const char* name)
{
  const std::vector<double> numbers = NumbersOfField(mesh.Fields, name);
  return { numbers.begin(), numbers.end() };
}

template <class T, class Get>
FieldArray Column(const char* name, const std::vector<MaterialBin>& bins, const Get& get)
{
  std::vector<T> values;
  std::transform(bins.begin(), bins.end(), std::back_inserter(values), get);
  return { name, std::move(values) };
}

} // namespace

BinnedElements BinElements(const MeshData& mesh, const BinRule& rule, Ranks& ranks)
{
  BinnedElements result;
  WorkTogether(ranks,
    [&]
    {
      CheckRule(rule);
      const MeshArray& array = FindValues(mesh, rule.Array);
      const std::vector<int> materials = ChooseMaterials(mesh, rule.Materials, ranks);
      const Selection chosen = Select(mesh, array, materials);
      const Intervals intervals = FindIntervals(chosen.Values, rule, ranks);
      std::vector<std::size_t> groups;
      result.Bins = MakeBins(mesh, chosen, intervals, ranks, groups);
      Measure(mesh, chosen, groups, ranks, result.Bins);
      for (MaterialBin& bin : result.Bins)
      {
        bin.Elastic = rule.Law ? std::optional(ApplyLaw(*rule.Law, bin)) : std::nullopt;
      }
      result.Ids.assign(mesh.NumberOfElements, 0);
      for (std::size_t e = 0; e < groups.size(); ++e)
      {
        result.Ids[chosen.Elements[e]] = result.Bins[groups[e]].Id;
      }
      result.Fields = ListBins(result.Bins);
    });
  return result;
}

std::vector<FieldArray> ListBins(const std::vector<MaterialBin>& bins)
{
  using Bin = const MaterialBin&;
  std::vector<FieldArray> fields{
    Column<int>("BinIds", bins, [](Bin bin) { return bin.Id; }),
    Column<std::string>("BinNames", bins, [](Bin bin) { return bin.Name; }),
    Column<int>("BinMaterials", bins, [](Bin bin) { return bin.Material; }),
    Column<int>("BinNumbers", bins, [](Bin bin) { return bin.Number; }),
    Column<double>("BinLower", bins, [](Bin bin) { return bin.Lower; }),
    Column<double>("BinUpper", bins, [](Bin bin) { return bin.Upper; }),
    Column<double>("BinMean", bins, [](Bin bin) { return bin.Mean; }),
    Column<double>("BinVolume", bins, [](Bin bin) { return bin.Volume; }),
    Column<Index>("BinElements", bins, [](Bin bin) { return bin.Elements; }),
  };
  if (!bins.empty() && bins.front().Elastic)
  {
    fields.push_back(
      Column<double>("BinDensity", bins, [](Bin bin) { return bin.Elastic->Density; }));
    fields.push_back(
      Column<double>("BinModulus", bins, [](Bin bin) { return bin.Elastic->Modulus; }));
    fields.push_back(
      Column<double>("BinPoisson", bins, [](Bin bin) { return bin.Elastic->Poisson; }));
  }
  return fields;
}

std::vector<MaterialBin> ReadBins(const MeshData& mesh)
{
  const FieldArray* names = FindField(mesh.Fields, "BinNames");
  const auto* texts = names ? std::get_if<std::vector<std::string>>(&names->Values) : nullptr;
  const std::vector<int> ids = IntegersOf(mesh, "BinIds"),
                         materials = IntegersOf(mesh, "BinMaterials"),
                         numbers = IntegersOf(mesh, "BinNumbers");
  if (!FindArray(mesh.ElementArrays, BinIdName) || ids.empty())
  {
    return {};
  }
  std::vector<std::vector<double>> reals;
  for (const char* name : { "BinLower", "BinUpper", "BinMean", "BinVolume", "BinElements" })
  {
    reals.push_back(NumbersOfField(mesh.Fields, name));
  }
  const std::vector<double> density = NumbersOfField(mesh.Fields, "BinDensity"),
                            modulus = NumbersOfField(mesh.Fields, "BinModulus"),
                            poisson = NumbersOfField(mesh.Fields, "BinPoisson");
  const std::size_t count = ids.size();
  const bool hasLaw = !modulus.empty();
  const auto fits = [count](const auto& column) { return column.size() == count; };
  if (!texts || !fits(*texts) || !fits(materials) || !fits(numbers) ||
    !std::all_of(reals.begin(), reals.end(), fits) ||
    (hasLaw && (!fits(density) || !fits(modulus) || !fits(poisson))))
  {
    throw InputError("The columns of the table of bins (BinIds, BinNames, ..) are not complete.");
  }
  std::vector<MaterialBin> bins;
  for (std::size_t b = 0; b < count; ++b)
  {
    bins.push_back({ ids[b], materials[b], numbers[b], PrintableName((*texts)[b]), reals[0][b],
      reals[1][b], reals[2][b], reals[3][b], static_cast<Index>(reals[4][b]) });
    if (hasLaw)
    {
      bins.back().Elastic = ElasticConstants{ density[b], modulus[b], poisson[b] };
    }
  }
  return bins;
}

int FindLastBinId(const MeshData& mesh)
{
  const std::vector<int> ids = IntegersOf(mesh, "BinIds");
  return ids.empty() ? 0 : *std::max_element(ids.begin(), ids.end());
}

void ReplaceBins(const std::vector<FieldArray>& columns, std::vector<FieldArray>& fields)
{
  const auto isColumn = [](const FieldArray& field)
  { return std::find(std::begin(Columns), std::end(Columns), field.Name) != std::end(Columns); };
  fields.erase(std::remove_if(fields.begin(), fields.end(), isColumn), fields.end());
  fields.insert(fields.end(), columns.begin(), columns.end());
}

} // namespace vfm
