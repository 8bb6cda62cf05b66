#include "ChosenState.h"

#include "CollectBlocks.h"
#include "FindArrays.h"
#include "Ranks/Agreement.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkSmartPointer.h"

namespace vfm
{
namespace
{

/// Collective: what the input has of velocity and energy, of cells or points.
std::vector<StateCandidate> FindCandidates(
  vtkDataObject* input, const StateChoice& choice, Ranks& ranks)
{
  std::vector<vtkSmartPointer<vtkDataSetAttributes>> kept;
  std::vector<vtkDataSetAttributes*> attributes;
  const auto keep = [&](vtkDataSetAttributes* all)
  {
    kept.push_back(vtkSmartPointer<vtkDataSetAttributes>::New());
    attributes.push_back(kept.back());
    for (int a = 0; all && a < all->GetNumberOfArrays(); ++a)
    {
      const char* name = all->GetArrayName(a);
      if (name && IsCandidate(name, choice))
      {
        kept.back()->AddArray(all->GetAbstractArray(a));
      }
    }
  };
  WorkTogether(ranks,
    [&]
    {
      for (const InputPart& part : FindParts(input, ranks.Rank(), ranks.Count() == 1))
      {
        keep(part.Data->GetAttributes(vtkDataObject::CELL));
        keep(part.Data->GetAttributes(vtkDataObject::POINT));
      }
    });
  std::vector<StateCandidate> candidates;
  for (const ArrayInfo& array : FindArrays(attributes, ranks))
  {
    candidates.push_back({ array.Name, array.Components });
  }
  return candidates;
}

} // namespace

StateChoice FindChosenState(vtkDataObject* input, StateChoice choice, Ranks& ranks)
{
  const bool isAsked = !choice.Velocity.empty() || !choice.Energy.empty();
  return CompleteChoice(
    choice, isAsked ? FindCandidates(input, choice, ranks) : std::vector<StateCandidate>());
}

} // namespace vfm
