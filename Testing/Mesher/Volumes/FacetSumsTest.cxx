/// Sums of facets that are kept between moves are equal to new sums.
#include "Volumes/FacetSums.h"
#include "Base/HexVolume.h"
#include "Base/ThreadRuntime.h"
#include "RandomDraw.h"
#include "Volumes/FacetSweeps.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr int Size = 24; // points per axis of a sheet of facets
constexpr int Fragments = 5;

/// Sheet of squares between fragments at random, in long and short runs.
struct Sheet
{
  explicit Sheet(RandomDraw& draw)
  {
    std::array<int, 2> pair{ { 1, 0 } };
    for (int p = 0; p < Size * Size; ++p)
    {
      const int x = p % Size, y = p / Size;
      this->Start.insert(this->Start.end(), { double(x), double(y), 0.0 });
      this->Mesh.MeshPoint.push_back(p);
      this->Mesh.X.push_back({ { double(x), double(y), 0.0 } });
      if (draw.Between(0.0, 1.0) < 0.02)
      {
        pair = { { 1 + static_cast<int>(draw.Between(0.0, Fragments - 1.0)), 0 } };
        pair[1] = (pair[0] + 1) % Fragments;
      }
      if (x + 1 < Size && y + 1 < Size)
      {
        this->Mesh.Facets.push_back({ { { p, p + 1, p + Size + 1, p + Size } }, pair });
      }
    }
    this->Mesh.MeshPoints = this->Start.data();
    std::reverse(this->Mesh.Facets.begin() + 40, this->Mesh.Facets.begin() + 200);
  }

  std::vector<double> Start;
  ActiveMesh Mesh;
};

void ExpectEqual(const FacetSums& a, const FacetSums& b)
{
  ASSERT_EQ(a.Swept().size(), b.Swept().size());
  for (std::size_t f = 0; f < a.Swept().size(); ++f)
  {
    EXPECT_EQ(a.Swept()[f].Parts(), b.Swept()[f].Parts()) << f;
  }
  ASSERT_EQ(a.Areas().size(), b.Areas().size());
  for (const auto& [pair, area] : a.Areas())
  {
    ASSERT_EQ(b.Areas().count(pair), 1u);
    EXPECT_EQ(area.Parts(), b.Areas().at(pair).Parts());
  }
}

} // namespace

TEST(FacetSums, KeptSumsAreEqualToNewSums)
{
  RandomDraw draw(3);
  Sheet sheet(draw);
  ThreadRuntime runtime(3, nullptr);
  FacetSums kept;
  kept.Start(sheet.Mesh, Fragments, runtime);
  for (int round = 0; round < 40; ++round)
  {
    std::vector<unsigned char> moved(sheet.Mesh.X.size(), 0);
    for (int move = 0; move < round % 8; ++move)
    {
      const auto point = static_cast<std::size_t>(draw.Between(0.0, Size * Size));
      sheet.Mesh.X[point] = sheet.Mesh.X[point] + draw.Vector(-0.3, 0.3);
      moved[point] = 1;
    }
    kept.Update(sheet.Mesh, moved, runtime);
    FacetSums anew;
    anew.Start(sheet.Mesh, Fragments, runtime);
    ExpectEqual(kept, anew);
  }
}

TEST(FacetSums, SumsOnlyFacetsAtPointsThatMoved)
{
  RandomDraw draw(4);
  Sheet sheet(draw);
  Runtime runtime;
  FacetSums kept;
  kept.Start(sheet.Mesh, Fragments, runtime);
  const FacetSums before = kept;
  sheet.Mesh.X[Size + 1][2] = 0.5;
  std::vector<unsigned char> moved(sheet.Mesh.X.size(), 0);
  kept.Update(sheet.Mesh, moved, runtime);
  ExpectEqual(kept, before);
  moved[Size + 1] = 1;
  kept.Update(sheet.Mesh, moved, runtime);
  // Four pyramids over squares.
  double swept = 0.0;
  for (std::size_t f = 0; f < Fragments; ++f)
  {
    swept += std::fabs(kept.Swept()[f].Value());
  }
  EXPECT_GT(swept, 0.5);
}

TEST(FacetSweeps, AreEqualToTheVolumesAndAreasOfEachFacet)
{
  RandomDraw draw(6);
  FacetCorners corners{};
  for (int facets = 1; facets <= FacetCorners::Most; ++facets)
  {
    std::vector<std::array<Vector3, 4>> start(facets), now(facets);
    for (int f = 0; f < facets; ++f)
    {
      for (int c = 0; c < 4; ++c)
      {
        start[f][c] = draw.Vector(-5.0, 5.0);
        now[f][c] = start[f][c] + draw.Vector(-0.6, 0.6);
        corners.Set(f, c, start[f][c], now[f][c]);
      }
    }
    double volumes[FacetCorners::Most], areas[FacetCorners::Most];
    corners.Measure(facets, volumes, areas);
    for (int f = 0; f < facets; ++f)
    {
      const std::array<Vector3, 4>& q = now[f];
      EXPECT_EQ(volumes[f], VolumeBetween(start[f], q));
      EXPECT_EQ(areas[f], 0.5 * Norm(Cross(q[2] - q[0], q[3] - q[1])));
    }
  }
}
