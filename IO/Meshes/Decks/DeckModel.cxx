#include "Meshes/Decks/DeckModel.h"

#include "Meshes/Files/WriteWhole.h"
#include "Meshes/Particles/GatherParticles.h"
#include "Ranks/Errors.h"
#include "Report/DomainSides.h"
#include "Report/FlatData.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace vfm
{
namespace
{

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

/// Returns the mesh with nodes at the particles. If only particles have velocities, it gets an
/// array of them.
StoredMesh AddNodes(MeshData mesh)
{
  const Index count = mesh.Particles ? mesh.Particles->NumberOfParticles : 0;
  if (count == 0)
  {
    return { mesh, {} };
  }
  const MeshArray* velocity = FindVelocity(mesh.Particles->Arrays);
  const std::vector<double> none(3 * static_cast<std::size_t>(mesh.NumberOfPoints), 0.0);
  if (velocity && !FindFirst(mesh.PointArrays, IsVelocity))
  {
    mesh.PointArrays.push_back({ velocity->Name, ValueType::Double, 3, {}, none.data() });
  }
  std::vector<Index> ids(static_cast<std::size_t>(count));
  const Index* ofMesh = mesh.PointIds;
  std::iota(ids.begin(), ids.end(), *std::max_element(ofMesh, ofMesh + mesh.NumberOfPoints) + 1);
  return AddParticleNodes(mesh, ids);
}

bool HasBins(const MaterialPart& whole, const std::vector<MaterialPart>& divided)
{
  return std::any_of(divided.begin(), divided.end(),
    [&whole](const MaterialPart& part) { return part.Bin && part.Material == whole.Material; });
}

/// @param mesh  whole mesh, from which sets and connections are made: particles are in none
/// @param extended  the same with nodes of particles
DeckModel MakeModel(const MeshData& mesh, const MeshData& extended)
{
  Ranks alone;
  const std::vector<MeshArray>& arrays = mesh.ElementArrays;
  MeshModel parts = MakeMeshModel(mesh, alone);
  std::vector<ParticlePart> particles = FindParticleParts(mesh, parts.Cohesive, alone);
  std::vector<MaterialPart> undivided =
    std::exchange(parts.Materials, DivideByBins(parts.Materials, mesh, alone));
  undivided.erase(std::remove_if(undivided.begin(), undivided.end(),
                    [&parts](const MaterialPart& part) { return !HasBins(part, parts.Materials); }),
    undivided.end());
  const bool hasVelocity = FindFirst(mesh.PointArrays, IsVelocity) != nullptr;
  return { std::move(parts), extended,
    { FindFirst(extended.PointArrays, IsVelocity), hasVelocity ? 0 : mesh.NumberOfPoints,
      FindFirst(arrays, IsDensity), FindFirst(arrays, IsEnergy), FindFirst(arrays, IsStress),
      FindFirst(arrays, IsPlasticStrain) },
    ConnectionOf(mesh), FindSplitFaces(mesh, alone), std::move(particles), std::move(undivided) };
}

} // namespace

std::vector<Index> DeckModel::PointsOf(const ParticlePart& part) const
{
  std::vector<Index> points;
  std::transform(part.Particles.begin(), part.Particles.end(), std::back_inserter(points),
    [this](Index particle) { return this->NodeOf(particle) - 1; });
  return points;
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
    std::to_string(model.Mesh.NumberOfElements) + " " + ShapeOf(model.Mesh).Plural +
    (model.Particles.empty()
        ? ""
        : ", " + std::to_string(model.Mesh.Particles->NumberOfParticles) + " particles");
}

void RequireNumbers(const DeckModel& model, Index largest, const char* format, const char* others)
{
  const Index elements = model.Mesh.NumberOfElements + CountElements(model.Cohesive) +
    (model.Particles.empty() ? 0 : model.Mesh.Particles->NumberOfParticles);
  if (std::max(model.Mesh.NumberOfPoints, elements) > largest)
  {
    throw InputError("The mesh has more than " + std::to_string(largest) +
      " nodes or elements, which " + format + " cannot number. Formats that can: " + others + ".");
  }
}

void RequirePlaneOfXY(const DeckModel& model, const char* format)
{
  if (IsFlat(model.Mesh) && NumberOfAxes(model.Mesh) != 2)
  {
    throw InputError(std::string(format) +
      " has elements of the plane of x and y only: write a layer of cells across z. Formats that "
      "have others: .e, .vtu, .bdf, .rad, .xdmf.");
  }
}

void RequireIds(const DeckModel& model, int largest, const char* format, const char* others)
{
  std::vector<int> ids;
  for (const MaterialPart& section : model.Materials)
  {
    ids.push_back(section.Id);
  }
  for (const ParticlePart& part : model.Particles)
  {
    ids.push_back(part.Id);
  }
  for (int id : ids)
  {
    if (id > largest)
    {
      throw InputError("The material id " + std::to_string(id) + " is greater than " +
        std::to_string(largest) + ", the limit of " + format +
        ". Formats that can hold it: " + others + ".");
    }
  }
}

void WriteDeck(const MeshData& mesh, Ranks& ranks, bool (*isTaken)(const MeshArray&),
  const std::function<void(const DeckModel&)>& write)
{
  WriteWhole(
    mesh, ranks, [&](const MeshData& whole) { write(MakeModel(whole, AddNodes(whole).Data)); },
    [isTaken](const MeshArray& array) { return isTaken(array) || IsBinArray(array); });
}

} // namespace vfm
