/// Second-order meshes that are periodic, split or have layers.
#include "CurvedNodes.h"
#include "LabelInput.h"
#include "NodesById.h"
#include "RankFields.h"
#include "Report/Sets/MeshSets.h"
#include "Report/Sets/PeriodicPairs.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr double Width = 0.3; // coordinates are not exact
constexpr Index3 Cells{ { 8, 6, 7 } };

struct Combination
{
  const char* Name;
  ElementKind Elements = ElementKind::Hexes;
  InterpolationOrder Order = InterpolationOrder::Quadratic;
  int Periodic = 0;
  Sides Kind = Sides::Flat;
  int Layers = 0;
  int LayerSides = 0;
  const char* Split = "";
  bool HasLevels = false;
  TetMethod Tets = TetMethod::Lattice;
};

constexpr auto Hexes = ElementKind::Hexes;
constexpr auto Tets = ElementKind::Tets;
constexpr auto Quadratic = InterpolationOrder::Quadratic;
constexpr auto Quadratic27 = InterpolationOrder::Quadratic27;

constexpr Combination Combinations[] = { { "SplitHexes", Hexes, Quadratic, 0, Sides::Flat, 0, 0,
                                           "all" },
  { "SplitHexes27", Hexes, Quadratic27, 0, Sides::Flat, 0, 0, "1/3" },
  { "SplitTets", Tets, Quadratic, 0, Sides::Flat, 0, 0, "all" },
  { "Layers", Hexes, Quadratic, 0, Sides::Flat, 3 },
  { "LayersOnSides27", Hexes, Quadratic27, 0, Sides::Flat, 2, 5 },
  { "SplitLayers", Hexes, Quadratic27, 0, Sides::Flat, 3, 0, "all" },
  { "FlatHexes", Hexes, Quadratic, 5 }, { "FreeHexes27", Hexes, Quadratic27, 7, Sides::Free },
  { "JoinedHexes27", Hexes, Quadratic27, 7, Sides::Joined }, { "FlatLattice", Tets, Quadratic, 7 },
  { "JoinedLattice", Tets, Quadratic, 7, Sides::Joined },
  { "FlatCells", Tets, Quadratic, 3, Sides::Flat, 0, 0, "", false, TetMethod::Cells },
  { "FlatLevels", Hexes, Quadratic, 5, Sides::Flat, 0, 0, "", true },
  { "FreeLevels27", Hexes, Quadratic27, 5, Sides::Free, 0, 0, "", true },
  { "JoinedTetsOfLevels", Tets, Quadratic, 7, Sides::Joined, 0, 0, "", true },
  { "FlatLayers", Hexes, Quadratic27, 5, Sides::Flat, 3 },
  { "FreeLayers", Hexes, Quadratic, 7, Sides::Free, 2 },
  { "JoinedLayers", Hexes, Quadratic, 7, Sides::Joined, 2 },
  { "FlatSplitHexes27", Hexes, Quadratic27, 7, Sides::Flat, 0, 0, "all" },
  { "FreeSplitHexes", Hexes, Quadratic, 5, Sides::Free, 0, 0, "all" },
  { "JoinedSplitTets", Tets, Quadratic, 7, Sides::Joined, 0, 0, "1/3" },
  { "FlatSplitLayers", Hexes, Quadratic27, 7, Sides::Flat, 3, 0, "all" } };

/// Labels of two balls, at a corner of the periodic domain and inside, in a third material.
std::vector<int> BallLabels()
{
  std::vector<int> labels;
  for (Index n = 0; n < Cells[0] * Cells[1] * Cells[2]; ++n)
  {
    const Vector3 x{ { n % Cells[0] + 0.4, n / Cells[0] % Cells[1] + 0.7,
      static_cast<double>(n / (Cells[0] * Cells[1])) + 0.3 } };
    int label = 3;
    for (int ball = 0; ball < 2; ++ball)
    {
      double square = 0.0;
      for (int a = 0; a < 3; ++a)
      {
        const double length = static_cast<double>(Cells[a]);
        double d = std::fabs(x[a] - ball * (0.5 * length));
        d = std::min(d, length - d);
        square += d * d;
      }
      label = square < 5.0 ? ball + 1 : label;
    }
    labels.push_back(label);
  }
  return labels;
}

