#include "Mesh/TetQuality.h"

#include "Base/Vector3.h"

#include <algorithm>

namespace vfm
{
namespace
{

/// Ends of the edges; edge 5 - e is opposite to edge e.
constexpr int EdgeEnds[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };

struct TetShape
{
  Vector3 Edge[6];
  double Determinant; // 6 V
};

TetShape ShapeOf(const double* points, const Index* tet)
{
  TetShape shape;
  for (int e = 0; e < 6; ++e)
  {
    const double* from = points + 3 * tet[EdgeEnds[e][0]];
    const double* to = points + 3 * tet[EdgeEnds[e][1]];
    shape.Edge[e] = { { to[0] - from[0], to[1] - from[1], to[2] - from[2] } };
  }
  shape.Determinant = Dot(shape.Edge[0], Cross(shape.Edge[1], shape.Edge[2]));
  return shape;
}

} // namespace

double TetScaledJacobian(const double* points, const Index* tet)
{
  const TetShape shape = ShapeOf(points, tet);
  double product[4] = { 1.0, 1.0, 1.0, 1.0 };
  for (int e = 0; e < 6; ++e)
  {
    const double length = Norm(shape.Edge[e]);
    product[EdgeEnds[e][0]] *= length;
    product[EdgeEnds[e][1]] *= length;
  }
  const double largest = *std::max_element(product, product + 4);
  return largest > 0.0 ? std::sqrt(2.0) * shape.Determinant / largest : 0.0;
}

void DihedralAngles(const double* points, const Index* tet, double angles[6])
{
  const TetShape shape = ShapeOf(points, tet);
  const Vector3* edge = shape.Edge;
  // outwards, or all inwards: of the faces opposite to corners 0..3
  const Vector3 normal[4] = { Cross(edge[3], edge[4]), Cross(edge[2], edge[1]),
    Cross(edge[0], edge[2]), Cross(edge[1], edge[0]) };
  const double degrees = 180.0 / std::acos(-1.0);
  for (int e = 0; e < 6; ++e)
  {
    // the faces at an edge are those opposite to the ends of the other edge; |n x m| = 6 |V| l.
    // 0 - 0 is +0, where the angle is 0
    const int* ends = EdgeEnds[5 - e];
    angles[e] = degrees *
      std::atan2(
        std::abs(shape.Determinant) * Norm(edge[e]), 0.0 - Dot(normal[ends[0]], normal[ends[1]]));
  }
}

} // namespace vfm
