#include "Report/MeshMaterials.h"

#include "Ranks/Agreement.h"
#include "Report/UniqueNames.h"

#include <limits>
#include <set>

namespace vfm
{

std::map<int, std::string> NamesOfMaterials(const MeshData& mesh)
{
  std::map<int, std::string> names{ { 0, "Void" } };
  const std::vector<double> ids = NumbersOfField(mesh.Fields, "MaterialIds");
  const FieldArray* field = FindField(mesh.Fields, "MaterialNames");
  const auto* texts = field ? std::get_if<std::vector<std::string>>(&field->Values) : nullptr;
  for (std::size_t m = 0; texts && m < std::min(ids.size(), texts->size()); ++m)
  {
    names[static_cast<int>(ids[m])] = PrintableName((*texts)[m]);
  }
  return names;
}

std::string NameOfMaterial(const std::map<int, std::string>& names, int material)
{
  const auto found = names.find(material);
  return found == names.end() ? "Material " + std::to_string(material) : found->second;
}

std::vector<int> FindMaterials(const MeshData& mesh, Ranks& ranks)
{
  std::set<int> mine;
  WorkTogether(ranks,
    [&]
    {
      const int* ids = Require(mesh.Material, "MaterialId", mesh);
      int last = -1; // consecutive elements mostly have one material
      for (Index element = 0; element < mesh.NumberOfElements; ++element)
      {
        if (ids[element] != last)
        {
          last = ids[element];
          mine.insert(last);
        }
      }
      if (!mine.empty() && *mine.begin() < 0)
      {
        throw InputError("MaterialId " + std::to_string(*mine.begin()) + " is negative.");
      }
    });
  return UnionOverRanks(ranks, std::vector<int>(mine.begin(), mine.end()));
}

int FindVoidId(const MeshData& mesh, Ranks& ranks)
{
  const std::vector<int> materials = FindMaterials(mesh, ranks);
  double largest = materials.empty() ? 0.0 : materials.back();
  for (double id : NumbersOfField(mesh.Fields, "MaterialIds"))
  {
    largest = std::max(largest, id);
  }
  largest = ranks.Max(largest);
  if (largest >= std::numeric_limits<int>::max())
  {
    throw InputError("No number is left for the void: a material has the largest possible id, " +
      std::to_string(std::numeric_limits<int>::max()) + ".");
  }
  return static_cast<int>(largest) + 1;
}

} // namespace vfm
