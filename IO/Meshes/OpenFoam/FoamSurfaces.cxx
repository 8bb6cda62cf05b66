#include "Meshes/OpenFoam/FoamSurfaces.h"

#include "Report/MeshFacets.h"
#include "Report/UniqueNames.h"

#include <map>

namespace vfm
{
namespace
{

bool IsLetter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool IsWordCharacter(char c)
{
  return IsLetter(c) || (c >= '0' && c <= '9') || c == '-' || c == '.';
}

/// Domain side, materials and smooth side of a surface.
using SurfaceKey = std::array<int, 4>;

SurfaceKey KeyOf(const NamedSurface& surface)
{
  return { { surface.DomainSide, surface.Materials[0], surface.Materials[1], surface.Surface } };
}

/// Returns the key of the finest surface of a facet of an element.
SurfaceKey KeyOf(const MeshFacet& facet, int material)
{
  if (facet.DomainSide != NoSide)
  {
    return { { facet.DomainSide, 0, 0, 0 } };
  }
  const int behind = std::max(facet.Behind, 0);
  return OwnsFace(material, facet.Behind)
    ? SurfaceKey{ { NoSide, material, behind, facet.Surface } }
    : SurfaceKey{ { NoSide, behind, material, facet.Surface } };
}

bool IsFinest(const NamedSurface& surface)
{
  return surface.Kind == SurfaceKind::DomainSide || surface.Kind == SurfaceKind::Interface ||
    surface.Kind == SurfaceKind::SmoothSide;
}

/// Names the surfaces and returns the index of each key.
std::map<SurfaceKey, int> AddSurfaces(
  const std::vector<NamedSurface>& named, std::vector<FoamSurface>& surfaces)
{
  std::map<SurfaceKey, int> indices;
  UniqueNames used;
  for (const NamedSurface& surface : named)
  {
    if (!IsFinest(surface))
    {
      continue;
    }
    const int index = static_cast<int>(surfaces.size());
    indices[KeyOf(surface)] = index;
    const auto interface =
      indices.find({ { NoSide, surface.Materials[0], surface.Materials[1], 0 } });
    surfaces.push_back({ used.Add(FoamWord(surface.Name)), surface.Kind == SurfaceKind::DomainSide,
      surface.Kind == SurfaceKind::SmoothSide ? interface->second : index });
  }
  return indices;
}

} // namespace

const SurfaceSide* FoamSurfaces::Find(Index side) const
{
  const auto found = std::lower_bound(this->Sides.begin(), this->Sides.end(), side,
    [](const SurfaceSide& entry, Index number) { return entry.Side < number; });
  return found == this->Sides.end() || found->Side != side ? nullptr : &*found;
}

std::string FoamWord(const std::string& name)
{
  std::string word;
  for (char c : name)
  {
    const bool isContinuation = (static_cast<unsigned char>(c) & 0xC0) == 0x80; // of UTF-8
    if (!isContinuation)
    {
      word += IsWordCharacter(c) ? c : '_';
    }
  }
  return word.empty() || !IsLetter(word[0]) ? "_" + word : word;
}

FoamSurfaces FindFoamSurfaces(const MeshData& mesh, Ranks& ranks)
{
  const std::vector<MeshFacet> facets = FindMeshFacets(mesh, ranks);
  MeshData listed = mesh;
  listed.Facets = &facets;
  FoamSurfaces found;
  const std::map<SurfaceKey, int> indices =
    AddSurfaces(FindNamedSurfaces(listed, ranks), found.Surfaces);
  const int sides = ElementFaces(mesh.Corners).Count;
  for (const MeshFacet& facet : facets)
  {
    const int material = mesh.Material[facet.Element];
    found.Sides.push_back({ sides * facet.Element + facet.Side, indices.at(KeyOf(facet, material)),
      !OwnsFace(material, facet.Behind) });
  }
  return found;
}

} // namespace vfm