MesherResult MakeMesh(const Combination& c, Runtime& runtime)
{
  MesherOptions options;
  options.Elements = c.Elements;
  options.Method = c.Tets;
  options.ElementOrder = c.Order;
  options.Periodic = c.Periodic;
  options.PeriodicSides = c.Kind;
  options.Layers = c.Layers;
  options.FirstLayer = c.Layers > 0 ? 0.1 : 0.0;
  options.LayerSides = c.LayerSides;
  options.SplitInterfaces = c.Split;
  options.LabelSmoothing = c.HasLevels ? 0 : 2;
  options.MeshVoid = true;
  Ranks& ranks = runtime.Group();
  return RunMesher(c.HasLevels
      ? MakeLevelInput({ { { 8, 8, 6 } }, 0.1, Width },
          { { { { 0, 0, 0 } }, { { 2, 3, 2 } } }, { { { 6, 3, 1 } }, { { 8, 5, 3 } } } }, ranks)
      : MakeLabelInput({ Cells, 0.1, Width }, BallLabels(), ranks),
    options, runtime);
}

double NumberOf(const MesherResult& result, const char* name)
{
  return NumbersOfField(result.Fields, name).at(0);
}

/// Returns the nodes of an element at the images nearest to its first corner.
CurvedElement::Nodes JoinedNodesOf(const MesherResult& result, Index element)
{
  CurvedElement::Nodes nodes = NodesOf(result.TheMesh, element);
  const std::vector<double> lengths = NumbersOfField(result.Fields, "PeriodLengths");
  for (std::size_t n = 1; n < nodes.size() && !lengths.empty(); ++n)
  {
    for (int a = 0; a < 3; ++a)
    {
      const double length = lengths[a];
      nodes[n][a] -= length > 0.0 ? length * std::round((nodes[n][a] - nodes[0][a]) / length) : 0.0;
    }
  }
  return nodes;
}

/// All Bezier coefficients are at least a tenth of the smallest one of the straight element, and
/// elements fill the domain. The reported volumes are those of curved elements.
void ExpectPositive(const Combination& c, const MesherResult& result)
{
  const Mesh& mesh = result.TheMesh;
  const CurvedElement& shape = GetCurvedElement(mesh.Corners);
  const MidNodes mids(mesh.Corners, mesh.MidsPerElement);
  double least = 1.0, volume = 0.0;
  for (std::size_t e = 0; e < mesh.ElementIds.size(); ++e)
  {
    CurvedElement::Nodes nodes = JoinedNodesOf(result, static_cast<Index>(e));
    const double curved = shape.SmallestCoefficient(nodes);
    volume += shape.Volume(nodes);
    for (int m = 0; m < mids.Edges; ++m)
    {
      nodes[mesh.Corners + m] =
        0.5 * (nodes[mids.EdgeCorners[m][0]] + nodes[mids.EdgeCorners[m][1]]);
    }
    least = std::min(least, curved / shape.SmallestCoefficient(nodes));
  }
  const std::vector<double> reported = NumbersOfField(result.Fields, "MeshVolume");
  EXPECT_NEAR(std::accumulate(reported.begin(), reported.end(), 0.0) / volume, 1.0, 1e-12);
  EXPECT_EQ(result.Report.MeshVolume, reported);
  EXPECT_GT(least, 0.0999);
  EXPECT_NEAR(least, NumberOf(result, "CurvedJacobian"), 1e-9);
  EXPECT_GT(NumberOf(result, "CurvedMidNodes"), 200.0);
  std::printf("%s: %.0f curved mid nodes, %.0f moved back, smallest ratio %.3f\n", c.Name,
    NumberOf(result, "CurvedMidNodes"), NumberOf(result, "StraightenedMidNodes"), least);
  if (c.Periodic == 0 || c.Kind != Sides::Free)
  {
    const std::vector<double> box = NumbersOfField(result.Fields, "DomainBounds");
    const double all = (box[1] - box[0]) * (box[3] - box[2]) * (box[5] - box[4]);
    EXPECT_NEAR(volume / all, 1.0, 1e-12);
  }
}

/// The elements on both sides of a face have the same nodes there, also on opposite sides and where
/// interfaces are split.
void ExpectSharedNodesOfFaces(const Combination& c, const MesherResult& result)
{
  const MeshData mesh = ViewOf(result);
  const Index* ids = result.TheMesh.CommonIds().data();
  const bool isSplit = mesh.OriginalPointIds != nullptr;
  ids = isSplit ? mesh.OriginalPointIds : ids;
  std::map<FaceIds, std::vector<std::set<Index>>> faces;
  for (Index e = 0; e < mesh.NumberOfElements; ++e)
  {
    for (int side = 0; side < ElementFaces(mesh.Corners).Count; ++side)
    {
      std::set<Index> nodes;
      const std::vector<Index> mids = MidsOfFace(mesh, e, side);
      EXPECT_GE(mids.size(), 3u);
      for (Index point : mids)
      {
        nodes.insert(ids[point]);
      }
      const FaceIds corners = PointsOfSide(mesh, { e, side });
      FaceIds key = corners;
      for (Index& point : key)
      {
        point = point < 0 ? -1 : ids[point];
      }
      std::sort(key.begin(), key.end());
      faces[key].push_back(nodes);
    }
  }
  Index shared = 0;
  for (const auto& face : faces)
  {
    ASSERT_LE(face.second.size(), 2u);
    if (face.second.size() == 2)
    {
      EXPECT_EQ(face.second[0], face.second[1]);
      ++shared;
    }
  }
  EXPECT_GT(shared, 1000);
  if (c.Periodic == 7 && (!isSplit || c.Kind == Sides::Joined))
  {
    EXPECT_EQ(shared, static_cast<Index>(faces.size()));
  }
}

