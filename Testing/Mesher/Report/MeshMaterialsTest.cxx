/// Materials and points of parts of a mesh on ranks.
#include "Report/MeshMaterials.h"
#include "Base/Runtime.h"
#include "Report/PointCounts.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

TEST(MeshMaterials, NamesAndIds)
{
  MeshData mesh;
  mesh.Fields = { { "MaterialIds", std::vector<int>{ 3, 40 } },
    { "MaterialNames", std::vector<std::string>{ "steel", "ice" } } };
  const std::map<int, std::string> names = NamesOfMaterials(mesh);
  EXPECT_EQ(NameOfMaterial(names, 0), "Void");
  EXPECT_EQ(NameOfMaterial(names, 40), "ice");
  EXPECT_EQ(NameOfMaterial(names, 7), "Material 7");
  RunOnRanks(3,
    [&mesh](Ranks& ranks)
    {
      MeshData part = mesh;
      const std::vector<int> materials{ 9 - ranks.Rank(), 3, 3, 0 };
      part.NumberOfElements = 4;
      part.Material = materials.data();
      EXPECT_EQ(FindMaterials(part, ranks), (std::vector<int>{ 0, 3, 7, 8, 9 }));
      EXPECT_EQ(FindVoidId(part, ranks), 41);
    });
}

TEST(MeshMaterials, MissingOrNegativeIdsAreErrorsOnAllRanks)
{
  for (bool isMissing : { true, false })
  {
    RunOnRanks(2,
      [isMissing](Ranks& ranks)
      {
        const std::vector<int> materials{ 1, ranks.Rank() == 1 ? -2 : 2 };
        MeshData part;
        part.NumberOfElements = 2;
        part.Material = isMissing && ranks.Rank() == 1 ? nullptr : materials.data();
        EXPECT_THROW(FindMaterials(part, ranks), InputError);
      });
  }
}

TEST(PointCounts, PointsBetweenRanksCountOnce)
{
  RunOnRanks(2,
    [](Ranks& ranks)
    {
      // Tets 1 2 3 4 and 2 3 4 5 of rank 0, 2 3 4 9 of rank 1.
      const std::vector<Index> elements = ranks.Rank() == 0
        ? std::vector<Index>{ 0, 1, 2, 3, 1, 2, 3, 4 }
        : std::vector<Index>{ 0, 1, 2, 3 };
      const std::vector<Index> ids =
        ranks.Rank() == 0 ? std::vector<Index>{ 1, 2, 3, 4, 5 } : std::vector<Index>{ 2, 3, 4, 9 };
      MeshData part;
      part.Corners = 4;
      part.NumberOfElements = static_cast<Index>(elements.size() / 4);
      part.NumberOfPoints = static_cast<Index>(ids.size());
      part.Elements = elements.data();
      part.PointIds = ids.data();
      const std::vector<int> parts =
        ranks.Rank() == 0 ? std::vector<int>{ 0, 1 } : std::vector<int>{ 1 };
      EXPECT_EQ(CountPoints(part, parts, 3, ranks), (std::vector<Index>{ 4, 5, 0 }));
    });
}
