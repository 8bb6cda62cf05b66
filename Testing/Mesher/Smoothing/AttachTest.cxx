/// Attachments of points to the targets of their interfaces, and the facets that measure volumes.
#include "Smoothing/Attach.h"

#include <gtest/gtest.h>

using namespace vfm;

namespace
{

/// Mesh points 1 to 7 are points 0 to 6 of the active part, of which the last does not move.
ActiveMesh MakeActive()
{
  ActiveMesh active;
  active.PointOf = { -1, 0, 1, 2, 3, 4, 5, 6, -1 };
  active.X.resize(7);
  active.IsActive = { 1, 1, 1, 1, 1, 1, 0 };
  return active;
}

const std::vector<Facet> Facets{ { { { 1, 2, 3, 4 } }, { { 2, 1 } }, { { 5, 3 } }, -1, true },
  { { { 2, 3, 5, 6 } }, { { 1, 3 } }, { { 3, 4 } }, -1, false },
  { { { 1, 2, 7, 8 } }, { { 2, 0 } }, { { 5, 0 } }, 2, true },  // on a side of the domain
  { { { 3, 5, 7, 7 } }, { { 2, 1 } }, { { 5, 2 } }, -1, true }, // a triangle
  { { { 4, 5, 6, 7 } }, { { 1, 0 } }, { { 2, 0 } }, -1, true } };

} // namespace

TEST(Attach, PointsHaveATargetPerPairOfLabels)
{
  ActiveMesh active = MakeActive();
  Runtime runtime;
  const std::vector<Facet> facets(Facets.begin(), Facets.end() - 1);
  AttachToFacets(
    facets,
    [](int point, const std::array<int, 2>& labels) -> Index
    { return point == 2 && labels[1] == 3 ? -1 : 100 * point + 10 * labels[0] + labels[1]; },
    runtime, active);
  struct Right
  {
    int Target;
    std::array<int, 2> Fragments;
  };
  // By point and pair; point 2 has no target of labels 1 and 3, and the smallest fragments.
  const std::vector<std::vector<Right>> right{ { { 12, { { 3, 5 } } } },
    { { 112, { { 3, 5 } } }, { 113, { { 3, 4 } } } }, { { 212, { { 2, 5 } } } },
    { { 312, { { 3, 5 } } } }, { { 412, { { 2, 5 } } }, { 413, { { 3, 4 } } } },
    { { 513, { { 3, 4 } } } }, {} };
  ASSERT_EQ(active.AttachmentOffset.size(), 8u);
  for (std::size_t p = 0; p < right.size(); ++p)
  {
    const CornerPosition first = active.AttachmentOffset[p];
    ASSERT_EQ(active.AttachmentOffset[p + 1] - first, right[p].size()) << p;
    for (std::size_t n = 0; n < right[p].size(); ++n)
    {
      const Attachment& found = active.Attachments[first + n];
      EXPECT_EQ(found.Target, right[p][n].Target);
      EXPECT_EQ(found.Fragments, right[p][n].Fragments);
      EXPECT_EQ(found.Weight, 1.0f);
      EXPECT_EQ(found.Offset, 0.0);
    }
  }
}

TEST(Attach, OwnedFacetsOfInterfacesAreMeasured)
{
  ActiveMesh active = MakeActive();
  Runtime runtime;
  SetFacets(Facets, runtime, active);
  ASSERT_EQ(active.Facets.size(), 3u);
  const std::array<int, 2> fragments[] = { { { 2, 0 } }, { { 5, 2 } }, { { 5, 3 } } };
  const std::array<int, 4> points[] = { { { 3, 4, 5, 6 } }, { { 2, 4, 6, 6 } },
    { { 0, 1, 2, 3 } } };
  for (int f = 0; f < 3; ++f)
  {
    EXPECT_EQ(active.Facets[f].Fragments, fragments[f]);
    EXPECT_EQ(active.Facets[f].Points, points[f]);
  }
}
