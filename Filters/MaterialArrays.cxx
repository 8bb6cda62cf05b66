#include "MaterialArrays.h"

#include "BlockArraysOfData.h"
#include "CollectBlocks.h"
#include "Input/ValueType.h"
#include "Materials/ChooseMaterials.h"
#include "Ranks/Agreement.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"

#include <algorithm>
#include <map>

namespace vfm
{
namespace
{

using ArraysOfPlaces = std::map<int, std::vector<ArrayInfo>>; // by association

/// Collective. Returns the arrays by association; point arrays only of images. Arrays that some
/// parts lack are left out.
ArraysOfPlaces FindArrays(vtkDataObject* input, Ranks& ranks)
{
  std::map<int, ArrayLists> lists{ { vtkDataObject::CELL, {} }, { vtkDataObject::POINT, {} } };
  ArraysOfPlaces arrays;
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
  for (auto& [association, own] : arrays)
  {
    own = UnionOfArrays(own, ranks);
    own.erase(std::remove_if(own.begin(), own.end(),
                [&parts](const ArrayInfo& array) { return array.Count != parts[0]; }),
      own.end());
  }
  return arrays;
}

/// Returns the choice of one association.
MaterialChoice Choose(int association, const std::vector<ArrayInfo>& arrays, bool hasThreshold)
{
  ChoiceRules rules;
  rules.HasThreshold = hasThreshold;
  rules.ArePoints = association == vtkDataObject::POINT;
  return ChooseMaterials(arrays, rules);
}

/// Collective. Returns the arrays of materials if the choice is clear.
/// @param hasThreshold  materials are ranges of the values of one array
MaterialArrays FindClearArrays(vtkDataObject* input, bool hasThreshold, Ranks& ranks)
{
  MaterialArrays found;
  found.AreGuessed = true;
  int choices = 0;
  std::string problem;
  for (const auto& [association, arrays] : FindArrays(input, ranks))
  {
    const MaterialChoice choice = Choose(association, arrays, hasThreshold);
    const bool isFound = !choice.Fractions.empty() || !choice.Labels.empty();
    choices += isFound ? 1 + !choice.IsClear : 0;
    problem += choice.Problem.empty() || arrays.empty() ? "" : " " + choice.Problem;
    for (const std::string& name : choice.Fractions)
    {
      found.Fractions.push_back({ name, association });
    }
    if (!choice.Labels.empty())
    {
      found.Labels = { choice.Labels, association };
    }
  }
  if (choices != 1)
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
  for (const auto& [association, arrays] : FindArrays(input, ranks))
  {
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
