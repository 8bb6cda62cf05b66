#include "Meshes/Files/MeshModel.h"

#include "Base/ParseText.h"
#include "Ranks/Agreement.h"
#include "Report/MeshMaterials.h"

#include <algorithm>
#include <numeric>

namespace vfm
{
namespace
{

/// Divides the elements of a material among its bins.
/// @param divided  the bins, without elements, ascending by id, then the elements in none
void DivideElements(
  const MaterialPart& whole, const MeshArray& ids, std::vector<MaterialPart>& divided)
{
  const auto last = divided.end() - 1;
  for (Index element : whole.Elements)
  {
    const int id = static_cast<int>(ValueAt(ids, element));
    const auto found = id == 0 ? last
                               : std::lower_bound(divided.begin(), last, id,
                                   [](const MaterialPart& part, int one) { return part.Id < one; });
    if (id != 0 && (found == last || found->Id != id))
    {
      throw InputError("An element of " + whole.Name + " has the " + BinIdName + " " +
        std::to_string(id) + ", which is not in the field BinIds of this material.");
    }
    found->Elements.push_back(element);
  }
}

} // namespace

bool HasWord(const MeshArray& array, const char* word)
{
  return ToLower(array.Name).find(word) != std::string::npos;
}

bool IsVelocity(const MeshArray& array)
{
  return HasWord(array, "velocity") && array.Components == 3;
}

Index CountElements(const std::vector<CohesiveBlock>& blocks)
{
  return std::accumulate(blocks.begin(), blocks.end(), Index(0),
    [](Index sum, const CohesiveBlock& block)
    { return sum + static_cast<Index>(block.Ids.size()); });
}

std::vector<MaterialPart> FindMaterialParts(const MeshData& mesh, Ranks& ranks)
{
  const std::map<int, std::string> names = NamesOfMaterials(mesh);
  std::vector<MaterialPart> parts;
  for (int material : FindMaterials(mesh, ranks))
  {
    const int id = material == 0 ? FindVoidId(mesh, ranks) : material;
    parts.push_back({ material, id, NameOfMaterial(names, material), {} });
  }
  auto part = parts.begin(); // consecutive elements mostly have one material
  for (Index element = 0; element < mesh.NumberOfElements; ++element)
  {
    const int material = mesh.Material[element];
    if (part->Material != material)
    {
      part = std::lower_bound(parts.begin(), parts.end(), material,
        [](const MaterialPart& one, int other) { return one.Material < other; });
    }
    part->Elements.push_back(element);
  }
  return parts;
}

bool IsBinArray(const MeshArray& array)
{
  return array.Name == BinIdName && array.Components == 1;
}

std::vector<MaterialPart> DivideByBins(
  const std::vector<MaterialPart>& parts, const MeshData& mesh, Ranks& ranks)
{
  std::vector<MaterialPart> all;
  WorkTogether(ranks,
    [&]
    {
      std::vector<MaterialBin> bins = ReadBins(mesh);
      std::sort(bins.begin(), bins.end(),
        [](const MaterialBin& a, const MaterialBin& b) { return a.Id < b.Id; });
      for (const MaterialPart& part : parts)
      {
        std::vector<MaterialPart> divided;
        for (const MaterialBin& bin : bins)
        {
          if (bin.Material == part.Material)
          {
            divided.push_back({ part.Material, bin.Id, bin.Name, {}, bin });
          }
        }
        if (divided.empty())
        {
          all.push_back(part);
          continue;
        }
        divided.push_back({ part.Material, part.Id, part.Name, {} });
        DivideElements(part, GetArray(mesh.ElementArrays, BinIdName), divided);
        if (SumOverRanks(static_cast<Index>(divided.back().Elements.size()), ranks) == 0)
        {
          divided.pop_back();
        }
        std::move(divided.begin(), divided.end(), std::back_inserter(all));
      }
    });
  return all;
}

MeshModel MakeMeshModel(const MeshData& mesh, Ranks& ranks)
{
  return { FindMeshSets(mesh, ranks), FindCohesiveBlocks(mesh, ranks),
    FindMaterialParts(mesh, ranks) };
}

std::map<int, std::string> NameMaterials(const MeshData& mesh, const std::vector<int>& materials,
  std::string (*form)(const std::string&), UniqueNames& used)
{
  const std::map<int, std::string> names = NamesOfMaterials(mesh);
  std::map<int, std::string> unique;
  for (int material : materials)
  {
    unique[material] = used.Add(form(NameOfMaterial(names, material)));
  }
  return unique;
}

} // namespace vfm
