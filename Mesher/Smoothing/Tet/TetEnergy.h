/**
 * TetEnergy: the energy of tetrahedra that smoothing minimises, as a function of one point, with
 * its exact derivatives.
 *
 *   E = sum over the tets at the point
 *         [ sum over their six edges ((s* / s)^p - s*^p) + (m* mu)^(3 q) + omega mu^3 ]
 *     + sum over the three edges of each tet that end at the point 1/4 (l* / |e|)^8
 *
 *   mu = sum of the six squared edge lengths / (12 (3 V)^(2/3))
 *
 * s is the sine of the dihedral angle at an edge, V the volume. mu is the inverse of the mean
 * ratio, 1 in the regular tet. All lengths are in widths of the tet's cell, axis by axis. s*
 * differs between acute and obtuse angles; because s*^p is subtracted, E and its gradient are
 * continuous at 90 degrees. All terms grow without bound as a tet degenerates, so a descent that
 * starts valid stays valid.
 *
 * All powers are of squares, so that no roots are needed. With D = 6 V, an edge of length l, and
 * twice the areas N_k, N_l of its two faces:
 *
 *   s^2 = D^2 l^2 / (N_k^2 N_l^2),   mu^3 = (sum of l^2)^3 / (432 D^2).
 *
 * As functions of one point, D is affine and each l^2 and N^2 quadratic, so gradient and Hessian
 * have closed forms. The tets at the point are computed in the order of ActiveMesh::CornerList:
 * eight at once in floats, from differences to the point taken in doubles. If a tet is nearly flat
 * or the energy large, all tets of the point are computed again in doubles, four at once. A tet is
 * therefore valid only if it is positive in doubles.
 */
#pragma once

#include "Smoothing/ElementEnergy.h"

namespace vfm
{

/// Values at which the terms of TetEnergy begin to rise steeply.
struct TetQualityFloors
{
  double Acute = 0.52;        ///< s*: sine of dihedral angles up to 90 degrees
  double Obtuse = 0.64;       ///< s*: sine of dihedral angles above 90 degrees
  double MeanRatio = 0.46;    ///< m*
  double ShortestEdge = 0.25; ///< l*, in cell widths
};

/// Energy with p = 2 SmoothingStage::HalfPower, q = max(1, HalfPower / 2). It is InvalidEnergy if a
/// tet has D <= 1e-9 cell volumes. Tets have VTK's corner order: D = det(b - a, c - a, d - a).
class TetEnergy : public ElementEnergy
{
public:
  /// @param precise  computes only in doubles
  explicit TetEnergy(const TetQualityFloors& floors, bool precise = false) :
    Floors(floors), Precise(precise)
  {
  }

  double Evaluate(const ActiveMesh& mesh, int point, const Vector3& x,
    const SmoothingStage& stage) const override;
  Derivatives Differentiate(
    const ActiveMesh& mesh, int point, const SmoothingStage& stage) const override;

  /// Returns the energy of one tet with each term once: six dihedral angles, shape, six edges.
  double OfTet(const Vector3 corners[4], const Vector3& widths, const SmoothingStage& stage) const;
  /// Returns the energies of four tets, each equal to OfTet, at the cost of one.
  std::array<double, 4> OfTets(
    const Vector3 corners[4][4], const Vector3& widths, const SmoothingStage& stage) const;

private:
  TetQualityFloors Floors;
  bool Precise;
};

} // namespace vfm
