#include "Geometry/DivideInterfaces.h"

#include "Geometry/SmoothSides.h"
#include "GivenSurfaces/BodySurfaces.h"

namespace vfm
{

DividedFacets DivideInterfaces(const std::vector<Facet>& facets,
  const std::vector<FeatureKind>& kinds, const Mesh& mesh, const BodySurfaces* surfaces,
  const Partition& partition, Runtime& runtime)
{
  if (!surfaces)
  {
    return { FindSmoothSides(facets, kinds, mesh, partition) };
  }
  DividedFacets divided = FindGivenSides(facets, mesh, *surfaces, partition, runtime);
  const auto isOther = [surfaces](const Facet& facet)
  {
    return facet.DomainSide < 0 &&
      surfaces->FindOfInterface(facet.Materials[0], facet.Materials[1]) < 0;
  };
  if (partition.Group().Any(std::any_of(facets.begin(), facets.end(), isOther)))
  {
    const std::vector<int> smooth = FindSmoothSides(facets, kinds, mesh, partition);
    const int given = static_cast<int>(divided.Names.size()) - 1;
    for (std::size_t f = 0; f < facets.size(); ++f)
    {
      if (smooth[f] > 0 && isOther(facets[f]))
      {
        divided.SideOf[f] = given + smooth[f];
      }
    }
  }
  return divided;
}

} // namespace vfm
