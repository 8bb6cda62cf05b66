/// Neighbours over faces, edges and corners, found from the face neighbours.
#include "Input/FindNeighbours.h"
#include "Base/Runtime.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr Index3 Layout{ { 4, 3, 3 } };
constexpr int Count = 36;

Index3 Place(int rank)
{
  return { { rank % Layout[0], rank / Layout[0] % Layout[1], rank / (Layout[0] * Layout[1]) } };
}

/// Returns the box of a rank in a regular layout, and the ranks across its faces.
RankBox BoxOf(int rank)
{
  RankBox box{ rank, {}, {} };
  for (int a = 0; a < 3; ++a)
  {
    box.Lower[a] = 0.1 * static_cast<double>(Place(rank)[a]);
    box.Upper[a] = 0.1 * static_cast<double>(Place(rank)[a] + 1);
  }
  return box;
}

std::array<int, 6> FacesOf(int rank)
{
  std::array<int, 6> faces;
  int stride = 1;
  for (int a = 0; a < 3; ++a)
  {
    faces[2 * a] = Place(rank)[a] > 0 ? rank - stride : -1;
    faces[2 * a + 1] = Place(rank)[a] + 1 < Layout[a] ? rank + stride : -1;
    stride *= static_cast<int>(Layout[a]);
  }
  return faces;
}

/// Returns the message on every rank if the faces of one rank are changed.
std::vector<std::string> MessagesWith(int rank, int face, int wrong)
{
  std::vector<std::string> messages(Count);
  RunOnRanks(Count,
    [&](Ranks& ranks)
    {
      std::array<int, 6> faces = FacesOf(ranks.Rank());
      if (ranks.Rank() == rank)
      {
        faces[face] = wrong;
      }
      try
      {
        FindNeighbours(BoxOf(ranks.Rank()), faces, ranks);
      }
      catch (const InputError& error)
      {
        messages[ranks.Rank()] = error.what();
      }
    });
  return messages;
}

} // namespace

TEST(FindNeighbours, AllThatTouch)
{
  std::vector<std::vector<RankBox>> found(Count);
  RunOnRanks(Count,
    [&](Ranks& ranks)
    { found[ranks.Rank()] = FindNeighbours(BoxOf(ranks.Rank()), FacesOf(ranks.Rank()), ranks); });
  for (int rank = 0; rank < Count; ++rank)
  {
    std::vector<int> expected, got;
    for (int other = 0; other < Count; ++other)
    {
      Index farthest = 0;
      for (int a = 0; a < 3; ++a)
      {
        farthest = std::max(farthest, std::abs(Place(rank)[a] - Place(other)[a]));
      }
      if (farthest == 1)
      {
        expected.push_back(other);
      }
    }
    for (const RankBox& box : found[rank])
    {
      got.push_back(box.Rank);
      EXPECT_EQ(box.Lower, BoxOf(box.Rank).Lower);
    }
    EXPECT_EQ(got, expected) << "rank " << rank;
  }
}

TEST(FindNeighbours, ReachOverThinBoxes)
{
  constexpr int slabs = 9;
  const auto slab = [](int rank) {
    return RankBox{ rank, { { 0, 0, 2.0 * rank } }, { { 9, 9, 2.0 * rank + 2 } } };
  };
  RunOnRanks(slabs,
    [&](Ranks& ranks)
    {
      const int rank = ranks.Rank();
      const std::array<int, 6> faces{ { -1, -1, -1, -1, rank - 1,
        rank + 1 < slabs ? rank + 1 : -1 } };
      std::vector<int> expected, got;
      for (int other = 0; other < slabs; ++other)
      {
        // a distance of 6 reaches over three slabs
        if (other != rank && std::abs(other - rank) <= 4)
        {
          expected.push_back(other);
        }
      }
      for (const RankBox& box : FindNeighbours(slab(rank), faces, ranks, 6.0))
      {
        got.push_back(box.Rank);
      }
      EXPECT_EQ(got, expected) << "rank " << rank;
    });
}

TEST(FindNeighbours, WrongNeighboursAreRejectedOnEveryRank)
{
  for (const std::string& message : MessagesWith(5, 1, 99))
  {
    EXPECT_NE(message.find("Rank 5 names 99"), std::string::npos) << message;
  }
  for (const std::string& message : MessagesWith(5, 1, -1))
  {
    EXPECT_NE(message.find("does not name it"), std::string::npos) << message;
  }
}
