/// Lists that give back their values.
#include "Smoothing/Hex/PackedLists.h"

#include "Base/HexNumbering.h"
#include "Base/ThreadRuntime.h"
#include "Smoothing/Hex/ActiveCorners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

using namespace vfm;

namespace
{

template <class T>
void ExpectEqual(const std::vector<T>& numbers)
{
  Buffer<T> packed(numbers.size());
  std::copy(numbers.begin(), numbers.end(), packed.begin());
  const PackedArray<T> some(packed);
  EXPECT_TRUE(packed.empty());
  const Buffer<T> back = some.Unpack();
  EXPECT_EQ(std::vector<T>(back.begin(), back.end()), numbers);
}

TEST(PackedLists, ReturnEqualNumbers)
{
  std::mt19937 engine(1);
  std::vector<Index> ids{ 5, 6, 133, 134, 40000, 3 };
  for (Index id = Index(1) << 40; ids.size() < 1000; id += 1 + (engine() >> engine() % 32))
  {
    ids.push_back(id);
  }
  ExpectEqual(ids);
  std::vector<int> numbers{ 0, 63, 127, 63, 0, -1, -65, -129, 2147483647, -2147483647 - 1, 7 };
  while (numbers.size() < 1000)
  {
    numbers.push_back(static_cast<int>(engine()) >> engine() % 32);
  }
  ExpectEqual(numbers);
  ExpectEqual(std::vector<int>());
}

TEST(PackedLists, ReturnEqualFacets)
{
  const std::vector<Facet> facets{ { { { 7, 8, 2000000000, 9 } }, { { 3, 0 } }, { { 12, 0 } }, -1,
                                     true },
    { { { 1, 2, 3, 3 } }, { { 2, 3 } }, { { 4, 12 } }, -1, false },
    { { { 4, 5, 6, 7 } }, { { 2, 0 } }, { { 4, 0 } }, 5, true } };
  std::vector<Facet> packed = facets;
  const PackedFacets some(packed);
  EXPECT_TRUE(packed.empty());
  const std::vector<Facet> back = some.Unpack();
  ASSERT_EQ(back.size(), facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    EXPECT_EQ(back[f].Points, facets[f].Points);
    EXPECT_EQ(back[f].Materials, facets[f].Materials);
    EXPECT_EQ(back[f].Fragments, facets[f].Fragments);
    EXPECT_EQ(back[f].DomainSide, facets[f].DomainSide);
    EXPECT_EQ(back[f].IsOwned, facets[f].IsOwned);
  }
}

/// Takes the points of a mesh, of which the active mesh has every third one, and restores them.
/// @param count  number of points
/// @param values  number of different values of the coordinates
/// @param isCoded  whether these are few enough
void ExpectPointsRestored(int count, int values, bool isCoded)
{
  Buffer<double> points(3 * count);
  for (int i = 0; i < 3 * count; ++i)
  {
    points[i] = 0.1 * (i % values);
  }
  const std::vector<double> given(points.begin(), points.end());
  ActiveMesh active;
  for (int p = count - 1; p >= 0; p -= 3)
  {
    active.MeshPoint.push_back(p);
  }
  active.MeshPoints = points.data();
  active.Origin = { { 0.1, 0.2, 0.3 } };
  active.Scale = 0.7;
  const Vector3 start = active.StartOf(1000);
  const PackedPoints some(points, active);
  EXPECT_EQ(points.empty(), isCoded);
  EXPECT_EQ(active.StartOf(1000), start);
  some.Unpack(points, active);
  EXPECT_EQ(std::vector<double>(points.begin(), points.end()), given);
  EXPECT_EQ(active.MeshPoints, points.data());
  EXPECT_EQ(active.StartOf(1000), start);
}

TEST(PackedLists, ReturnEqualPoints)
{
  ExpectPointsRestored(80000, 100, true);
  ExpectPointsRestored(120000, 120000 * 3, false); // too many only for the other points
  ExpectPointsRestored(210000, 210000 * 3, false);
}

/// Takes the corners of 500 hexes, of which every n-th is not active, and restores them.
/// @param others  n
void ExpectRestored(int others)
{
  constexpr Index Hexes = 500;
  std::mt19937 engine(others);
  Mesh mesh;
  mesh.ResizeElements(Hexes);
  std::vector<Index> points(8 * Hexes);
  std::iota(points.begin(), points.end(), Index(0));
  std::shuffle(points.begin(), points.end(), engine);
  std::copy(points.begin(), points.end(), mesh.Elements.begin());
  ActiveMesh active;
  for (Index hex = 0; hex < Hexes; ++hex)
  {
    for (int c = 0; hex % others != 0 && c < 8; ++c)
    {
      active.Elements.push_back(static_cast<int>(active.MeshPoint.size()));
      active.MeshPoint.push_back(static_cast<int>(points[8 * hex + VtkCorner[c]]));
    }
  }
  const ActiveCorners corners(active, mesh);
  EXPECT_EQ(mesh.Elements.empty(), others > 1);
  ThreadRuntime runtime(3, nullptr);
  corners.Restore(active.Elements, active.MeshPoint, runtime, mesh);
  EXPECT_EQ(std::vector<Index>(mesh.Elements.begin(), mesh.Elements.end()), points);
}

TEST(ActiveCorners, RestoreAll)
{
  for (int others : { 1, 2, 7, 1000 })
  {
    ExpectRestored(others);
  }
}

} // namespace
