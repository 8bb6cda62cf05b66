#include "Meshes/OpenFoam/FoamSurfaces.h"

#include "Report/UniqueNames.h"

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

/// Side of the domain, materials from the one whose elements own the faces, and smooth side.
using SurfaceKey = std::array<int, 4>;

/// Returns the lowest surface of a set, or 0.
int SurfaceOf(const SideSet& set)
{
  return set.Surfaces.empty() ? 0 : set.Surfaces.front();
}

/// @param surface  smooth side, or 0
SurfaceKey KeyOf(const SideSet& set, int surface)
{
  const auto [first, second] = set.Materials;
  return OwnsFace(first, second) ? SurfaceKey{ { set.DomainSide, first, second, surface } }
                                 : SurfaceKey{ { set.DomainSide, second, first, surface } };
}

bool IsFinest(const NamedSurface& surface)
{
  return surface.Kind == SurfaceKind::DomainSide || surface.Kind == SurfaceKind::Interface ||
    surface.Kind == SurfaceKind::SmoothSide;
}

} // namespace

const SideSurface* FoamSurfaces::Find(const ElementSide& side) const
{
  const auto found = this->OfSideSet.find(this->Sides.TagOf(side));
  return found == this->OfSideSet.end() ? nullptr : &found->second;
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
  const std::vector<SideSet> sets = FindMeshSets(mesh, ranks).SideSets;
  FoamSurfaces found{ {}, TagFaces(sets), {} };
  std::map<SurfaceKey, int> indices;
  UniqueNames used;
  for (const NamedSurface& surface : SelectNamedSurfaces(sets))
  {
    if (IsFinest(surface))
    {
      const int index = static_cast<int>(found.Surfaces.size());
      indices[KeyOf(surface, SurfaceOf(surface))] = index;
      found.Surfaces.push_back(
        { used.Add(FoamWord(surface.Name)), surface.Kind == SurfaceKind::DomainSide,
          surface.Kind == SurfaceKind::SmoothSide ? indices.at(KeyOf(surface, 0)) : index });
    }
  }
  for (const SideSet& set : sets)
  {
    if (IsFinest(set))
    {
      found.OfSideSet[set.Id] = { indices.at(KeyOf(set, SurfaceOf(set))),
        !OwnsFace(set.Materials[0], set.Materials[1]) };
    }
  }
  return found;
}

} // namespace vfm
