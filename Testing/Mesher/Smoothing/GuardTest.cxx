/// Points go back with two rings around, and only elements at points that have moved are checked.
#include "Smoothing/Guard.h"
#include "Base/ThreadRuntime.h"
#include "Cells/HexBlock.h"
#include "Smoothing/ForFlagged.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr int Points = 15; // of the block, along each axis
constexpr int Center = (Points * Points * Points - 1) / 2;

/// Elements with a point far above the block are lost.
class Ceiling : public ElementEnergy
{
public:
  double Evaluate(const ActiveMesh&, int, const Vector3&, const SmoothingStage&) const override
  {
    return 0.0;
  }
  Derivatives Differentiate(const ActiveMesh&, int, const SmoothingStage&) const override
  {
    return {};
  }
  bool MarkLost(const ActiveMesh& mesh, Runtime&, const std::vector<unsigned char>&,
    const std::vector<unsigned char>& where, std::vector<unsigned char>& points) const override
  {
    this->Where.push_back(where);
    bool isFound = false;
    for (std::size_t hex = 0; hex < mesh.Elements.size() / 8; ++hex)
    {
      const int* corners = mesh.Elements.data() + 8 * hex;
      const auto isLost = [&](int p) { return mesh.X[p][2] > this->Height; };
      for (int c = 0; std::any_of(corners, corners + 8, isLost) && c < 8; ++c)
      {
        points[corners[c]] = 1;
        isFound = true;
      }
    }
    return isFound;
  }

  double Height = 100.0;
  mutable std::vector<std::vector<unsigned char>> Where; // of each call
};

/// Returns how many steps along edges and diagonals lead from the centre to a point.
int StepsTo(int p)
{
  int steps = 0;
  for (int n : { p % Points, p / Points % Points, p / Points / Points })
  {
    steps = std::max(steps, std::abs(n - Points / 2));
  }
  return steps;
}

} // namespace

TEST(Guard, PutsBackLostElementsAndTwoRings)
{
  ActiveMesh mesh = MakeHexBlock(Points);
  const std::vector<Vector3> before = mesh.X;
  for (Vector3& x : mesh.X)
  {
    x[0] += 0.25;
  }
  mesh.X[Center][2] = 200.0;
  const std::vector<Vector3> moved = mesh.X;
  Ceiling energy;
  ThreadRuntime runtime(3, nullptr);
  Guard guard(mesh, energy, runtime);
  ASSERT_TRUE(guard.PutBack(before, mesh.X));
  for (int p = 0; p < static_cast<int>(before.size()); ++p)
  {
    EXPECT_EQ(guard.Returned()[p], StepsTo(p) <= 3) << p; // one step to the points of lost hexes
    EXPECT_EQ(mesh.X[p], StepsTo(p) <= 3 ? before[p] : moved[p]) << p;
    EXPECT_EQ(guard.Has(p), StepsTo(p) <= 5) << p;
  }
  EXPECT_FALSE(guard.PutBack(before, mesh.X));
}

TEST(Guard, PointsThatDoNotMoveStay)
{
  ActiveMesh mesh = MakeHexBlock(Points);
  mesh.IsActive[Center + 1] = 0;
  const std::vector<Vector3> before = mesh.X;
  mesh.X[Center][2] = 200.0;
  mesh.X[Center + 1][0] += 0.25;
  Ceiling energy;
  Runtime serial;
  Guard guard(mesh, energy, serial);
  ASSERT_TRUE(guard.PutBack(before, mesh.X));
  EXPECT_EQ(mesh.X[Center], before[Center]);
  EXPECT_NE(mesh.X[Center + 1], before[Center + 1]);
}

TEST(Guard, LooksOnlyAtPointsThatMovedOrWereLost)
{
  ActiveMesh mesh = MakeHexBlock(Points);
  const std::vector<Vector3> before = mesh.X;
  Ceiling energy;
  Runtime serial;
  Guard guard(mesh, energy, serial);
  std::vector<unsigned char> moved(mesh.X.size(), 0);
  EXPECT_FALSE(guard.PutBack(before, mesh.X));
  EXPECT_TRUE(energy.Where.back().empty()); // all points
  moved[Center] = 1;
  guard.NoteMoved(moved);
  mesh.X[Center][2] = 200.0;
  EXPECT_TRUE(guard.PutBack(before, mesh.X));
  ASSERT_EQ(energy.Where.size(), 3u);
  EXPECT_EQ(energy.Where[1], moved);
  EXPECT_EQ(energy.Where[2], guard.Returned()); // all others are as before
  EXPECT_FALSE(guard.PutBack(before, mesh.X));
  for (int p = 0; p < static_cast<int>(before.size()); ++p)
  {
    EXPECT_EQ(energy.Where[3][p], StepsTo(p) <= 1) << p; // points of the lost hexes
  }
  EXPECT_FALSE(guard.PutBack(before, mesh.X));
  EXPECT_EQ(energy.Where[4], std::vector<unsigned char>(mesh.X.size(), 0));
}

TEST(ForFlagged, VisitsFlagsOfAnyRange)
{
  std::vector<unsigned char> flags(100, 0);
  for (int i : { 0, 7, 8, 40, 41, 63, 98, 99 })
  {
    flags[i] = 1;
  }
  for (Index first = 0; first <= 100; ++first)
  {
    for (Index last = first; last <= 100; ++last)
    {
      std::vector<Index> found, right;
      ForFlagged(flags, first, last, [&](Index i) { found.push_back(i); });
      for (Index i = first; i < last; ++i)
      {
        if (flags[i])
        {
          right.push_back(i);
        }
      }
      ASSERT_EQ(found, right) << first << " " << last;
    }
  }
}
