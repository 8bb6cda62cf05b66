/**
 * NamedSurfaces: the side sets for files in which a face belongs to one element.
 *
 * Of the two side sets of an interface or smooth side (MeshSets.h), only the one with the elements
 * that own the faces remains: those of the lower material, at a void those of the material.
 * So every face is in exactly one group of a domain side or an interface. In a skin it belongs to
 * the element of the material, so its normal points outward.
 */
#pragma once

#include "Report/Sets/MeshSets.h"

#include <map>

namespace vfm
{

using NamedSurface = SideSet;

/// Returns the side sets of which a file with one element per face has the faces.
std::vector<NamedSurface> SelectNamedSurfaces(std::vector<SideSet> sets);

/// Finds the groups that have faces on any rank.
/// @param mesh  part of this rank; its fields must be equal on all ranks, also without elements
/// @return the same list of ids and names on all ranks; each face is on one rank, except in skins
/// on the rank of each of its elements
/// @throws InputError  if FindMeshFacets does
/// @pre Collective
std::vector<NamedSurface> FindNamedSurfaces(const MeshData& mesh, Ranks& ranks);

/// Each face on a side of the domain or an interface once, with the id of its finest named surface:
/// the side of the domain, the smooth side, or the interface.
struct TaggedFaces
{
  std::vector<ElementSide> Faces;   ///< ascending
  std::vector<int> Tags;            ///< of each face
  std::map<int, std::string> Names; ///< of the tags that occur

  /// Returns the tag of a face, or 0 if it is not listed.
  int TagOf(const ElementSide& face) const;
};

TaggedFaces TagFaces(const std::vector<NamedSurface>& surfaces);

} // namespace vfm
