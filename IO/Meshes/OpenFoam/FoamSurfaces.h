/**
 * FoamSurfaces: the named surfaces of a mesh with names for OpenFOAM.
 */
#pragma once

#include "Report/Sets/NamedSurfaces.h"

namespace vfm
{

struct FoamSurface
{
  std::string Name;  ///< unique word
  bool IsDomainSide; ///< otherwise an interface or a smooth side
  int Interface;     ///< index of the interface of a smooth side; else of the surface itself
};

/// Surface of a side of an element.
struct SideSurface
{
  int Surface; ///< index of its domain side, interface, or smooth side if it has one
  /// Whether the normal of the interface, from the first to the second material, points into the
  /// element.
  bool IsFlipped;
};

struct FoamSurfaces
{
  std::vector<FoamSurface> Surfaces;    ///< equal on all ranks
  TaggedFaces Sides;                    ///< sides of this rank's elements, tagged by side set
  std::map<int, SideSurface> OfSideSet; ///< by id

  /// Returns the surface of a side, or null.
  const SideSurface* Find(const ElementSide& side) const;
};

/// Returns a name as a word of OpenFOAM: letters, digits and _ - . after a letter or _. Other
/// characters become _.
std::string FoamWord(const std::string& name);

/// Finds the surfaces of a mesh. A side between two elements is in the list once for each.
/// @throws InputError  if FindMeshSets does
/// @pre Collective
FoamSurfaces FindFoamSurfaces(const MeshData& mesh, Ranks& ranks);

} // namespace vfm
