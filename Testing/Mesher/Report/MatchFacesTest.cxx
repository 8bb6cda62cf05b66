/// Data behind faces, and the points shared by ranks, for any distribution.
#include "Report/MatchFaces.h"
#include "Report/SharedPoints.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr int Cells[3] = { 5, 4, 3 };
constexpr Index Shift = Index(1) << 61; // ids that doubles cannot represent

/// A cube of a grid: its place, and the value behind its faces.
struct Cube
{
  int Place[3];
  int Value;
  int Rank;
};

Index PointId(int x, int y, int z)
{
  return Shift + x + (Cells[0] + 1) * (y + (Cells[1] + 1) * z);
}

int Number(const int* place)
{
  return place[0] + Cells[0] * (place[1] + Cells[1] * place[2]);
}

/// Returns cubes with random values on random ranks; the last rank has no cube.
std::vector<Cube> MakeCubes(int count)
{
  std::mt19937 random(7);
  std::vector<Cube> cubes;
  for (int z = 0; z < Cells[2]; ++z)
  {
    for (int y = 0; y < Cells[1]; ++y)
    {
      for (int x = 0; x < Cells[0]; ++x)
      {
        const int value = static_cast<int>(random() % 3);
        const int rank = static_cast<int>(random() % std::max(count - 1, 1));
        cubes.push_back({ { x, y, z }, value, rank });
      }
    }
  }
  return cubes;
}

FaceIds IdsOf(const Cube& cube, int axis, int end)
{
  FaceIds ids{};
  for (int corner = 0; corner < 4; ++corner)
  {
    int place[3] = { cube.Place[0], cube.Place[1], cube.Place[2] };
    place[axis] += end;
    place[(axis + 1) % 3] += corner & 1;
    place[(axis + 2) % 3] += corner >> 1;
    ids[corner] = PointId(place[0], place[1], place[2]);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

int ValueBehind(const std::vector<Cube>& cubes, const Cube& cube, int axis, int end)
{
  int place[3] = { cube.Place[0], cube.Place[1], cube.Place[2] };
  place[axis] += 2 * end - 1;
  return place[axis] < 0 || place[axis] >= Cells[axis] ? NothingBehind : cubes[Number(place)].Value;
}

/// Returns the messages of all ranks if the faces of the list are distributed to the ranks in turn.
std::vector<std::string> MessagesOf(const std::vector<FaceIds>& faces, int count)
{
  std::vector<std::string> messages(count);
  RunOnRanks(count,
    [&](Ranks& ranks)
    {
      std::vector<FaceIds> mine;
      for (std::size_t f = ranks.Rank(); f < faces.size(); f += count)
      {
        mine.push_back(faces[f]);
      }
      try
      {
        MatchFaces(mine, std::vector<Index>(mine.size(), 1), ranks);
      }
      catch (const InputError& error)
      {
        messages[ranks.Rank()] = error.what();
      }
    });
  return messages;
}

} // namespace

TEST(MatchFaces, CubesOfAGrid)
{
  for (int count : { 1, 2, 3, 8 })
  {
    const std::vector<Cube> cubes = MakeCubes(count);
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        std::vector<FaceIds> faces;
        std::vector<Index> values, expected;
        for (const Cube& cube : cubes)
        {
          for (int f = 0; f < 6 && cube.Rank == ranks.Rank(); ++f)
          {
            faces.push_back(IdsOf(cube, f / 2, f % 2));
            values.push_back(cube.Value);
            expected.push_back(ValueBehind(cubes, cube, f / 2, f % 2));
          }
        }
        EXPECT_EQ(MatchFaces(faces, values, ranks), expected) << count << ", " << ranks.Rank();
        std::vector<Index> pairs, expectedPairs; // two values per face
        for (std::size_t f = 0; f < faces.size(); ++f)
        {
          pairs.insert(pairs.end(), { values[f], Shift - values[f] });
          const Index behind = expected[f];
          expectedPairs.insert(expectedPairs.end(),
            { behind, behind == NothingBehind ? NothingBehind : Shift - behind });
        }
        EXPECT_EQ(MatchFaces(faces, pairs, ranks, 2), expectedPairs);
      });
  }
}

TEST(MatchFaces, TrianglesAreNoQuadrilaterals)
{
  Ranks alone;
  const std::vector<FaceIds> faces{ { { -1, 2, 3, 4 } }, { { 1, 2, 3, 4 } }, { { -1, 2, 3, 4 } } };
  EXPECT_EQ(MatchFaces(faces, { 5, 6, 7 }, alone), (std::vector<Index>{ 7, NothingBehind, 5 }));
}

TEST(MatchFaces, ThreeElementsAreRejectedOnEveryRank)
{
  const FaceIds good{ { 1, 2, 3, 4 } }, bad{ { 2, 3, 4, 5 } };
  for (int count : { 1, 3, 4 })
  {
    const std::vector<std::string> messages = MessagesOf({ good, bad, bad, bad, good }, count);
    for (const std::string& message : messages)
    {
      EXPECT_NE(message.find("points 3, 4, 5 belongs to more than two"), std::string::npos)
        << message;
    }
    for (const std::string& message : MessagesOf({ good, bad, bad, good }, count))
    {
      EXPECT_EQ(message, "");
    }
  }
}

TEST(SharedPoints, AreMutualAndOwnedOnce)
{
  for (int count : { 1, 2, 3, 8 })
  {
    // Each point is on some ranks, in a different order on each rank; some points
    // are on no rank, one is on all.
    std::mt19937 random(11);
    std::vector<std::vector<Index>> ids(count);
    std::map<Index, std::set<int>> ranksOf;
    for (Index point = 0; point < 200; ++point)
    {
      for (int rank = 0; rank < count; ++rank)
      {
        if (point == 17 || random() % 3 == 0)
        {
          ids[rank].push_back(Shift + 3 * point);
          ranksOf[Shift + 3 * point].insert(rank);
        }
      }
    }
    for (std::vector<Index>& some : ids)
    {
      std::shuffle(some.begin(), some.end(), random);
    }
    std::vector<SharedPoints> shared(count);
    RunOnRanks(count,
      [&](Ranks& ranks) { shared[ranks.Rank()] = FindSharedPoints(ids[ranks.Rank()], ranks); });
    for (int rank = 0; rank < count; ++rank)
    {
      std::map<int, std::vector<Index>> expected, found;
      std::vector<Index> sorted = ids[rank];
      std::sort(sorted.begin(), sorted.end());
      for (Index id : sorted)
      {
        for (int other : ranksOf[id])
        {
          if (other != rank)
          {
            expected[other].push_back(id);
          }
        }
      }
      for (const auto& entry : shared[rank].Places)
      {
        for (Index place : entry.second)
        {
          found[entry.first].push_back(ids[rank][place]);
        }
      }
      EXPECT_EQ(found, expected) << count << " ranks, rank " << rank;
      for (std::size_t p = 0; p < ids[rank].size(); ++p)
      {
        EXPECT_EQ(shared[rank].IsOwned[p] != 0, *ranksOf[ids[rank][p]].begin() == rank);
      }
    }
  }
}
