#include "Labels/LabelCondition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <vector>

using namespace vfm;

namespace
{

using Star = std::array<int, 8>;

/// Returns the 48 symmetries of the cube as permutations of the cells of a star.
std::vector<Star> CubeSymmetries()
{
  std::vector<Star> all;
  std::array<int, 3> axes{ { 0, 1, 2 } };
  do
  {
    for (int mirror = 0; mirror < 8; ++mirror)
    {
      Star map;
      for (int c = 0; c < 8; ++c)
      {
        map[c] = 0;
        for (int a = 0; a < 3; ++a)
        {
          map[c] |= ((c ^ mirror) >> a & 1) << axes[a];
        }
      }
      all.push_back(map);
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  return all;
}

/// Returns whether the cells of a region are connected over faces.
bool IsFaceConnected(int region)
{
  int reached = region & -region;
  for (int step = 0; step < 8; ++step)
  {
    for (int c = 0; c < 8; ++c)
    {
      for (int a = 0; a < 3 && (reached >> c & 1); ++a)
      {
        reached |= region & 1 << (c ^ 1 << a);
      }
    }
  }
  return reached == region;
}

/// Renumbers labels in the order of their first cell.
Star Canonical(const Star& star)
{
  Star result;
  std::vector<int> seen;
  for (int c = 0; c < 8; ++c)
  {
    const auto at = std::find(seen.begin(), seen.end(), star[c]);
    result[c] = static_cast<int>(at - seen.begin());
    if (at == seen.end())
    {
      seen.push_back(star[c]);
    }
  }
  return result;
}

/// Calls body with every set partition of the eight cells (restricted growth strings).
template <class Body>
void ForPartitions(Star& star, int cell, int labels, const Body& body)
{
  if (cell == 8)
  {
    body(star, labels);
    return;
  }
  for (int label = 0; label <= labels; ++label)
  {
    star[cell] = label;
    ForPartitions(star, cell + 1, std::max(labels, label + 1), body);
  }
}

} // namespace

TEST(LabelCondition, TwoLabelStars)
{
  int manifold = 0, passing = 0;
  std::vector<int> manifoldOnly;
  for (int region = 1; region < 255; ++region)
  {
    const bool connected = IsFaceConnected(region) && IsFaceConnected(255 ^ region);
    const bool unate = RegionNormalsTable[region].ViolatedAxes() == 0;
    EXPECT_EQ(unate, RegionNormalsTable[255 ^ region].ViolatedAxes() == 0);
    EXPECT_TRUE(connected || !unate) << region;
    manifold += connected;
    passing += unate;
    if (connected && !unate)
    {
      manifoldOnly.push_back(region);
    }
  }
  EXPECT_EQ(manifold, 126);
  EXPECT_EQ(passing, 102);
  ASSERT_EQ(manifoldOnly.size(), 24u);
  // all of them are images of the path 000-100-110-111
  std::set<int> images;
  for (const Star& map : CubeSymmetries())
  {
    images.insert(1 << map[0] | 1 << map[1] | 1 << map[3] | 1 << map[7]);
  }
  EXPECT_EQ(std::vector<int>(images.begin(), images.end()), manifoldOnly);
}

TEST(LabelCondition, SetPartitions)
{
  const std::vector<Star> symmetries = CubeSymmetries();
  int all = 0, passing = 0;
  std::set<Star> classes;
  Star star{};
  ForPartitions(star, 0, 0,
    [&](const Star& labels, int count)
    {
      ++all;
      if (count < 3 || CountViolations(labels) != 0)
      {
        return;
      }
      ++passing;
      Star smallest = labels;
      for (const Star& map : symmetries)
      {
        Star image;
        for (int c = 0; c < 8; ++c)
        {
          image[map[c]] = labels[c];
        }
        smallest = std::min(smallest, Canonical(image));
      }
      classes.insert(smallest);
    });
  EXPECT_EQ(all, 4140); // Bell number
  std::printf("set partitions of three or more labels that pass: %d in %zu classes\n", passing,
    classes.size());
  EXPECT_EQ(passing, 662);
  EXPECT_EQ(classes.size(), 32u);
}

TEST(LabelCondition, StarLabelsAreSortedAndDistinct)
{
  const Star star{ { 5, 0, 5, 2, 2, 9, 0, 5 } };
  const StarLabels labels(star);
  EXPECT_EQ(std::vector<int>(labels.begin(), labels.end()), (std::vector<int>{ 0, 2, 5, 9 }));
  EXPECT_EQ(labels.RankOf(5), 2);
}
