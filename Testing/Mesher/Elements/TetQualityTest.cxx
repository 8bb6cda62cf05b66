#include "Elements/TetQuality.h"
#include "Base/Vector3.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace vfm;

namespace
{

const double Degrees = 180.0 / std::acos(-1.0);

struct Quality
{
  double ScaledJacobian;
  double Angles[6];
};

/// Measures a tet whose corners are spread among other points.
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
  for (double size : { 1e-48, 1e-6, 1.0, 1e6, 1e48 })
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
  // The corners off the origin have edges 1, sqrt 2, sqrt 2.
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
  // A prism over a triangle with known angles, seen along edge 0 1, for each
  // even permutation of the corners.
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

  // A square has 180 degrees at its diagonals, 0 at its sides.
  const Quality flat = QualityOf(O, X, X + Y, Y);
  EXPECT_EQ(flat.ScaledJacobian, 0.0);
  ExpectAngles(flat, { { 0.0, 180.0, 0.0, 0.0, 180.0, 0.0 } });

  const Quality point = QualityOf(X, X, X, X);
  EXPECT_EQ(point.ScaledJacobian, 0.0);
  ExpectAngles(point, { { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 } });
}

namespace
{

/// Computes the result expected of MeasureTets tet by tet.
AngleStatistics Expected(const std::vector<double>& points, const std::vector<Index>& tets)
{
  AngleStatistics all;
  for (std::size_t t = 0; t < tets.size(); t += 4)
  {
    double angles[6];
    DihedralAngles(points.data(), tets.data() + t, angles);
    for (double angle : angles)
    {
      all.Smallest = std::min(all.Smallest, angle);
      all.Largest = std::max(all.Largest, angle);
      ++all.Counts[std::min(static_cast<int>((angle + 1e-6) / 10.0), 17)];
    }
  }
  return all;
}

void ExpectMeasured(const std::vector<double>& points, const std::vector<Index>& tets)
{
  const Index count = static_cast<Index>(tets.size()) / 4;
  std::vector<float> quality(count + 1, 7.0f);
  const AngleStatistics all = MeasureTets(points.data(), tets.data(), count, quality.data());
  const AngleStatistics expected = Expected(points, tets);
  EXPECT_EQ(all.Counts, expected.Counts);
  EXPECT_NEAR(all.Smallest, expected.Smallest, 1e-10);
  EXPECT_NEAR(all.Largest, expected.Largest, 1e-10);
  for (Index t = 0; t < count; ++t)
  {
    EXPECT_EQ(
      quality[t], static_cast<float>(TetScaledJacobian(points.data(), tets.data() + 4 * t)));
  }
  EXPECT_EQ(quality[count], 7.0f);
}

} // namespace

TEST(TetQuality, OfManyTetsIsThatOfEach)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  for (Index count : { 0, 1, 2, 3, 4, 5, 400 })
  {
    std::vector<double> points;
    std::vector<Index> tets;
    for (Index p = 0; p < 4 * count; ++p)
    {
      // all shapes, from needles to plates
      const double flat[3] = { 1.0, std::pow(10.0, -p / 4 % 7), std::pow(10.0, -p / 28 % 7) };
      for (double size : flat)
      {
        points.push_back(size * place(random));
      }
      tets.push_back(p);
    }
    for (double unit : { 1.0, 1e-40, 1e48 })
    {
      std::vector<double> scaled(points);
      for (double& x : scaled)
      {
        x *= unit;
      }
      ExpectMeasured(scaled, tets);
    }
  }
}

TEST(TetQuality, OfManyTetsKnowsFlatOnes)
{
  const std::vector<double> points{ 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 0.3,
    0.2, 0.7 };
  ExpectMeasured(points, { 0, 1, 2, 4, 0, 1, 2, 3, 1, 1, 2, 4, 0, 0, 0, 0, 0, 2, 1, 4 });
}

TEST(TetQuality, AnglesAtALimitCountAboveIt)
{
  // Tets of the lattice have 60 and 90 degrees, whatever the rounding.
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  std::vector<double> points;
  std::vector<Index> tets;
  for (Index t = 0; t < 100; ++t)
  {
    const Vector3 origin{ { place(random), place(random), place(random) } };
    const double size = 1.0 + place(random) / 3.0;
    for (const Vector3& x : { O, X, Vector3{ { 0.5, 0.5, 0.5 } }, Vector3{ { 0.5, -0.5, 0.5 } } })
    {
      const Vector3 p = origin + size * x;
      points.insert(points.end(), p.begin(), p.end());
      tets.push_back(static_cast<Index>(tets.size()));
    }
  }
  std::vector<float> quality(100);
  const AngleStatistics all = MeasureTets(points.data(), tets.data(), 100, quality.data());
  EXPECT_EQ(all.Counts[6], 400);
  EXPECT_EQ(all.Counts[9], 200);
}
