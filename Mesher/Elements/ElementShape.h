/**
 * ElementShape: the table of the kinds of elements, and their types in VTK.
 */
#pragma once

namespace vfm
{

/// A kind of elements. Corners, faces and edges are numbered in ElementFaces.h and MidNodes.h.
struct ElementShape
{
  int Corners, Mids; ///< corners per element, and mid nodes
  int Faces, Edges, CornersOfFace;
  int VtkType;
  const char* Plural; ///< name in messages
};

constexpr ElementShape ElementShapes[] = {
  { 4, 0, 4, 6, 3, 10, "tetrahedra" },  // VTK_TETRA
  { 4, 6, 4, 6, 3, 24, "tetrahedra" },  // VTK_QUADRATIC_TETRA
  { 8, 0, 6, 12, 4, 12, "hexahedra" },  // VTK_HEXAHEDRON
  { 8, 12, 6, 12, 4, 25, "hexahedra" }, // VTK_QUADRATIC_HEXAHEDRON
  { 8, 19, 6, 12, 4, 29, "hexahedra" }, // VTK_TRIQUADRATIC_HEXAHEDRON
};

/// Returns the kind of elements with these numbers of corners, 8 or 4, and mid nodes.
constexpr const ElementShape& ShapeOf(int corners, int mids = 0)
{
  return ElementShapes[corners == 4 ? (mids == 0 ? 0 : 1) : mids == 0 ? 2 : mids == 12 ? 3 : 4];
}

/// Returns whether elements with this number of corners, 8 or 4, are hexahedra.
constexpr bool AreHexes(int corners)
{
  return corners == 8;
}

/// Numbers of nodes of every element of a mesh.
struct NodeCounts
{
  int Corners = 8;        ///< 8 for hexes, 4 for tets
  int MidsPerElement = 0; ///< mid nodes (MidNodes.h): 12 or 19, 6 for tets; 0: linear

  const ElementShape& Shape() const { return ShapeOf(this->Corners, this->MidsPerElement); }
  bool HasHexes() const { return AreHexes(this->Corners); }
  int CornersOfFacet() const { return this->Shape().CornersOfFace; }
  int NodesPerElement() const { return this->Corners + this->MidsPerElement; }
};

} // namespace vfm
