#include "Summary/NamedSurfaces.h"

#include "Summary/MeshFacets.h"
#include "Summary/MeshMaterials.h"
#include "Summary/UniqueNames.h"

#include <map>
#include <set>

namespace vfm
{
namespace
{

constexpr int FirstFreeId = 7; // ids 1 to 6 are the sides of the domain

SurfaceKind KindOf(const SideSet& set)
{
  return set.DomainSide != NoSide ? SurfaceKind::DomainSide
    : set.Surface > 0             ? SurfaceKind::SmoothSide
                                  : SurfaceKind::Interface;
}

/// Returns the groups of the side sets whose elements own the faces.
std::vector<NamedSurface> TakeSideSets(std::vector<SideSet> sets)
{
  std::vector<NamedSurface> surfaces;
  for (SideSet& set : sets)
  {
    if (set.DomainSide != NoSide || OwnsFace(set.Materials[0], set.Materials[1]))
    {
      surfaces.push_back({ KindOf(set), set.Id, std::move(set.Name), set.DomainSide, set.Materials,
        set.Surface, std::move(set.Sides) });
    }
  }
  return surfaces;
}

/// Adds "interfaces" and the skins, without ids. The facets of the mesh are known.
/// @pre Collective
void AddUnions(std::vector<NamedSurface>& surfaces, const MeshData& mesh, Ranks& ranks)
{
  NamedSurface all{ SurfaceKind::AllInterfaces, 0, "interfaces", NoSide, { { 0, 0 } }, 0, {} };
  std::map<int, std::vector<MeshSide>> skins;
  for (const MeshFacet& facet : *mesh.Facets)
  {
    const int material = mesh.Material[facet.Element];
    skins[material].push_back({ facet.Element, facet.Side });
    if (facet.Behind != NothingBehind && OwnsFace(material, facet.Behind))
    {
      all.Sides.push_back({ facet.Element, facet.Side });
    }
  }
  if (ranks.Any(!all.Sides.empty()))
  {
    surfaces.push_back(std::move(all));
  }
  const std::map<int, std::string> names = NamesOfMaterials(mesh);
  for (int material : FindMaterials(mesh, ranks))
  {
    surfaces.push_back({ SurfaceKind::Skin, 0, NameOfMaterial(names, material) + "_skin", NoSide,
      { { material, material } }, 0, std::move(skins[material]) });
  }
}

/// Sets the ids that are 0 to the lowest free ones.
void NumberUnions(std::vector<NamedSurface>& surfaces)
{
  std::set<int> used;
  for (const NamedSurface& surface : surfaces)
  {
    used.insert(surface.Id);
  }
  int next = FirstFreeId;
  for (NamedSurface& surface : surfaces)
  {
    if (surface.Id == 0)
    {
      while (!used.insert(next).second)
      {
        ++next;
      }
      surface.Id = next;
    }
  }
}

void SeparateNames(std::vector<NamedSurface>& surfaces)
{
  UniqueNames used;
  for (NamedSurface& surface : surfaces)
  {
    surface.Name = used.Add(surface.Name);
  }
}

} // namespace

std::vector<NamedSurface> FindNamedSurfaces(const MeshData& mesh, Ranks& ranks)
{
  MeshData listed = mesh;
  const std::vector<MeshFacet> facets = FindMeshFacets(mesh, ranks);
  listed.Facets = &facets;
  std::vector<NamedSurface> surfaces = TakeSideSets(FindMeshSets(listed, ranks).SideSets);
  AddUnions(surfaces, listed, ranks);
  NumberUnions(surfaces);
  SeparateNames(surfaces);
  return surfaces;
}

} // namespace vfm
