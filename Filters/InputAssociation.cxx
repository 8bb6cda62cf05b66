#include "InputAssociation.h"

#include "CollectBlocks.h"
#include "Input/ArrayNames.h"
#include "Ranks/Agreement.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"

#include <algorithm>

namespace vfm
{
namespace
{

constexpr int Associations[2] = { vtkDataObject::POINT, vtkDataObject::CELL }; // 0 and 1

/// Throws InputError if an array can never be read.
void CheckChoice(const ChosenArray& array)
{
  if (IsGhostName(array.Name))
  {
    throw InputError("'" + array.Name +
      "' only marks ghost cells and blanked cells, and is always used for that. Choose other "
      "arrays.");
  }
  if (array.Association != AnyAssociation && array.Association != vtkDataObject::CELL &&
    array.Association != vtkDataObject::POINT)
  {
    throw InputError("'" + array.Name + "' is chosen as data of neither cells nor points.");
  }
}

/// Associations of an array in the parts of the input.
struct ArrayPlaces
{
  bool InAll[2], InSome[2]; ///< whether all or some parts have it, by association
};

/// Collective. Finds the places of each array with an allowed association.
std::vector<ArrayPlaces> FindPlaces(
  const std::vector<InputPart>& parts, const std::vector<ChosenArray>& arrays, Ranks& ranks)
{
  std::vector<Index> counts(2 * arrays.size() + 1, 0); // parts with each by association, and all
  for (const InputPart& part : parts)
  {
    for (std::size_t c = 0; part.HasPoints() && c + 1 < counts.size(); ++c)
    {
      vtkDataSetAttributes* attributes = part.Data->GetAttributes(static_cast<int>(c % 2));
      counts[c] += attributes && attributes->HasArray(arrays[c / 2].Name.c_str());
    }
    counts.back() += part.HasPoints();
  }
  ranks.Sum(counts);
  std::vector<ArrayPlaces> places(arrays.size());
  for (std::size_t c = 0; c + 1 < counts.size(); ++c)
  {
    const int association = static_cast<int>(c % 2), said = arrays[c / 2].Association;
    const bool isAdmitted = said == AnyAssociation || said == association;
    places[c / 2].InAll[association] = isAdmitted && counts[c] == counts.back();
    places[c / 2].InSome[association] = isAdmitted && counts[c] > 0;
  }
  return places;
}

int OtherThan(int association)
{
  return association == vtkDataObject::CELL ? vtkDataObject::POINT : vtkDataObject::CELL;
}

bool IsOnly(const ArrayPlaces& places, int association)
{
  return places.InSome[association] && !places.InSome[OtherThan(association)];
}

const char* NameOf(int association)
{
  return association == vtkDataObject::CELL ? "cell data" : "point data";
}

[[noreturn]] void RejectMixture(const ChosenArray& array, int association, const ChosenArray& other)
{
  throw InputError("'" + array.Name + "' is " + NameOf(association) + ", and '" + other.Name +
    "' is " + NameOf(OtherThan(association)) +
    ". The arrays that are chosen must be of one kind. ParaView's filters Point Data to Cell Data "
    "and Cell Data to Point Data change the kind; they average, which is not suitable for labels.");
}

/// Throws InputError if an array belongs to cells in some parts, and to points in others.
void CheckAllParts(const ChosenArray& array, const ArrayPlaces& places)
{
  const int cell = vtkDataObject::CELL, point = vtkDataObject::POINT;
  if (places.InSome[cell] && places.InSome[point] && !places.InAll[cell] && !places.InAll[point])
  {
    throw InputError("'" + array.Name +
      "' is cell data in some blocks, and point data in others. It must be of one kind in all.");
  }
}

/// Throws InputError if an array has only, or is selected with, the association that the arrays of
/// materials lack.
void CheckKind(
  const ChosenArray& array, const ArrayPlaces& places, int association, const ChosenArray& material)
{
  const int other = OtherThan(association);
  if (array.Association == other || IsOnly(places, other))
  {
    RejectMixture(array, other, material);
  }
}

} // namespace

int FindAssociation(const std::vector<InputPart>& parts, const ArraysToRead& toRead, Ranks& ranks)
{
  const std::vector<ChosenArray>& materials = toRead.Materials;
  std::vector<ChosenArray> arrays = materials;
  arrays.insert(arrays.end(), toRead.Others.begin(), toRead.Others.end());
  std::for_each(arrays.begin(), arrays.end(), CheckChoice);
  const std::vector<ArrayPlaces> places = FindPlaces(parts, arrays, ranks);
  bool fits[2] = { true, true };
  const bool isSaid = materials.front().Association != AnyAssociation;
  const ChosenArray* known = isSaid ? &materials.front() : nullptr;
  int found = isSaid ? known->Association : vtkDataObject::CELL; // used in messages if none fits
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    CheckAllParts(materials[m], places[m]);
    for (int association : Associations)
    {
      fits[association] = fits[association] && places[m].InAll[association];
      if (!known && IsOnly(places[m], association))
      {
        known = &materials[m];
        found = association;
      }
    }
  }
  if (fits[vtkDataObject::CELL] || fits[vtkDataObject::POINT])
  {
    found = fits[vtkDataObject::CELL] ? vtkDataObject::CELL : vtkDataObject::POINT;
  }
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    CheckKind(arrays[a], places[a], found, known ? *known : materials.front());
  }
  return found;
}

} // namespace vfm
