#include "Meshes/Gmsh/GmshModel.h"

#include "Ranks/Errors.h"
#include "Report/MeshMaterials.h"
#include "Report/Sets/NamedSurfaces.h"
#include "Report/UniqueNames.h"

namespace vfm
{
namespace
{

constexpr std::size_t LongestName = 127;

/// Returns the tag of a material.
int TagOf(int material, int voidId)
{
  return material == 0 ? voidId : material;
}

/// Fills the volumes and the groups of materials.
void AddVolumes(GmshModel& model, int voidId)
{
  const MeshData& mesh = model.Mesh;
  for (Index element = 0; element < mesh.NumberOfElements; ++element)
  {
    const int volume = model.Entities.Volumes[element];
    const int tag = TagOf(mesh.Material[element], voidId);
    GmshVolume& entry = model.Volumes.emplace(volume, GmshVolume{ tag, {} }).first->second;
    if (volume < 1 || entry.Group != tag)
    {
      throw InputError("FragmentId " + std::to_string(volume) +
        (volume < 1 ? " is below 1" : " has elements of several materials") +
        ". Write the mesh as the filter made it, or without the array FragmentId.");
    }
    entry.Elements.push_back(element);
  }
}

void AddMaterialGroups(GmshModel& model, const std::vector<int>& materials, int voidId)
{
  const std::map<int, std::string> names = NamesOfMaterials(model.Mesh);
  UniqueNames used(LongestName);
  for (int material : materials)
  {
    model.Groups.push_back(
      { 3, TagOf(material, voidId), used.Add(PlainName(NameOfMaterial(names, material))) });
  }
  for (const CohesiveBlock& block : model.Blocks)
  {
    model.Groups.push_back({ 3, block.Id, used.Add(PlainName(block.Name)) });
  }
}

bool Contains(const NamedSurface& group, const SurfaceEntity& surface)
{
  switch (group.Kind)
  {
    case SurfaceKind::DomainSide:
      return surface.DomainSide == group.DomainSide;
    case SurfaceKind::Interface:
      return surface.DomainSide == NoSide && surface.Materials == group.Materials;
    case SurfaceKind::SmoothSide:
      return surface.DomainSide == NoSide && surface.Materials == group.Materials &&
        surface.SmoothSide == group.Surface;
    case SurfaceKind::AllInterfaces:
      return surface.IsInterface;
    case SurfaceKind::Skin:
      break;
  }
  return surface.Materials[0] == group.Materials[0] ||
    (surface.IsInterface && surface.Materials[1] == group.Materials[0]);
}

/// Returns the tags of the groups of a surface, the finest first.
std::vector<int> ListTags(
  const SurfaceEntity& surface, int finest, const std::vector<NamedSurface>& named)
{
  std::vector<int> tags{ finest };
  for (const NamedSurface& group : named)
  {
    if (group.Id != finest && Contains(group, surface))
    {
      tags.push_back(group.Id);
    }
  }
  return tags;
}

void AddSurfaceGroups(GmshModel& model, bool hasInterfaces)
{
  Ranks alone;
  const std::vector<NamedSurface> named = FindNamedSurfaces(model.Mesh, alone);
  UniqueNames used(LongestName);
  for (const NamedSurface& group : named)
  {
    model.Groups.push_back({ 2, group.Id, used.Add(PlainName(group.Name)) });
  }
  const TaggedFaces finest = TagFaces(named);
  for (const SurfaceEntity& surface : model.Entities.Surfaces)
  {
    if (surface.IsInterface && !hasInterfaces)
    {
      model.SurfaceGroups.emplace_back();
      continue;
    }
    model.SurfaceGroups.push_back(ListTags(surface, finest.TagOf(surface.Sides.front()), named));
    model.NumberOfFaces += static_cast<Index>(surface.Sides.size());
  }
}

} // namespace

GmshModel MakeGmshModel(const MeshData& mesh, bool hasInterfaces)
{
  Ranks alone;
  GmshModel model{ mesh, FindMeshEntities(mesh), {}, {}, {}, 0, FindCohesiveBlocks(mesh, alone) };
  const std::vector<int> materials = FindMaterials(mesh, alone);
  const int voidId = materials.front() == 0 ? FindVoidId(mesh, alone) : 0;
  AddVolumes(model, voidId);
  AddSurfaceGroups(model, hasInterfaces);
  AddMaterialGroups(model, materials, voidId);
  std::sort(model.Groups.begin(), model.Groups.end(),
    [](const GmshGroup& a, const GmshGroup& b)
    { return a.Dimension != b.Dimension ? a.Dimension < b.Dimension : a.Tag < b.Tag; });
  return model;
}

} // namespace vfm
