/**
 * NamedSurfaces: groups of faces with names, for files in which a face belongs to one element.
 *
 * Groups, named and numbered as the side sets (MeshSets.h) where those exist:
 * - each side of the domain, "x_min" to "z_max", ids 1 to 6;
 * - each interface: "ball_to_plate" has the faces between two materials, "ball_to_Void" the free
 *   surface and the faces to a meshed void;
 * - each smooth side of an interface with several smooth sides: "ball_to_Void_3";
 * - "interfaces", all faces between two materials, where cohesive elements can be inserted;
 * - the skin of each material, "ball_skin": all faces of its elements that touch other materials,
 *   nothing, or the boundary of the domain.
 *
 * Every face is in exactly one group of a domain side or an interface. It belongs to the element of
 * the lower material, at a void to the element of the material. In a skin it belongs to the element
 * of the material, so its normal points outward.
 */
#pragma once

#include "Summary/MeshSets.h"

namespace vfm
{

enum class SurfaceKind
{
  DomainSide,
  Interface,
  SmoothSide,
  AllInterfaces,
  Skin
};

/// A named group of faces.
struct NamedSurface
{
  SurfaceKind Kind;
  int Id; ///< unique, from 1
  std::string Name;
  int DomainSide; ///< 0..5 for -x +x -y +y -z +z; NoSide for other kinds
  /// Interface, SmoothSide: materials of the elements and behind. Skin: its material, twice.
  std::array<int, 2> Materials;
  int Surface;                 ///< surface of a smooth side; 0 otherwise
  std::vector<MeshSide> Sides; ///< sides on this rank, ascending
};

/// Returns whether a face belongs to this element, not to the element behind it.
/// @param material  material of the element; 0 is void
/// @param behind  material behind the face, or NothingBehind
inline bool OwnsFace(int material, int behind)
{
  return behind <= 0 || (material > 0 && material < behind);
}

/// Finds the groups that have faces on any rank. Ids of "interfaces" and of the skins, in the order
/// of the materials, are the lowest from 7 that no side set has. A repeated name gets the ending
/// _2, _3 and so on.
/// @param mesh  part of this rank; its fields must be equal on all ranks, also without elements
/// @return the same list of ids and names on all ranks; each face is on one rank, except in skins
/// on the rank of each of its elements
/// @throws InputError  if FindMeshFacets does
/// @pre Collective
std::vector<NamedSurface> FindNamedSurfaces(const MeshData& mesh, Ranks& ranks);

} // namespace vfm
