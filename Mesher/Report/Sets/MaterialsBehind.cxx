#include "Report/Sets/MaterialsBehind.h"

#include "Report/DomainSides.h"
#include "Report/MatchFaces.h"
#include "Report/Sets/MeshSets.h"

namespace vfm
{

std::vector<Index> FindMaterialsBehind(const MeshData& mesh, Ranks& ranks)
{
  std::vector<Index> behind, materials;
  std::vector<std::size_t> open;
  std::vector<FaceIds> ids;
  for (const MeshFacet& facet : *mesh.Facets)
  {
    if (mesh.PeriodicPartner && facet.DomainSide != NoSide)
    {
      open.push_back(behind.size());
      materials.push_back(mesh.Material[facet.Element]);
      ids.push_back(SortedIds(PointsOfSide(mesh, facet), mesh.PeriodicPartner));
    }
    behind.push_back(facet.Behind);
  }
  if (ranks.Any(mesh.PeriodicPartner != nullptr))
  {
    const std::vector<Index> across = MatchFaces(ids, materials, ranks);
    for (std::size_t f = 0; f < open.size(); ++f)
    {
      behind[open[f]] = across[f];
    }
  }
  return behind;
}

} // namespace vfm
