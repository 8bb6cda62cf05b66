/// Sets of lattice nodes near a cell, compared with all nodes and lattice tets one by one.
#include "Elements/Tet/LatticeNear.h"
#include "RandomDraw.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Twice the coordinates of a node: even at vertices, odd at centres, from 0 to 6.
using Place = std::array<int, 3>;
using Places = std::set<Place>;

std::uint64_t BitOf(const Place& p)
{
  return std::uint64_t(1) << (p[0] / 2 + 4 * (p[1] / 2) + 16 * (p[2] / 2));
}

NearNodes Pack(const Places& places)
{
  NearNodes nodes;
  for (const Place& p : places)
  {
    (p[0] % 2 ? nodes.Centres : nodes.Vertices) |= BitOf(p);
  }
  return nodes;
}

void ExpectEqual(const NearNodes& a, const NearNodes& b)
{
  EXPECT_TRUE(IsSubset(a, b) && IsSubset(b, a));
}

Places AllPlaces()
{
  Places all;
  for (int k = 0; k < 7; ++k)
  {
    for (int j = k % 2; j < 7; j += 2)
    {
      for (int i = k % 2; i < 7; i += 2)
      {
        all.insert({ { i, j, k } });
      }
    }
  }
  return all;
}

bool ShareEdge(const Place& a, const Place& b)
{
  int sum = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    sum += std::abs(a[axis] - b[axis]);
  }
  const bool sameKind = a[0] % 2 == b[0] % 2;
  return sameKind ? sum == 2 : sum == 3 && std::abs(a[0] - b[0]) == 1 && std::abs(a[1] - b[1]) == 1;
}

/// Lists the lattice tets of a body-centred lattice: two centres that share an edge, and two
/// vertices that share an edge with each other and with both.
std::vector<Places> ListTets()
{
  std::vector<Places> tets;
  const Places all = AllPlaces();
  for (const Place& c : all)
  {
    for (const Place& d : all)
    {
      for (const Place& v : all)
      {
        for (const Place& w : all)
        {
          if (c[0] % 2 && d[0] % 2 && v[0] % 2 == 0 && w[0] % 2 == 0 && c < d && v < w &&
            ShareEdge(c, d) && ShareEdge(v, w) && ShareEdge(c, v) && ShareEdge(c, w) &&
            ShareEdge(d, v) && ShareEdge(d, w))
          {
            tets.push_back({ c, d, v, w });
          }
        }
      }
    }
  }
  return tets;
}

Places Connected(Places from, const Places& set)
{
  for (bool grows = true; grows;)
  {
    grows = false;
    for (const Place& p : set)
    {
      grows =
        (std::any_of(from.begin(), from.end(), [&](const Place& q) { return ShareEdge(p, q); }) &&
          from.insert(p).second) ||
        grows;
    }
  }
  return from;
}

Places Draw(RandomDraw& draw, double chance)
{
  Places chosen;
  for (const Place& p : AllPlaces())
  {
    if (draw.Chance(chance))
    {
      chosen.insert(p);
    }
  }
  return chosen;
}

bool MeetOneByOne(
  const std::vector<Places>& tets, const Places& a, const Places& b, const Places& snapped)
{
  std::map<Places, std::vector<Place>> fourth; // by triangle of snapped nodes
  for (const Places& tet : tets)
  {
    for (const Place& node : tet)
    {
      Places triangle = tet;
      triangle.erase(node);
      if (std::includes(snapped.begin(), snapped.end(), triangle.begin(), triangle.end()))
      {
        fourth[triangle].push_back(node);
      }
    }
  }
  return std::any_of(fourth.begin(), fourth.end(),
    [&](const auto& entry)
    {
      const std::vector<Place>& ends = entry.second;
      return ends.size() == 2 &&
        ((a.count(ends[0]) && b.count(ends[1])) || (a.count(ends[1]) && b.count(ends[0])));
    });
}

} // namespace

TEST(LatticeNear, NeighboursAndConnections)
{
  RandomDraw draw(1);
  for (int round = 0; round < 50; ++round)
  {
    const Places some = Draw(draw, 0.03), set = Draw(draw, 0.3);
    Places around;
    for (const Place& p : AllPlaces())
    {
      if (std::any_of(some.begin(), some.end(), [&](const Place& q) { return ShareEdge(p, q); }))
      {
        around.insert(p);
      }
    }
    ExpectEqual(NeighboursOf(Pack(some)), Pack(around));
    ExpectEqual(ConnectedTo(Pack(some), Pack(set)), Pack(Connected(some, set)));
  }
  const Place across[6] = { { { 1, 3, 3 } }, { { 5, 3, 3 } }, { { 3, 1, 3 } }, { { 3, 5, 3 } },
    { { 3, 3, 1 } }, { { 3, 3, 5 } } };
  ExpectEqual(MiddleCentre(), Pack({ { { 3, 3, 3 } } }));
  for (int face = 0; face < 6; ++face)
  {
    ExpectEqual(CentreAcross(face), Pack({ across[face] }));
  }
}

TEST(LatticeNear, TriangleOfSnappedNodes)
{
  const std::vector<Places> tets = ListTets();
  EXPECT_EQ(tets.size(), 54u * 4u); // four at each face between two cells
  RandomDraw draw(2);
  int met = 0;
  for (int round = 0; round < 400; ++round)
  {
    Places snapped, a, b;
    for (const Place& p : AllPlaces())
    {
      const int kind = draw.Whole(0, 9);
      (kind < 4 ? snapped : kind == 4 ? a : b).insert(p);
    }
    const bool meet = MeetOneByOne(tets, a, b, snapped);
    met += meet;
    EXPECT_EQ(MeetAtTriangle(Pack(a), Pack(b), Pack(snapped)), meet) << "round " << round;
  }
  EXPECT_GT(met, 20);
  EXPECT_LT(met, 380);
}
