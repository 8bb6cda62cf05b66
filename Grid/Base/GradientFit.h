/**
 * The gradient of cell values at a cell: least squares over the cells around it, weights 1 / distance^2.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <Eigen/Cholesky>

namespace vfm
{

class GradientFit
{
public:
  /// A cell at r (not zero) from the middle one, whose value differs by difference. weight: of its value.
  void Add(const Vector3& r, double difference, double weight = 1.0)
  {
    const Eigen::Vector3d x(r[0], r[1], r[2]);
    const double w = weight / x.squaredNorm();
    this->A += w * x * x.transpose();
    this->B += w * difference * x;
  }

  /// 0 along axes on which there are no cells around.
  Vector3 Solve() const
  {
    Eigen::Matrix3d a = this->A;
    for (int axis = 0; axis < 3; ++axis)
    {
      a(axis, axis) += a(axis, axis) == 0.0; // a grid one cell thick
    }
    const Eigen::Vector3d g = a.ldlt().solve(this->B);
    return { { g[0], g[1], g[2] } };
  }

private:
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d B = Eigen::Vector3d::Zero();
};

} // namespace vfm
