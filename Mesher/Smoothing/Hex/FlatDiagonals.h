/**
 * FlatDiagonals: how the quads of a layer of hexes are divided into triangles while points move.
 */
#pragma once

#include "Elements/FlatPlane.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// Diagonals of the lower faces of the hexes of a layer. At first they join the corners of which
/// the coordinates of the cell are both lower or both higher.
class FlatDiagonals
{
public:
  /// @param axis  across the layer, 0 to 2
  explicit FlatDiagonals(int axis) : Plane(axis) {}

  /// Turns the diagonals of which the other one leaves clearly larger angles.
  /// @return the lower corners of their quads, which may repeat
  std::vector<int> Turn(const ActiveMesh& mesh);
  /// Returns whether the diagonal of a hex joins the two other corners.
  bool IsTurned(Index hex) const
  {
    return hex < static_cast<Index>(this->AreTurned.size()) && this->AreTurned[hex];
  }

private:
  FlatPlane Plane;
  std::vector<unsigned char> AreTurned; // of each hex; empty: none
};

/// Returns the lower corners of a hex, counterclockwise, from the one with the lowest coordinates.
inline std::array<int, 4> LowerCorners(const ActiveMesh& mesh, const FlatPlane& plane, Index hex)
{
  const int u = 1 << plane.U, v = 1 << plane.V;
  const int* points = mesh.Elements.data() + 8 * hex;
  return { { points[0], points[u], points[u ^ v], points[v] } };
}

/// Returns where the lower corners of a hex are.
inline std::array<FlatVector, 4> LowerQuad(
  const ActiveMesh& mesh, const FlatPlane& plane, Index hex)
{
  std::array<FlatVector, 4> quad;
  const std::array<int, 4> corners = LowerCorners(mesh, plane, hex);
  std::transform(corners.begin(), corners.end(), quad.begin(),
    [&](int corner) { return plane.At(mesh.X[corner]); });
  return quad;
}

} // namespace vfm
