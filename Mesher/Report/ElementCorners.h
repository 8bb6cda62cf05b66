/**
 * ElementCorners: the positions of the corners of elements, and of copies of faces in periodic
 * meshes.
 */
#pragma once

#include "Input/ImageFrame.h"
#include "Report/MeshData.h"

namespace vfm
{

/// Positions of the corners of elements. Views the mesh, which must outlive this object.
class ElementCorners
{
public:
  explicit ElementCorners(const MeshData& mesh);

  /// Returns the corners of an element; with 4 corners, the others are 0. Where the sides of a
  /// periodic mesh are joined, each corner is at the period nearest to the first corner.
  std::array<Vector3, 8> Find(Index element) const;

private:
  const MeshData& TheMesh;
  const std::vector<double> Lengths; // empty: no sides are joined
  const ImageFrame Frame;
};

/// Positions of copies of a face or a point, as numbers that ranks can compare.
class FacePlaces
{
public:
  /// @param mesh with the fields DomainBounds and, if it is rotated, DomainFrame
  explicit FacePlaces(const MeshData& mesh);

  /// Returns a number >= 0 for a centre not farther than a length of the domain from it.
  /// @param corners of a face in any order, or a point
  Index Of(const std::vector<Vector3>& corners) const;

  static constexpr Index End = 16 * 16 * 16; ///< above all places

  /// Returns the number of periods, along axes of the image, between two copies.
  static Index3 PeriodsBetween(Index from, Index to);

private:
  const std::vector<double> Bounds;
  const ImageFrame Frame;
};

} // namespace vfm