void ExpectCopiesAtTheSamePlace(const Combination& c, const MesherResult& result)
{
  const MeshData mesh = ViewOf(result);
  const Index firstMid =
    *std::max_element(mesh.Elements, mesh.Elements + mesh.Corners * mesh.NumberOfElements) + 1;
  Index mids = 0;
  const std::vector<double> lengths = NumbersOfField(mesh.Fields, "PeriodLengths");
  for (const PeriodicPair& pair : FindPeriodicPairs(mesh))
  {
    EXPECT_NE(pair.Periods, Index3{});
    mids += pair.Point >= firstMid;
    for (int a = 0; a < 3; ++a)
    {
      // Copies along two axes can lie below their partner.
      const double shift = std::fabs(static_cast<double>(pair.Periods[a])) * lengths[a];
      const double one = mesh.Point(pair.Point)[a], other = mesh.Point(pair.Partner)[a];
      EXPECT_EQ(std::max(one, other), std::min(one, other) + shift);
    }
  }
  EXPECT_EQ(mids > 100, mesh.PeriodicPartner != nullptr);
  std::map<Index, Vector3> places;
  Index copies = 0;
  for (Index p = 0; mesh.OriginalPointIds && p < mesh.NumberOfPoints; ++p)
  {
    const auto added = places.emplace(mesh.OriginalPointIds[p], mesh.PointAt(p));
    EXPECT_EQ(added.first->second, mesh.PointAt(p));
    copies += !added.second && p >= firstMid;
  }
  EXPECT_EQ(copies > 100, *c.Split != '\0');
}

class CombinedOrder : public ::testing::TestWithParam<Combination>
{
};

} // namespace

TEST_P(CombinedOrder, RanksGiveTheSameMesh)
{
  NodesById alone;
  for (int count : { 1, 2, 3, 8 })
  {
    NodesById joined;
    std::mutex mutex;
    RunOnRanks(count,
      [&](ThreadRanks& ranks)
      {
        RankRuntime runtime(ranks);
        const MesherResult result = MakeMesh(this->GetParam(), runtime);
        const Buffer<Index>& ids = result.TheMesh.PointIds;
        EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
        joined.Add(result, ranks, mutex);
      });
    alone = count == 1 ? joined : alone;
    EXPECT_TRUE(joined.Points == alone.Points);
    EXPECT_TRUE(joined.Nodes == alone.Nodes);
    EXPECT_TRUE(joined.InNodeSets == alone.InNodeSets);
    EXPECT_GT(joined.Nodes.size(), 100u);
  }
}

TEST_P(CombinedOrder, ElementsArePositiveAndShareTheirNodes)
{
  Runtime serial;
  const MesherResult result = MakeMesh(this->GetParam(), serial);
  ExpectPositive(this->GetParam(), result);
  ExpectSharedNodesOfFaces(this->GetParam(), result);
  ExpectCopiesAtTheSamePlace(this->GetParam(), result);
}

/// Mid nodes lie where they are without the split; those of faces and copies up to rounding.
TEST_P(CombinedOrder, SplitMovesNothing)
{
  if (*this->GetParam().Split == '\0')
  {
    return;
  }
  Runtime serial;
  Combination whole = this->GetParam();
  whole.Split = "";
  const MesherResult split = MakeMesh(this->GetParam(), serial), expected = MakeMesh(whole, serial);
  const MeshData mesh = ViewOf(split), before = ViewOf(expected);
  ASSERT_EQ(mesh.NumberOfElements, before.NumberOfElements);
  ASSERT_GT(mesh.NumberOfPoints, before.NumberOfPoints);
  for (Index e = 0; e < mesh.NumberOfElements; ++e)
  {
    for (int m = 0; m < mesh.MidsPerElement; ++m)
    {
      const Index at = mesh.MidsPerElement * e + m;
      const Vector3 x = mesh.PointAt(mesh.MidPoints[at]), y = before.PointAt(before.MidPoints[at]);
      EXPECT_LE(Norm(x - y), mesh.PeriodicPartner || m >= 12 ? 1e-14 : 0.0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Combinations, CombinedOrder, ::testing::ValuesIn(Combinations),
  [](const auto& info) { return std::string(info.param.Name); });
