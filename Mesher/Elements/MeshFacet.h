/**
 * MeshFacet: a side of an element; one on an interface or on the boundary of the mesh.
 */
#pragma once

#include "Base/IndexBox.h"

#include <compare>

namespace vfm
{

/// Value of MeshFacet::Behind if there is no element on the other side.
constexpr int NothingBehind = -1;

/// GeometryDimension of points on a surface and inside a volume.
constexpr int DimensionOfSurfaces = 2, DimensionOfVolumes = 3;

/// A side of an element.
struct ElementSide
{
  Index Element; ///< element of this rank, from 0
  int Side;      ///< face of the element, in the numbering of vtkHexahedron and vtkTetra, from 0
  auto operator<=>(const ElementSide&) const = default;
};

/// Side of an element on an interface or on the boundary of the mesh.
struct MeshFacet
{
  Index Element;  ///< as in ElementSide
  int Side;       ///< as in ElementSide
  int Behind;     ///< material of the element on the other side, on any rank, or NothingBehind
  int Surface;    ///< smooth side of the interface, from 1 over all ranks; 0 if it has only one
  int DomainSide; ///< -1, or 0..5 for -x +x -y +y -z +z

  operator ElementSide() const { return { this->Element, this->Side }; }
  bool operator<(const MeshFacet& other) const { return ElementSide(*this) < ElementSide(other); }
};

} // namespace vfm
