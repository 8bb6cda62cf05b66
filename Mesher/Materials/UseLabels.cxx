#include "Materials/UseLabels.h"

namespace vfm
{
namespace
{

/// Returns whether each label is equal to its material number.
bool AreNumbers(const std::vector<int>& labels)
{
  for (std::size_t m = 0; m < labels.size(); ++m)
  {
    if (labels[m] != static_cast<int>(m))
    {
      return false;
    }
  }
  return true;
}

template <class List>
void SetLabels(const std::vector<int>& labels, List& materials)
{
  for (int& material : materials)
  {
    material = labels[material];
  }
}

} // namespace

void UseLabels(const Materials& table, Mesh& mesh)
{
  if (AreNumbers(table.Labels))
  {
    return;
  }
  SetLabels(table.Labels, mesh.Material);
  SetLabels(table.Labels, mesh.Surfaces.MaterialPair);
  for (MeshFacet& facet : mesh.Facets)
  {
    facet.Behind = facet.Behind > 0 ? table.Labels[facet.Behind] : facet.Behind;
  }
  for (GeometryTables::Pair& materials : mesh.Tables.SurfaceMaterials)
  {
    SetLabels(table.Labels, materials);
  }
}

void UseLabels(const Materials& table, std::vector<int>& materials)
{
  SetLabels(table.Labels, materials);
}

} // namespace vfm
