/**
 * FlatEnergy: the barrier energy of a layer of hexes whose points are in straight columns of two
 * across the layer, so that each hex is a prism over a quad, or two prisms over triangles. It is
 * HexEnergy in two dimensions, for the lower point of a column:
 *
 *   E = sum over corners [ (s* / SJ)^p + omega (tr T^T T) / 2 / det T ]
 *     + sum over edge ends (l* / |e|)^8
 *
 * SJ is the sine of the angle at a corner, in triangles of cells that are not squares as a part of
 * the one that the cell has. Elements that are positive at their corners are positive throughout,
 * and so are the prisms. All sums are in doubles.
 */
#pragma once

#include "Smoothing/ElementEnergy.h"
#include "Smoothing/Hex/FlatDiagonals.h"

namespace vfm
{

/// Barrier energy of valid prisms. It reads the lower points of columns only. Thread safe.
class FlatEnergy : public ElementEnergy
{
public:
  /// @param target  s*
  /// @param axis  of the columns, 0 to 2
  /// @param diagonals  of triangles; null: quads. They must outlive the energy.
  FlatEnergy(double target, int axis, const FlatDiagonals* diagonals = nullptr) :
    Target(target), Plane(axis), Diagonals(diagonals)
  {
  }
  double Evaluate(const ActiveMesh& mesh, int point, const Vector3& x,
    const SmoothingStage& stage) const override;
  Derivatives Differentiate(
    const ActiveMesh& mesh, int point, const SmoothingStage& stage) const override;
  bool MarkLost(const ActiveMesh& mesh, Runtime& runtime,
    const std::vector<unsigned char>& returned, const std::vector<unsigned char>& where,
    std::vector<unsigned char>& points) const override;
  bool KeepsAt(const ActiveMesh& mesh, int point, const Vector3& x) const override;

private:
  double Target;
  FlatPlane Plane;
  const FlatDiagonals* Diagonals;
};

} // namespace vfm
