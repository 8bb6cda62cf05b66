/**
 * SplitFaces: the faces at which interfaces were split (Modify/SplitInterfaces.h), with the nodes
 * of both sides, and their cohesive elements.
 *
 * A split face has an element on each side, and at least one of its nodes has different copies on
 * both. The first side is that of the element that owns the face (OwnsFace): the lower material
 * id; next to a meshed void the material.
 */
#pragma once

#include "Options/MesherOptions.h"
#include "Report/Sets/MeshSets.h"

namespace vfm
{

/// Name of the field with the number of the SplitConnection of a split mesh.
constexpr const char* SplitConnectionField = "SplitConnection";

/// Returns the connection of a mesh; None if the mesh is not split.
ConnectionKind ConnectionOf(const MeshData& mesh);

/// Values of the nodes of a face: of four corners, of the mid nodes of its edges, of its centre; -1
/// for nodes that a face does not have.
using FaceNodes = std::array<Index, 9>;

/// A face whose sides are split, stored on the rank of its first element.
struct SplitFace
{
  ElementSide First;               ///< side of the first element
  std::array<int, 2> Materials;    ///< materials of both elements
  std::array<FaceNodes, 2> Points; ///< global ids of the nodes of both sides, in the order of the
                                   ///< first side
  FaceNodes Partners;              ///< PeriodicPartner of the second nodes, or their ids
};

/// Returns the split faces of which this rank has the first element, ascending by side.
/// @throws InputError if FindMeshFacets does
/// @pre Collective
std::vector<SplitFace> FindSplitFaces(const MeshData& mesh, Ranks& ranks);

/// The cohesive elements between two materials. The corners of an element are the nodes of the
/// first side, counterclockwise seen from the second side, then those of the second side: the order
/// of COH3D8, COH3D6 and of hexahedra and wedges in Exodus, with the thickness from the first to
/// the second side.
struct CohesiveBlock
{
  int Id;                         ///< above the ids of materials, also of a meshed void, and of
                                  ///< bins (MaterialBins.h)
  std::string Name;               ///< "steel_to_copper_cohesive"
  std::array<int, 2> Materials;   ///< of the first and of the second side
  std::vector<ElementSide> Sides; ///< sides of the first elements on this rank, ascending
  std::vector<Index> Points;      ///< points of the mesh, (elements, 2 * corners of a face)
  std::vector<Index> Ids;         ///< global ids, above the ids of all elements of the mesh
};

/// Returns the number of corners of a cohesive element.
inline int CohesiveCorners(const MeshData& mesh)
{
  return 2 * mesh.Shape().CornersOfFace;
}

/// Returns the cohesive elements of a mesh whose connection is Cohesive, else none.
/// Ids ascend by block, by element of the first side, and by its side; they do not depend on the
/// number of ranks.
/// @return the same list of blocks on all ranks, ascending by materials
/// @throws InputError if FindMeshFacets does, or if a point is missing; on all ranks
/// @pre Collective
std::vector<CohesiveBlock> FindCohesiveBlocks(const MeshData& mesh, Ranks& ranks);

/// The cohesive elements of all blocks, in the order of the blocks.
struct CohesiveElements
{
  std::vector<Index> Points, Ids; ///< as in CohesiveBlock
  std::vector<int> Materials;     ///< of the first and of the second side, (elements, 2)
};

CohesiveElements JoinBlocks(const std::vector<CohesiveBlock>& blocks);

} // namespace vfm
