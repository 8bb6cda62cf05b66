#include "Meshes/Decks/DeckModel.h"

#include "Base/ParseText.h"
#include "Meshes/Files/WriteWhole.h"
#include "Ranks/Errors.h"

#include <algorithm>

namespace vfm
{
namespace
{

/// Returns whether the name of an array contains a word, in any case.
bool HasWord(const MeshArray& array, const char* word)
{
  return ToLower(array.Name).find(word) != std::string::npos;
}

bool IsDensity(const MeshArray& array)
{
  return HasWord(array, "density") && array.Components == 1;
}

bool IsEnergy(const MeshArray& array)
{
  return HasWord(array, "energy") && array.Components == 1;
}

bool IsStress(const MeshArray& array)
{
  return HasWord(array, "stress") && (array.Components == 6 || array.Components == 9);
}

bool IsPlasticStrain(const MeshArray& array)
{
  return HasWord(array, "plastic") && array.Components == 1;
}

const MeshArray* FindFirst(const std::vector<MeshArray>& arrays, bool (*fits)(const MeshArray&))
{
  const auto found = std::find_if(arrays.begin(), arrays.end(), fits);
  return found == arrays.end() ? nullptr : &*found;
}

DeckModel MakeModel(const MeshData& mesh)
{
  Ranks alone;
  const std::vector<MeshArray>& arrays = mesh.ElementArrays;
  return { MakeMeshModel(mesh, alone), mesh,
    { FindFirst(mesh.PointArrays, IsVelocity), FindFirst(arrays, IsDensity),
      FindFirst(arrays, IsEnergy), FindFirst(arrays, IsStress),
      FindFirst(arrays, IsPlasticStrain) },
    ConnectionOf(mesh), FindSplitFaces(mesh, alone) };
}

} // namespace

bool IsVelocity(const MeshArray& array)
{
  return HasWord(array, "velocity") && array.Components == 3;
}

bool IsState(const MeshArray& array)
{
  return IsVelocity(array) || IsDensity(array) || IsEnergy(array) || IsStress(array) ||
    IsPlasticStrain(array);
}

std::array<double, 6> StressOf(const MeshArray& stress, Index element)
{
  constexpr int ofSix[6] = { 0, 1, 2, 3, 4, 5 }, ofNine[6] = { 0, 4, 8, 1, 5, 2 };
  const int* components = stress.Components == 6 ? ofSix : ofNine;
  std::array<double, 6> values;
  std::transform(components, components + 6, values.begin(),
    [&](int component) { return ValueAt(stress, element, component); });
  return values;
}

std::string PlainTitle(std::string text, std::size_t longest)
{
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '_');
  const std::size_t first = text.find_first_not_of(' ');
  if (first != std::string::npos && std::string_view("*$#/").find(text[first]) != text.npos)
  {
    text[first] = '_';
  }
  return text.substr(0, longest);
}

std::string DescribeDeck(const DeckModel& model)
{
  return "Mesh by VolumeFractionMesh " VFM_VERSION ": " +
    std::to_string(model.Mesh.NumberOfPoints) + " nodes, " +
    std::to_string(model.Mesh.NumberOfElements) + " " + model.Mesh.Shape().Plural;
}

void RequireNumbers(const DeckModel& model, Index largest, const char* format, const char* others)
{
  const Index elements = model.Mesh.NumberOfElements + CountElements(model.Cohesive);
  if (std::max(model.Mesh.NumberOfPoints, elements) > largest)
  {
    throw InputError("The mesh has more than " + std::to_string(largest) +
      " nodes or elements, which " + format + " cannot number. Formats that can: " + others + ".");
  }
}

void RequireIds(const DeckModel& model, int largest, const char* format, const char* others)
{
  for (const MaterialPart& section : model.Materials)
  {
    if (section.Id > largest)
    {
      throw InputError("The material id " + std::to_string(section.Id) + " is greater than " +
        std::to_string(largest) + ", the limit of " + format +
        ". Formats that can hold it: " + others + ".");
    }
  }
}

void WriteDeck(const MeshData& mesh, Ranks& ranks, bool (*isTaken)(const MeshArray&),
  const std::function<void(const DeckModel&)>& write)
{
  WriteWhole(
    mesh, ranks, [&](const MeshData& whole) { write(MakeModel(whole)); }, isTaken);
}

} // namespace vfm
