#include "Meshes/Files/MeshModel.h"

#include "Base/ParseText.h"
#include "Report/MeshMaterials.h"

#include <algorithm>
#include <numeric>

namespace vfm
{

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
