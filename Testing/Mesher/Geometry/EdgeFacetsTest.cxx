/// Facets of smooth sides whose points do not tell their surface, on one rank and on several.
#include "Geometry/EdgeFacets.h"

#include "RankMeshes.h"
#include "SharpCases.h"

#include <gtest/gtest.h>

#include <mutex>

using namespace vfm;
using namespace vfm::testing;

TEST(EdgeFacets, EachRankHasThoseOfItsElements)
{
  const SharpCase c = MakeSharpCase("wedge 45", 14);
  MeshOptions options;
  options.SharpEdges = SharpEdgeMode::On;
  const EdgeFacetRows expected =
    MakeAlone(c.Grid, c.Fractions, options, MakeHexMesh).Merged.Tables.EdgeFacets;
  ASSERT_FALSE(expected.empty());
  for (int count : { 1, 8 })
  {
    std::mutex lock;
    EdgeFacetRows found;
    const auto list = [&](Runtime&, Mesh& mesh, MeshReport&)
    {
      const EdgeFacetRows rows = ListEdgeFacetsOfElements(mesh);
      const EdgeFacetRows& owned = mesh.Tables.EdgeFacets;
      EXPECT_TRUE(std::includes(rows.begin(), rows.end(), owned.begin(), owned.end()));
      const std::lock_guard<std::mutex> guard(lock);
      found.insert(found.end(), rows.begin(), rows.end());
    };
    MakeOnRanks(c.Grid, c.Fractions, CutBox(c.Grid.Global(), count), options, MakeHexMesh, list);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    EXPECT_EQ(found, expected);
  }
}
