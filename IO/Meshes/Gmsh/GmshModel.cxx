#include "Meshes/Gmsh/GmshModel.h"

#include "Base/Sorted.h"
#include "Ranks/Errors.h"
#include "Report/FlatData.h"
#include "Report/Sets/NamedSurfaces.h"

#include <utility>

namespace vfm
{
namespace
{

constexpr std::size_t LongestName = 127;

/// Fills the volumes, which take the elements of the materials.
void AddVolumes(GmshModel& model, std::vector<MaterialPart>& parts)
{
  for (MaterialPart& part : parts)
  {
    for (Index element : std::exchange(part.Elements, {}))
    {
      const int volume = model.Entities.Volumes[element];
      GmshVolume& entry = model.Volumes.emplace(volume, GmshVolume{ part.Id, {} }).first->second;
      if (volume < 1 || entry.Group != part.Id)
      {
        throw InputError("FragmentId " + std::to_string(volume) +
          (volume < 1 ? " is below 1" : " has elements of several materials") +
          ". Write the mesh as the filter made it, or without the array FragmentId.");
      }
      entry.Elements.push_back(element);
    }
  }
}

/// Adds the groups of materials and of cohesive elements.
void AddVolumeGroups(GmshModel& model, const std::vector<MaterialPart>& parts)
{
  UniqueNames used(LongestName);
  for (const MaterialPart& part : parts)
  {
    model.Groups.push_back(
      { DimensionOfElements(model.Mesh), part.Id, used.Add(PlainName(part.Name)) });
  }
  for (const CohesiveBlock& block : model.Cohesive)
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
        FindSorted(group.Surfaces, surface.SmoothSide) >= 0;
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

void AddSurfaceGroups(GmshModel& model, const std::vector<NamedSurface>& named, bool hasInterfaces)
{
  UniqueNames used(LongestName);
  for (const NamedSurface& group : named)
  {
    model.Groups.push_back(
      { DimensionOfElements(model.Mesh) - 1, group.Id, used.Add(PlainName(group.Name)) });
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

int DimensionOfElements(const MeshData& mesh)
{
  return IsFlat(mesh) ? 2 : 3;
}

GmshModel MakeGmshModel(const MeshData& mesh, bool hasInterfaces)
{
  Ranks alone;
  GmshModel model{ mesh, FindMeshEntities(mesh), {}, {}, {}, 0, {} };
  MeshModel contents = MakeMeshModel(mesh, alone);
  model.Cohesive = std::move(contents.Cohesive);
  AddVolumes(model, contents.Materials);
  AddSurfaceGroups(model, SelectNamedSurfaces(std::move(contents.Sets.SideSets)), hasInterfaces);
  AddVolumeGroups(model, contents.Materials);
  std::sort(model.Groups.begin(), model.Groups.end(),
    [](const GmshGroup& a, const GmshGroup& b)
    { return a.Dimension != b.Dimension ? a.Dimension < b.Dimension : a.Tag < b.Tag; });
  return model;
}

} // namespace vfm
