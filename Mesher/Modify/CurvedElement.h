/**
 * CurvedElement: the Jacobian of second-order elements in Bezier form. If all its coefficients are
 * positive, it is positive in the whole element, not only at nodes or quadrature points.
 *
 * The Jacobian of a hexahedron of 20 nodes is a polynomial of degree 5 along each axis, with 216
 * coefficients; that of a tetrahedron of 10 nodes is of degree 3, with 20. They are found from as
 * many values at the points of a lattice (Johnen, Remacle, Geuzaine, J. Comput. Phys. 233 (2013)
 * 359-372).
 */
#pragma once

#include "Elements/MidNodes.h"

#include <Eigen/Core>

namespace vfm
{

/// Shape functions of a second-order element, and the Bezier form of its Jacobian. Const functions
/// may be called by several threads.
class CurvedElement
{
public:
  static constexpr int MaximumNodes = 20;
  using Nodes = std::array<Vector3, MaximumNodes>;

  /// @param corners  8: hexahedron of 20 nodes; 4: tetrahedron of 10 nodes
  explicit CurvedElement(int corners);

  /// Returns the number of nodes.
  int NodeCount() const { return static_cast<int>(this->Along[0].cols()); }
  /// Returns the smallest Bezier coefficient of the Jacobian, a lower bound of it. The Jacobian of
  /// a hexahedron is for the unit cube, that of a tetrahedron for the unit simplex.
  /// @param nodes  positions in VTK's order
  double SmallestCoefficient(const Nodes& nodes) const;
  /// Returns the volume.
  double Volume(const Nodes& nodes) const;

private:
  using Matrix = Eigen::MatrixXd;

  /// Derivatives of the shape functions at some points, (points, nodes).
  using Slopes = Matrix[3];

  void SetRule(int corners);
  Eigen::VectorXd JacobianAt(const Slopes& along, const Nodes& nodes) const;

  Slopes Along;            // at the points of the lattice
  Matrix ToBernstein;      // (coefficients, points of the lattice)
  Slopes AlongRule;        // at the points of a rule that integrates the Jacobian exactly
  Eigen::VectorXd Weights; // of these points
};

/// Returns the element of a kind.
/// @param corners  8 or 4
const CurvedElement& GetCurvedElement(int corners);

} // namespace vfm
