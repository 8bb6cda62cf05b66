/**
 * GmshModel: the entities and physical groups of a mesh for Gmsh.
 *
 * In a mesh of a plane, the "volumes" of the model are surfaces of Gmsh, and its "surfaces" curves.
 */
#pragma once

#include "Meshes/Files/MeshModel.h"
#include "Report/Sets/MeshEntities.h"

#include <map>

namespace vfm
{

/// A physical group. Tags and names are unique in each dimension.
struct GmshGroup
{
  int Dimension; ///< 2 surfaces, 3 volumes; of a plane 1 curves, 2 surfaces
  int Tag;
  std::string Name; ///< at most 127 bytes of UTF-8, without quotes and control characters
};

/// Returns the dimension of the elements: 3, or 2 in a plane.
int DimensionOfElements(const MeshData& mesh);

struct GmshVolume
{
  int Group;                   ///< tag of its material
  std::vector<Index> Elements; ///< ascending
};

struct GmshModel
{
  const MeshData& Mesh; ///< whole mesh; must outlive this object
  MeshEntities Entities;
  std::vector<GmshGroup> Groups;     ///< by dimension and tag
  std::map<int, GmshVolume> Volumes; ///< by number in Entities
  /// Tags of the groups of each surface. The first one is the finest: the side of the domain, the
  /// smooth side, or the interface. Surfaces whose faces are left out have none.
  std::vector<std::vector<int>> SurfaceGroups;
  Index NumberOfFaces = 0; ///< faces of the surfaces with groups
  /// Cohesive elements. Each block is a group of volumes with the id of the block, and a volume
  /// with the number after the one before, or after all others.
  std::vector<CohesiveBlock> Cohesive;

  /// Returns the number of the volume of the first block.
  int FirstCohesiveVolume() const { return this->Volumes.rbegin()->first + 1; }

  bool HasFaces(std::size_t surface) const { return !this->SurfaceGroups[surface].empty(); }
};

/// Makes the model of a whole mesh with Facets. Materials are groups of volumes with their ids, the
/// void with FindVoidId(). NamedSurfaces are groups of surfaces.
/// @param hasInterfaces  whether the model has the faces between elements
/// @throws InputError  if FragmentId is below 1 or has elements of several materials
GmshModel MakeGmshModel(const MeshData& mesh, bool hasInterfaces);

} // namespace vfm
