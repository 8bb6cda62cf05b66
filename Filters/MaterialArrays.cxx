#include "MaterialArrays.h"

#include "BlockArraysOfData.h"
#include "CollectBlocks.h"
#include "Input/ValueType.h"
#include "Materials/ChooseMaterials.h"
#include "Ranks/Agreement.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace vfm
{
namespace
{

/// The arrays of cells or of points.
struct FoundArrays
{
  std::vector<ArrayInfo> Everywhere; // in all parts of the input
  std::vector<ArrayInfo> InSomeParts;
};

using ArraysOfPlaces = std::map<int, FoundArrays>; // by association

/// Collective. Returns the arrays by association; point arrays only of images.
ArraysOfPlaces FindArrays(vtkDataObject* input, Ranks& ranks)
{
  std::map<int, ArrayLists> lists{ { vtkDataObject::CELL, {} }, { vtkDataObject::POINT, {} } };
  std::map<int, std::vector<ArrayInfo>> arrays;
  std::vector<Index> parts{ 0 };
  WorkTogether(ranks,
    [&]
    {
      for (const InputPart& part : FindParts(input, ranks.Rank(), ranks.Count() == 1))
      {
        parts[0] += part.HasPoints();
        for (auto& [association, own] : lists)
        {
          if (association == vtkDataObject::CELL || vtkImageData::SafeDownCast(part.Data))
          {
            own.push_back(ArraysOf(part.Data, association));
          }
        }
      }
      for (const auto& [association, own] : lists)
      {
        arrays[association] = ListArrays(own);
      }
    });
  ranks.Sum(parts);
  ArraysOfPlaces found;
  for (const auto& [association, own] : arrays)
  {
    const std::vector<ArrayInfo> all = UnionOfArrays(own, ranks);
    FoundArrays& place = found[association];
    std::partition_copy(all.begin(), all.end(), std::back_inserter(place.Everywhere),
      std::back_inserter(place.InSomeParts),
      [&parts](const ArrayInfo& array) { return array.Count == parts[0]; });
  }
  return found;
}

/// Returns the choice of one association.
MaterialChoice Choose(int association, const std::vector<ArrayInfo>& arrays, bool hasThreshold)
{
  ChoiceRules rules;
  rules.HasThreshold = hasThreshold;
  rules.ArePoints = association == vtkDataObject::POINT;
  return ChooseMaterials(arrays, rules);
}

/// Returns a sentence for each array that some parts lack and that can hold a material, which a
/// choice of other arrays would lose.
std::string DescribeLost(const std::vector<ArrayInfo>& arrays)
{
  std::string text;
  const std::vector<ContentOfArray> contents = FindContents(arrays, {});
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    text += CanBeMaterial(contents[a].Content)
      ? " '" + arrays[a].Name + "' is missing in some blocks."
      : "";
  }
  return text;
}

/// Collective. Returns the arrays of materials if the choice is clear.
/// @param hasThreshold  materials are ranges of the values of one array
MaterialArrays FindClearArrays(vtkDataObject* input, bool hasThreshold, Ranks& ranks)
{
  MaterialArrays found;
  found.AreGuessed = true;
  int choices = 0;
  bool isClear = true;
  std::string problem;
  for (const auto& [association, arrays] : FindArrays(input, ranks))
  {
    const MaterialChoice choice = Choose(association, arrays.Everywhere, hasThreshold);
    const std::string lost = DescribeLost(arrays.InSomeParts);
    const bool isFound = !choice.Fractions.empty() || !choice.Labels.empty();
    isClear = isClear && lost.empty() && (!isFound || choice.IsClear);
    choices += isFound;
    problem += choice.Problem.empty() || arrays.Everywhere.empty() ? "" : " " + choice.Problem;
    problem += lost;
    for (const std::string& name : choice.Fractions)
    {
      found.Fractions.push_back({ name, association });
    }
    if (!choice.Labels.empty())
    {
      found.Labels = { choice.Labels, association };
    }
  }
  if (choices != 1 || !isClear)
  {
    throw InputError("No array is chosen. Tick Volume Fraction Arrays, one per material, or choose "
                     "a Material Id Array (labels)." +
      problem);
  }
  return found;
}

/// Collective. Decides the role of an array that is selected for both: the role that a panel does
/// not select by default.
MaterialArrays KeepOneRole(vtkDataObject* input, MaterialArrays chosen, Ranks& ranks)
{
  const std::string& name = chosen.Labels.Name;
  bool areFractions = false;
  for (const auto& [association, found] : FindArrays(input, ranks))
  {
    const std::vector<ArrayInfo>& arrays = found.Everywhere;
    const std::vector<ContentOfArray> contents = FindContents(arrays, {});
    for (std::size_t a = 0; a < arrays.size(); ++a)
    {
      areFractions = areFractions ||
        (arrays[a].Name == name && contents[a].Content == ArrayContent::Fraction) ||
        (arrays[a].Name == name && IsRealType(arrays[a].Type));
    }
  }
  return areFractions ? MaterialArrays{ {}, chosen.Labels, false }
                      : MaterialArrays{ chosen.Fractions, {}, false };
}

} // namespace

MaterialArrays FindMaterialArrays(
  vtkDataObject* input, MaterialArrays chosen, bool hasThreshold, Ranks& ranks)
{
  if (chosen.Fractions.empty() && !chosen.HasLabels())
  {
    return FindClearArrays(input, hasThreshold, ranks);
  }
  if (hasThreshold && !chosen.HasLabels() && chosen.Fractions.size() == 1)
  {
    return { {}, chosen.Fractions[0], false };
  }
  if (chosen.HasLabels() && chosen.Fractions.size() == 1 &&
    chosen.Fractions[0].Name == chosen.Labels.Name)
  {
    return KeepOneRole(input, std::move(chosen), ranks);
  }
  if (chosen.HasLabels() && !chosen.Fractions.empty())
  {
    throw InputError("Both Volume Fraction Arrays and the Material Id Array '" +
      chosen.Labels.Name + "' are chosen. Choose one or the other.");
  }
  return chosen;
}

} // namespace vfm
