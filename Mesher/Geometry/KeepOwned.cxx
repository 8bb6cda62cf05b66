#include "Geometry/KeepOwned.h"

#include "Base/Groups.h"
#include "Elements/FacetSides.h"
#include "Elements/SelectPoints.h"

namespace vfm
{
namespace
{

constexpr Index ItemsOfBlock = 4096; // per task

/// Returns the numbers i < count for which isKept(i) is true.
template <class IsKept>
std::vector<Index> ListKept(Runtime& runtime, std::size_t count, const IsKept& isKept)
{
  return CollectItems<Index>(runtime, count, ItemsOfBlock,
    [&](Index i, std::vector<Index>& kept)
    {
      if (isKept(i))
      {
        kept.push_back(i);
      }
    });
}

/// Removes the points without elements.
void SelectPointsOfElements(Runtime& runtime, Mesh& mesh)
{
  std::vector<Index> numbers(mesh.PointIds.size(), -1);
  ForEach(runtime, mesh.Elements.size(),
    [&](Index i) { __atomic_store_n(&numbers[mesh.Elements[i]], 0, __ATOMIC_RELAXED); });
  const std::vector<Index> points =
    ListKept(runtime, numbers.size(), [&](Index point) { return numbers[point] == 0; });
  ForEach(runtime, points.size(), [&](Index p) { numbers[points[p]] = p; });
  SelectPoints(points, numbers, runtime, mesh);
}

} // namespace

void KeepOwned(const CartesianGrid& grid, const BarrierElements& barrier, Runtime& runtime,
  Index& wholeCells, Mesh& mesh)
{
  if (grid.HexBox() == grid.Owned() && !barrier.Exist)
  {
    mesh.Facets = FindElements(ListFacetSides(mesh, runtime), mesh, runtime);
    return;
  }
  const std::vector<Index> elements = ListKept(runtime, mesh.ElementIds.size(),
    [&](Index e)
    {
      return !barrier.Contain(mesh, e) &&
        grid.Owned().Contains(CellOfElement(grid, mesh, mesh.ElementIds[e]));
    });
  wholeCells = std::lower_bound(elements.begin(), elements.end(), wholeCells) - elements.begin();
  KeepItems(elements, mesh.Corners, mesh.Elements);
  KeepItems(elements, 1, mesh.ElementIds);
  KeepItems(elements, 1, mesh.Material);
  KeepItems(elements, 1, mesh.Fragment);
  SelectPointsOfElements(runtime, mesh);

  SurfaceFacets& surfaces = mesh.Surfaces;
  mesh.Facets = FindElements(ListFacetSides(mesh, runtime), mesh, runtime);
  const std::vector<Index> facets =
    ListKept(runtime, surfaces.IsOwned.size(), [&](Index q) { return surfaces.IsOwned[q] != 0; });
  KeepItems(facets, mesh.CornersOfFacet(), surfaces.Points);
  KeepItems(facets, 1, surfaces.SurfaceId);
  KeepItems(facets, 2, surfaces.MaterialPair);
  KeepItems(facets, 1, surfaces.DomainSide);
  surfaces.IsOwned.assign(facets.size(), 1);
}

} // namespace vfm
