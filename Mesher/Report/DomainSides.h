/**
 * DomainSides: finds the points and faces on the sides of the domain, from the fields DomainBounds
 * and DomainFrame of a mesh.
 */
#pragma once

#include "Input/ImageFrame.h"
#include "Report/MeshData.h"

namespace vfm
{

constexpr int NoSide = -1;

/// Returns the frame of image axes from the field DomainFrame of a mesh.
ImageFrame FrameOfDomain(const MeshData& mesh);

/// Returns the number of coordinates that the points of a mesh need in files: 2 if it is one of the
/// plane of x and y, else 3.
int NumberOfAxes(const MeshData& mesh);

/// Sides 0..5 are -x +x -y +y -z +z, in image axes if the image is rotated. Views the mesh, which
/// must outlive this object.
class DomainSides
{
public:
  explicit DomainSides(const MeshData& mesh);

  /// Returns whether a point is on a side; always false without the field DomainBounds.
  bool IsOnSide(Index point, int side) const;
  /// Returns whether the domain repeats across a side; false for NoSide.
  bool IsPeriodic(int side) const;
  /// Returns the side that contains all points of a face, or NoSide. Points below 0 are skipped.
  int SideOfFace(const std::array<Index, 4>& points) const;

private:
  const MeshData& TheMesh;
  const std::vector<double> Bounds, Periods;
  const ImageFrame Frame;
};

} // namespace vfm
