#include "Mesh/TetQuality.h"
#include "Base/Vector3.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace vfm;

namespace
{

const double Degrees = 180.0 / std::acos(-1.0);

struct Quality
{
  double ScaledJacobian;
  double Angles[6];
};

/// The corners stand among other points, not in order.
Quality QualityOf(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  const Vector3 other{ { 9.0, 9.0, 9.0 } };
  const Vector3 points[7] = { other, d, b, other, a, other, c };
  const Index tet[4] = { 4, 2, 6, 1 };
  Quality q;
  q.ScaledJacobian = TetScaledJacobian(points[0].data(), tet);
  DihedralAngles(points[0].data(), tet, q.Angles);
  return q;
}

void ExpectAngles(const Quality& q, const std::array<double, 6>& expected)
{
  for (int e = 0; e < 6; ++e)
  {
    EXPECT_NEAR(q.Angles[e], expected[e], 1e-12 * 180.0) << "edge " << e;
  }
}

const Vector3 O{ { 0.0, 0.0, 0.0 } }, X{ { 1.0, 0.0, 0.0 } }, Y{ { 0.0, 1.0, 0.0 } },
  Z{ { 0.0, 0.0, 1.0 } };

} // namespace

TEST(TetQuality, OfTheRegularTetIsOne)
{
  const double angle = std::acos(1.0 / 3.0) * Degrees;
  for (double size : { 1e-6, 1.0, 1e6 })
  {
    const Quality q =
      QualityOf(O, size * (X + Y), size * (Y + Z), size * (X + Z)); // every other corner of a cube
    EXPECT_NEAR(q.ScaledJacobian, 1.0, 1e-14);
    ExpectAngles(q, { { angle, angle, angle, angle, angle, angle } });
  }
}

TEST(TetQuality, OfTheCornerOfACube)
{
  const Quality q = QualityOf(O, X, Y, Z);
  // the corners off the origin have edges 1, sqrt 2, sqrt 2
  EXPECT_NEAR(q.ScaledJacobian, std::sqrt(0.5), 1e-15);
  const double angle = std::acos(std::sqrt(1.0 / 3.0)) * Degrees;
  ExpectAngles(q, { { 90.0, 90.0, 90.0, angle, angle, angle } });
}

TEST(TetQuality, OfTheBodyCentredLattice)
{
  // an edge of a cell and the centres of two cells at it
  const Quality q = QualityOf(O, X, { { 0.5, 0.5, 0.5 } }, { { 0.5, -0.5, 0.5 } });
  EXPECT_NEAR(q.ScaledJacobian, 2.0 * std::sqrt(2.0) / 3.0, 1e-15);
  ExpectAngles(q, { { 90.0, 60.0, 60.0, 60.0, 60.0, 90.0 } });
}

TEST(TetQuality, AnglesStandAtTheirEdges)
{
  // a prism over a triangle with known angles, seen along edge 0 1, for every even order of the corners
  const double obtuse = 130.0, height = 2.0;
  const Vector3 corners[4] = { O, height * Z, { { 1.5, 0.0, 0.7 } },
    { { std::cos(obtuse / Degrees), std::sin(obtuse / Degrees), 0.3 } } };
  EXPECT_NEAR(QualityOf(corners[0], corners[1], corners[2], corners[3]).Angles[0], obtuse, 1e-10);
  const int ends[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };
  std::array<int, 4> order{ { 0, 1, 2, 3 } };
  const double scaledJacobian =
    QualityOf(corners[0], corners[1], corners[2], corners[3]).ScaledJacobian;
  EXPECT_GT(scaledJacobian, 0.0);
  do
  {
    const Quality q =
      QualityOf(corners[order[0]], corners[order[1]], corners[order[2]], corners[order[3]]);
    for (int e = 0; e < 6; ++e)
    {
      if (order[ends[e][0]] + order[ends[e][1]] == 1)
      {
        EXPECT_NEAR(q.Angles[e], obtuse, 1e-10);
      }
    }
    EXPECT_NEAR(std::abs(q.ScaledJacobian), scaledJacobian, 1e-14);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(TetQuality, OfInvertedAndFlatTets)
{
  const double regular = std::acos(1.0 / 3.0) * Degrees;
  const Quality inverted = QualityOf(X + Y, O, Y + Z, X + Z);
  EXPECT_NEAR(inverted.ScaledJacobian, -1.0, 1e-14);
  ExpectAngles(inverted, { { regular, regular, regular, regular, regular, regular } });

  // a square: 180 degrees at its diagonals, 0 at its sides
  const Quality flat = QualityOf(O, X, X + Y, Y);
  EXPECT_EQ(flat.ScaledJacobian, 0.0);
  ExpectAngles(flat, { { 0.0, 180.0, 0.0, 0.0, 180.0, 0.0 } });

  const Quality point = QualityOf(X, X, X, X);
  EXPECT_EQ(point.ScaledJacobian, 0.0);
  ExpectAngles(point, { { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 } });
}
