/**
 * The energy of tetrahedra that smoothing minimises, as a function of one point, with its exact derivatives.
 *
 *   E = sum over the tets at the point [ sum over their six edges ((s* / s)^p - s*^p) + (m* mu)^(3 q) + omega mu^3 ]
 *     + sum over the three edges of each that end there 1/4 (l* / |e|)^8
 *
 * s is the sine of the dihedral angle at an edge, mu = sum of the six squared edge lengths / (12 (3 V)^(2/3)) one over
 * the mean ratio: 1 in the regular tet. All lengths are in widths of the tet's cell, axis by axis. s* is another for
 * obtuse angles than for acute ones; as s*^p is taken off, E and its gradient pass 90 degrees without a jump.
 * All terms grow without bound as a tet degenerates, so a descent that starts valid stays valid.
 *
 * Powers are of squares throughout, no roots: with D = 6 V, l an edge and N_k, N_l twice the areas of its two faces,
 *   s^2 = D^2 l^2 / (N_k^2 N_l^2),   mu^3 = (sum of l^2)^3 / (432 D^2).
 * In one point D is affine and each l^2 and N^2 quadratic, so gradient and Hessian are closed form. Tets at the point are computed side by
 * side in the order of ActiveMesh::CornerList: eight in floats, from differences to the point taken in doubles, and where a tet is near to
 * flat or the energy large, all tets of the point once more, four at a time in doubles. So no tet that is not positive in doubles is valid.
 */
#pragma once

#include "Smoothing/ElementEnergy.h"

namespace vfm
{

/// Where the terms of TetEnergy begin to rise steeply.
struct TetQualityFloors
{
  double Acute = 0.52;        ///< s*: sine of a dihedral angle up to 90 degrees
  double Obtuse = 0.64;       ///< s*: of one beyond
  double MeanRatio = 0.46;    ///< m*
  double ShortestEdge = 0.25; ///< l*, in cell widths
};

/// p = 2 SmoothingStage::HalfPower, q = max(1, HalfPower / 2). InvalidEnergy where a tet has D <= 1e-9 cell volumes.
/// Tets have VTK's corner order: D = det(b - a, c - a, d - a).
class TetEnergy : public ElementEnergy
{
public:
  /// precise: in doubles alone.
  explicit TetEnergy(const TetQualityFloors& floors, bool precise = false) :
    Floors(floors), Precise(precise)
  {
  }

  double Evaluate(const ActiveMesh& mesh, int point, const Vector3& x,
    const SmoothingStage& stage) const override;
  Derivatives Differentiate(
    const ActiveMesh& mesh, int point, const SmoothingStage& stage) const override;

  /// Of one tet, each of its terms once: six dihedral angles, shape, six edges.
  double OfTet(const Vector3 corners[4], const Vector3& widths, const SmoothingStage& stage) const;
  /// Of four tets, each as OfTet gives it, at the cost of one.
  std::array<double, 4> OfTets(
    const Vector3 corners[4][4], const Vector3& widths, const SmoothingStage& stage) const;

private:
  TetQualityFloors Floors;
  bool Precise;
};

} // namespace vfm
