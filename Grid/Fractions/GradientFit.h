/**
 * GradientFit: the gradient of cell values at a cell, by least squares over the cells around it.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <Eigen/Cholesky>

namespace vfm
{

/// Least-squares fit of a gradient with weights 1 / distance^2.
class GradientFit
{
public:
  /// Adds a cell to the fit.
  /// @param r  vector from the middle cell, not zero
  /// @param difference  value of the cell minus the value of the middle cell
  /// @param weight  factor on the weight 1 / |r|^2
  void Add(const Vector3& r, double difference, double weight = 1.0)
  {
    const Eigen::Vector3d x(r[0], r[1], r[2]);
    const double w = weight / x.squaredNorm();
    this->A += w * x * x.transpose();
    this->B += w * difference * x;
  }

  /// Returns the gradient, with 0 along axes without neighbours.
  Vector3 Solve() const
  {
    Eigen::Matrix3d a = this->A;
    for (int axis = 0; axis < 3; ++axis)
    {
      a(axis, axis) += a(axis, axis) == 0.0; // the grid is one cell thick
    }
    const Eigen::Vector3d g = a.ldlt().solve(this->B);
    return { { g[0], g[1], g[2] } };
  }

private:
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d B = Eigen::Vector3d::Zero();
};

} // namespace vfm
