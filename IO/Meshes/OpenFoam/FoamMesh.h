/**
 * FoamMesh: faces, patches and zones of a mesh in the order of OpenFOAM.
 *
 * - Points and cells are ordered by global id, each once.
 * - Faces between two cells of this rank come first, ordered by owner (the lower cell), then by
 *   neighbour; then the faces of each patch; then those of cyclic patches whose copy is on another
 *   rank; then the faces to other ranks. Normals point out of the owner. Each face begins with its
 *   lowest point; in a periodic mesh with the one with the lowest partner.
 * - Patches of a periodic mesh: pairs of type cyclic on opposite sides of the domain, also for
 *   faces between two materials. Face i of one patch is a translate of face i of the other, with
 *   the same first point. Faces with their copy on another rank are in patches of type
 *   processorCyclic, as decomposePar makes them.
 * - Other patches: each side of the domain, of type patch; each smooth side, or else interface, to
 *   space without elements, of type wall; "defaultFaces" for boundary faces that are on no named
 *   surface. A smooth side is in the patch group of its interface.
 * - Zones: cells of each material; faces between cells of each interface, oriented from its first
 *   to its second material. Faces of cyclic patches are in no zone.
 * - A mesh of a plane becomes a layer of prisms (FoamLayer.h): its edges are faces as above, then
 *   follow the lower faces of all cells and the upper ones, each in a patch of type empty.
 */
#pragma once

#include "Meshes/OpenFoam/CellSides.h"
#include "Meshes/OpenFoam/FoamPatches.h"
#include "Meshes/OpenFoam/GlobalOrder.h"
#include "Report/FlatData.h"

namespace vfm
{

struct FoamMesh
{
  MeshData Mesh; ///< ordered part of this rank; a view
  int Rank = 0;
  GlobalOrder Points, Cells;
  std::vector<Index> Sides;       ///< side of the owner of each face (CellSides.h), except ends
  std::vector<Index> Neighbours;  ///< neighbour of each inner face
  std::vector<RemoteSide> Remote; ///< faces to other ranks, the last ones in Sides
  /// Number of each face of cyclic patches, counted from the first face on patches of the whole
  /// mesh: first the faces of patches of type cyclic, then those of type processorCyclic.
  std::vector<Index> CyclicNumbers;
  Index TotalCyclic = 0; ///< number of faces of cyclic patches of all ranks
  /// Patches with the same names on all ranks, then patches to other ranks.
  std::vector<FoamPatch> Patches;
  std::vector<FoamZone> CellZones, FaceZones; ///< the same names on all ranks
  Index TotalFaces = 0;                       ///< on all ranks, each once

  Index NumberOfSides() const { return static_cast<Index>(this->Sides.size()); }
  /// Returns the number of faces of this rank, with the ends of the prisms of a plane.
  Index NumberOfFaces() const
  {
    return this->NumberOfSides() + (IsFlat(this->Mesh) ? 2 * this->Mesh.NumberOfElements : 0);
  }
  Index Owner(Index face) const
  {
    const Index end = face - this->NumberOfSides();
    return end < 0 ? this->Sides[face] / SidesOf(this->Mesh) : end % this->Mesh.NumberOfElements;
  }
};

/// Makes the model of this rank's part.
/// @param mesh  ordered mesh (OrderMesh), with MaterialId; must outlive the result; of a plane on
/// one
///   rank only
/// @throws InputError  if faces do not match, or if FindNamedSurfaces does; on all ranks
/// @pre Collective
FoamMesh MakeFoamMesh(const MeshData& mesh, Ranks& ranks);

/// @throws InputError  if a number of the whole case, or of a list of this rank, exceeds 2^31 - 1
void CheckSizes(const FoamMesh& foam);

} // namespace vfm
