#include "Elements/EqualFaces.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

using namespace vfm;

namespace
{

/// Returns the visited groups: points and numbers.
std::vector<std::pair<FaceIds, std::vector<Index>>> GroupsOf(const std::vector<FaceIds>& faces)
{
  std::vector<std::pair<FaceIds, std::vector<Index>>> groups;
  ForEqualFaces(
    faces.size(), [&faces](Index f) { return faces[f]; },
    [&groups](std::span<const NumberedFace> same)
    {
      groups.push_back({ same[0].Points, {} });
      for (const NumberedFace& face : same)
      {
        groups.back().second.push_back(face.Number);
      }
    });
  return groups;
}

} // namespace

TEST(EqualFaces, AreVisitedInTheOrderOfPointsAndNumbers)
{
  std::mt19937 random(5);
  for (const Index range : { 5, 40, 100000 }) // one to many faces per lowest point, gaps in ids
  {
    std::vector<FaceIds> faces;
    std::map<FaceIds, std::vector<Index>> expected;
    for (Index f = 0; f < 500; ++f)
    {
      FaceIds points{ { 0, 0, 0, f % 3 == 0 ? -1 : 0 } };
      for (int c = 0; c < (f % 3 == 0 ? 3 : 4); ++c)
      {
        points[c] = 1000 + static_cast<Index>(random() % range);
      }
      std::sort(points.begin(), points.end());
      faces.push_back(f % 7 == 6 ? faces[f - 5] : points);
      expected[faces.back()].push_back(f);
    }
    const std::vector<std::pair<FaceIds, std::vector<Index>>> sorted(
      expected.begin(), expected.end());
    EXPECT_EQ(GroupsOf(faces), sorted) << range;
  }
}

TEST(EqualFaces, NoFacesAreNotVisited)
{
  EXPECT_TRUE(GroupsOf({}).empty());
}
