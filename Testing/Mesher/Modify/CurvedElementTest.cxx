/// Volumes and coefficients of second-order elements.
#include "Modify/CurvedElement.h"

#include <gtest/gtest.h>

using namespace vfm;

namespace
{

/// Returns the nodes of the unit element, corners and middles of edges in VTK's order.
CurvedElement::Nodes UnitNodes(int corners)
{
  static constexpr int HexEdges[12][2] = { { 0, 1 }, { 1, 2 }, { 3, 2 }, { 0, 3 }, { 4, 5 },
    { 5, 6 }, { 7, 6 }, { 4, 7 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };
  static constexpr int TetEdges[6][2] = { { 0, 1 }, { 1, 2 }, { 0, 2 }, { 0, 3 }, { 1, 3 },
    { 2, 3 } };
  CurvedElement::Nodes nodes{};
  const std::array<Vector3, 4> quad{ { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 1, 0 } },
    { { 0, 1, 0 } } } };
  if (corners == 8)
  {
    for (int c = 0; c < 8; ++c)
    {
      nodes[c] = quad[c % 4] + Vector3{ { 0, 0, c / 4 * 1.0 } };
    }
    for (int e = 0; e < 12; ++e)
    {
      nodes[8 + e] = 0.5 * (nodes[HexEdges[e][0]] + nodes[HexEdges[e][1]]);
    }
    return nodes;
  }
  nodes[1] = quad[1];
  nodes[2] = quad[3];
  nodes[3] = { { 0, 0, 1 } };
  for (int e = 0; e < 6; ++e)
  {
    nodes[4 + e] = 0.5 * (nodes[TetEdges[e][0]] + nodes[TetEdges[e][1]]);
  }
  return nodes;
}

template <class Map>
CurvedElement::Nodes MapNodes(int corners, const Map& map)
{
  CurvedElement::Nodes nodes = UnitNodes(corners);
  std::transform(nodes.begin(), nodes.end(), nodes.begin(), map);
  return nodes;
}

} // namespace

TEST(CurvedElement, AffineElementsHaveOneCoefficient)
{
  const auto map = [](const Vector3& x) {
    return Vector3{ { 2 * x[0] + x[1], 3 * x[1] - 0.5 * x[2] + 1, 0.5 * x[2] + 0.2 * x[0] } };
  };
  const double determinant = 2 * 3 * 0.5 + 0.2 * (1 * -0.5);
  for (int corners : { 8, 4 })
  {
    const CurvedElement& element = GetCurvedElement(corners);
    EXPECT_EQ(element.NodeCount(), corners == 8 ? 20 : 10);
    const CurvedElement::Nodes nodes = MapNodes(corners, map);
    EXPECT_NEAR(element.SmallestCoefficient(nodes), determinant, 1e-11);
    EXPECT_NEAR(element.Volume(nodes), corners == 8 ? determinant : determinant / 6.0, 1e-12);
  }
}

TEST(CurvedElement, QuadraticMapsHaveTheirExactVolume)
{
  const auto bulge = [](const Vector3& x) {
    return Vector3{ { x[0], x[1], x[2] * (1.0 + 0.6 * x[0] * (1.0 - x[0])) } };
  };
  const CurvedElement::Nodes hex = MapNodes(8, bulge);
  EXPECT_NEAR(GetCurvedElement(8).Volume(hex), 1.0 + 0.6 / 6.0, 1e-12);
  EXPECT_NEAR(GetCurvedElement(8).SmallestCoefficient(hex), 1.0, 1e-11);
  for (double a : { 0.4, -0.3, -0.6 }) // Jacobian 1 + 2 a x
  {
    const auto stretch = [a](const Vector3& x) {
      return Vector3{ { x[0] + a * x[0] * x[0], x[1], x[2] } };
    };
    const CurvedElement::Nodes tet = MapNodes(4, stretch);
    EXPECT_NEAR(GetCurvedElement(4).Volume(tet), 1.0 / 6.0 + a / 12.0, 1e-13);
    EXPECT_NEAR(GetCurvedElement(4).SmallestCoefficient(tet), std::min(1.0, 1.0 + 2.0 * a), 1e-12);
  }
}
