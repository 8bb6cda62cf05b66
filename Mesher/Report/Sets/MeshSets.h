/**
 * MeshSets: the side sets and node sets of a mesh, from its facets.
 *
 * Side sets:
 * - each ordered pair of adjacent materials: "ball_to_plate" has the faces of elements of the first
 *   material that touch the second, "ball_to_Void" the free surface;
 * - each side of an interface with several sides: "ball_to_Void_3" for surface 3. If the surface of
 *   a body names it (field PatchNames) "inlet", the name is "inlet" for elements next to void, and
 *   "inlet_ball_to_plate" next to another material; surfaces of one patch are in one set;
 * - each side of the domain, "x_min" to "z_max", with faces of all materials. These faces are in no
 *   set of a pair;
 * - "interfaces", all faces between two materials once, where cohesive elements can be inserted;
 * - the skin of each material, "ball_skin": all faces of its elements that touch other materials,
 *   nothing, or the boundary of the domain.
 *
 * Node sets: each side of the domain, and each smooth side with the name and id of its side set.
 *
 * Sides of a rotated image (field DomainFrame) are in image axes: x_min is where the first
 * index begins.
 */
#pragma once

#include "Report/DomainSides.h"
#include "Report/MatchFaces.h"

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

/// A named set of faces of elements.
struct SideSet
{
  SurfaceKind Kind;
  int Id; ///< unique, from 1
  std::string Name;
  int DomainSide; ///< 0..5 for -x +x -y +y -z +z; NoSide for other kinds
  /// Interface, SmoothSide: materials of the elements and behind. Skin: its material, twice.
  std::array<int, 2> Materials;
  /// Surface of a smooth side, or all surfaces of a patch between its materials; empty otherwise.
  std::vector<int> Surfaces;
  std::vector<ElementSide> Sides; ///< sides on this rank, ascending
};

/// Returns whether a face belongs to this element, not to the element behind it.
/// @param material  material of the element; 0 is void
/// @param behind  material behind the face, or NothingBehind
inline bool OwnsFace(int material, int behind)
{
  return behind <= 0 || (material > 0 && material < behind);
}

struct NodeSet
{
  int Id;
  std::string Name;
  std::vector<Index> Points; ///< points of this rank, ascending; sides: as FindSidePoints
};

/// All sets of a mesh.
struct MeshSets
{
  std::vector<SideSet> SideSets;
  std::vector<NodeSet> NodeSets;
};

/// Finds the sets that have entries on any rank.
/// Ids of side sets:
/// - sides of the domain: 1 to 6, x_min first;
/// - pairs: 1000 * first + second for material ids below 1,000, a greater power of ten for greater
///   ids, or consecutive numbers from 7 if that exceeds 31 bits. The void is 0 as second,
///   FindVoidId() as first material;
/// - smooth sides: 1000 * (id of the pair) + surface, for patches the lowest one, or a greater
/// power of ten, or consecutive
///   numbers after the pairs if that exceeds 31 bits;
/// - "interfaces", then the skins in the order of the materials: the lowest from 7 that are free.
/// A repeated name gets the ending _2, _3 and so on.
/// @param mesh part of this rank; its fields must be equal on all ranks, also without elements
/// @return the same list of ids and names on all ranks
/// @throws InputError if FindMeshFacets does
/// @pre Collective
MeshSets FindMeshSets(const MeshData& mesh, Ranks& ranks);

} // namespace vfm
