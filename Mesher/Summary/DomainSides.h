/**
 * DomainSides: the sides of the domain of a mesh and what lies on them, from its fields DomainBounds and DomainFrame.
 */
#pragma once

#include "Input/ImageFrame.h"
#include "Summary/MeshData.h"

namespace vfm
{

constexpr int NoSide = -1;

/// Views the mesh. Sides are 0..5 for -x +x -y +y -z +z; of a turned image they are those of its own axes.
class DomainSides
{
public:
  explicit DomainSides(const MeshData& mesh);

  /// Without the field DomainBounds nothing is on a side.
  bool IsOnSide(Index point, int side) const;
  /// The side on which all points of a face lie, or NoSide. Points below 0 are skipped.
  int SideOfFace(const std::array<Index, 4>& points) const;

private:
  const MeshData& TheMesh;
  const std::vector<double> Bounds;
  ImageFrame Frame;
};

} // namespace vfm
