#include "MaterialArrays.h"

#include "BlockArraysOfData.h"
#include "CollectBlocks.h"
#include "Input/ArrayInfo.h"
#include "Input/MaterialGuess.h"
#include "Input/ValueType.h"
#include "Ranks/Agreement.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"

#include <algorithm>
#include <map>

namespace vfm
{
namespace
{

/// An array that may hold materials.
struct Candidate
{
  ChosenArray Array;
  int Type; // VTK_VOID: several types
  MaterialGuess Guess;
};

/// Collective. Returns the arrays with one value per cell, except ids and ghost marks; point arrays
/// only of images.
std::vector<Candidate> FindCandidates(vtkDataObject* input, Ranks& ranks)
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
  std::vector<Candidate> found;
  for (const auto& [association, own] : arrays)
  {
    for (const ArrayInfo& array : UnionOfArrays(own, ranks))
    {
      if (array.Components != 1 || array.HoldsIds || !IsOffered(array.Name))
      {
        continue;
      }
      const int type = array.HasOneType ? array.Type : VTK_VOID;
      const MaterialGuess guess = GuessMaterial(type, array.Least, array.Most);
      const bool isClear = array.Count == parts[0] || guess == MaterialGuess::Nothing;
      found.push_back(
        { { array.Name, association }, type, isClear ? guess : MaterialGuess::Unclear });
    }
  }
  return found;
}

/// Collective. Returns the only array that can hold materials.
MaterialArrays FindSingleArray(vtkDataObject* input, Ranks& ranks)
{
  MaterialArrays found;
  int candidates = 0;
  for (const Candidate& candidate : FindCandidates(input, ranks))
  {
    candidates += candidate.Guess != MaterialGuess::Nothing;
    if (candidate.Guess == MaterialGuess::Fraction)
    {
      found.Fractions.push_back(candidate.Array);
    }
    else if (candidate.Guess == MaterialGuess::Labels)
    {
      found.Labels = candidate.Array;
    }
  }
  if (candidates != 1 || (found.Fractions.empty() && !found.HasLabels()))
  {
    throw InputError("No array is chosen. Tick Volume Fraction Arrays, one per material, or choose "
                     "a Material Id Array (labels).");
  }
  return found;
}

/// Collective. Decides the role of an array that is selected for both.
MaterialArrays KeepOneRole(vtkDataObject* input, MaterialArrays chosen, Ranks& ranks)
{
  const std::vector<Candidate> candidates = FindCandidates(input, ranks);
  const bool isReal = std::any_of(candidates.begin(), candidates.end(),
    [&chosen](const Candidate& candidate)
    { return candidate.Array.Name == chosen.Labels.Name && IsRealType(candidate.Type); });
  return isReal ? MaterialArrays{ {}, chosen.Labels } : MaterialArrays{ chosen.Fractions, {} };
}

} // namespace

MaterialArrays FindMaterialArrays(vtkDataObject* input, MaterialArrays chosen, Ranks& ranks)
{
  if (chosen.Fractions.empty() && !chosen.HasLabels())
  {
    return FindSingleArray(input, ranks);
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
