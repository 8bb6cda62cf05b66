#include "InputAssociation.h"

#include "Agreement.h"
#include "CollectBlocks.h"
#include "MaterialGuess.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"

namespace vfm
{
namespace
{

constexpr int Associations[2] = { vtkDataObject::POINT, vtkDataObject::CELL };

/// Throws when an array can never be read.
void CheckChoice(const ChosenArray& array)
{
  if (IsGhostName(array.Name))
  {
    throw InputError("'" + array.Name +
      "' only marks which cells are copies or blanked, and is heeded without being chosen. Choose "
      "other arrays.");
  }
  if (array.Association != AnyAssociation && array.Association != vtkDataObject::CELL &&
    array.Association != vtkDataObject::POINT)
  {
    throw InputError("'" + array.Name + "' is chosen as data of neither cells nor points.");
  }
}

/// Where an array is found.
struct ArrayPlaces
{
  bool InAll[2], InSome[2]; ///< of the parts, by association
};

/// Collective. Of an association that is not admitted nothing.
ArrayPlaces FindPlaces(const std::vector<InputPart>& parts, const ChosenArray& array, Ranks& ranks)
{
  CheckChoice(array);
  std::vector<Index> counts(3, 0); // parts with it, by association, and all
  for (const InputPart& part : parts)
  {
    for (int association : Associations)
    {
      vtkDataSetAttributes* attributes = part.Data->GetAttributes(association);
      counts[association] +=
        part.HasPoints() && attributes && attributes->HasArray(array.Name.c_str());
    }
    counts[2] += part.HasPoints();
  }
  ranks.Sum(counts);
  ArrayPlaces places{};
  for (int association : Associations)
  {
    const bool isAdmitted = array.Association == AnyAssociation || array.Association == association;
    places.InAll[association] = isAdmitted && counts[association] == counts[2];
    places.InSome[association] = isAdmitted && counts[association] > 0;
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

[[noreturn]] void RefuseMixture(const ChosenArray& array, int association, const ChosenArray& other)
{
  throw InputError("'" + array.Name + "' is " + NameOf(association) + ", and '" + other.Name +
    "' is " + NameOf(OtherThan(association)) +
    ". The arrays that are chosen must be of one kind. ParaView's filters Point Data to Cell Data "
    "and Cell Data to Point Data change the kind; they average, which does not serve labels.");
}

/// Throws when an array belongs to cells in some parts, and in the others to points.
void CheckAllParts(const ChosenArray& array, const ArrayPlaces& places)
{
  const int cell = vtkDataObject::CELL, point = vtkDataObject::POINT;
  if (places.InSome[cell] && places.InSome[point] && !places.InAll[cell] && !places.InAll[point])
  {
    throw InputError("'" + array.Name +
      "' is cell data in some blocks, and point data in others. It must be of one kind in all.");
  }
}

/// Throws when an array belongs only, or is said to belong, to what the arrays of the materials do not belong to.
void CheckKind(
  const ChosenArray& array, const ArrayPlaces& places, int association, const ChosenArray& material)
{
  const int other = OtherThan(association);
  if (array.Association == other || IsOnly(places, other))
  {
    RefuseMixture(array, other, material);
  }
}

} // namespace

int FindAssociation(const std::vector<InputPart>& parts, const std::vector<ChosenArray>& materials,
  const std::vector<ChosenArray>& others, Ranks& ranks)
{
  bool fits[2] = { true, true };
  const bool isSaid = materials.front().Association != AnyAssociation;
  const ChosenArray* known = isSaid ? &materials.front() : nullptr;
  int found = isSaid ? known->Association : vtkDataObject::CELL; // where none fits: for messages
  std::vector<ArrayPlaces> places;
  for (const ChosenArray& array : materials)
  {
    places.push_back(FindPlaces(parts, array, ranks));
    CheckAllParts(array, places.back());
    for (int association : Associations)
    {
      fits[association] = fits[association] && places.back().InAll[association];
      if (!known && IsOnly(places.back(), association))
      {
        known = &array;
        found = association;
      }
    }
  }
  if (fits[vtkDataObject::CELL] || fits[vtkDataObject::POINT])
  {
    found = fits[vtkDataObject::CELL] ? vtkDataObject::CELL : vtkDataObject::POINT;
  }
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    CheckKind(materials[m], places[m], found, known ? *known : materials.front());
  }
  for (const ChosenArray& array : others)
  {
    CheckKind(array, FindPlaces(parts, array, ranks), found, materials.front());
  }
  return found;
}

} // namespace vfm
