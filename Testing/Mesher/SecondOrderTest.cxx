/// Second-order meshes: nodes, ids, positive Jacobians and volumes.
#include "CurvedNodes.h"
#include "LabelInput.h"
#include "NodesById.h"
#include "RandomDraw.h"
#include "RankFields.h"
#include "Sweep.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr double Width = 0.3; // coordinates are not exact

struct Kind
{
  const char* Name;
  ElementKind Elements;
  TetMethod Tets;
  InterpolationOrder Order;
  int Mids; // per element
};

constexpr Kind Kinds[] = { { "Hex20", ElementKind::Hexes, TetMethod::Lattice,
                             InterpolationOrder::Quadratic, 12 },
  { "Hex27", ElementKind::Hexes, TetMethod::Lattice, InterpolationOrder::Quadratic27, 19 },
  { "Lattice", ElementKind::Tets, TetMethod::Lattice, InterpolationOrder::Quadratic, 6 },
  { "Cells", ElementKind::Tets, TetMethod::Cells, InterpolationOrder::Quadratic27, 6 } };

MesherOptions OptionsOf(const Kind& kind)
{
  MesherOptions options;
  options.Elements = kind.Elements;
  options.Method = kind.Tets;
  options.ElementOrder = kind.Order;
  return options;
}

/// Returns labels of a ball in a block, 1 and 2, and void above.
std::vector<int> BallLabels(const Index3& cells)
{
  std::vector<int> labels;
  for (Index n = 0; n < cells[0] * cells[1] * cells[2]; ++n)
  {
    const Vector3 x{ { n % cells[0] - 3.2, n / cells[0] % cells[1] - 3.7,
      static_cast<double>(n / (cells[0] * cells[1])) - 3.4 } };
    labels.push_back(Dot(x, x) < 7.5 ? 1 : x[2] < 1.5 ? 2 : 0);
  }
  return labels;
}

double NumberOf(const MesherResult& result, const char* name)
{
  for (const FieldArray& field : result.Fields)
  {
    if (field.Name == name)
    {
      return NumbersOfField(result.Fields, name).at(0);
    }
  }
  ADD_FAILURE() << "no field " << name;
  return 0.0;
}

/// Returns the smallest coefficient of all elements over that of the straight element.
double SmallestRatio(const Mesh& mesh)
{
  const CurvedElement& shape = GetCurvedElement(mesh.Corners);
  const MidNodes mids(mesh.Corners, mesh.MidsPerElement);
  double least = 1.0;
  for (std::size_t e = 0; e < mesh.ElementIds.size(); ++e)
  {
    CurvedElement::Nodes nodes = NodesOf(mesh, static_cast<Index>(e));
    const double curved = shape.SmallestCoefficient(nodes);
    for (int m = 0; m < mids.Edges; ++m)
    {
      nodes[mesh.Corners + m] =
        0.5 * (nodes[mids.EdgeCorners[m][0]] + nodes[mids.EdgeCorners[m][1]]);
    }
    least = std::min(least, curved / shape.SmallestCoefficient(nodes));
  }
  return least;
}

class SecondOrder : public ::testing::TestWithParam<Kind>
{
};

} // namespace

TEST_P(SecondOrder, RanksGiveTheSameMesh)
{
  const Index3 cells{ { 8, 7, 9 } };
  for (const std::vector<int>& labels : { BallLabels(cells), RandomLabels(cells, 3) })
  {
    NodesById alone;
    for (int count : { 1, 2, 3 })
    {
      NodesById joined;
      std::mutex mutex;
      RunOnRanks(count,
        [&](ThreadRanks& ranks)
        {
          RankRuntime runtime(ranks);
          MesherOptions options = OptionsOf(this->GetParam());
          options.LabelSmoothing = 2;
          const MesherResult result =
            RunMesher(MakeLabelInput({ cells, 0.1, Width }, labels, ranks), options, runtime);
          const Mesh& mesh = result.TheMesh;
          EXPECT_TRUE(std::is_sorted(mesh.PointIds.begin(), mesh.PointIds.end()));
          EXPECT_EQ(mesh.MidsPerElement, this->GetParam().Mids);
          joined.Add(result, ranks, mutex);
        });
      alone = count == 1 ? joined : alone;
      EXPECT_TRUE(joined.Points == alone.Points);
      EXPECT_TRUE(joined.Nodes == alone.Nodes);
      EXPECT_TRUE(joined.InNodeSets == alone.InNodeSets);
      EXPECT_GT(joined.InNodeSets.size(), 100u);
    }
  }
}

/// Mid nodes inside fragments and on sides of the domain are in the middle, others near it. Ids
/// follow those of the corners.
TEST_P(SecondOrder, OnlyInterfacesAreCurved)
{
  const Index3 cells{ { 8, 7, 9 } };
  Runtime serial;
  MesherOptions options = OptionsOf(this->GetParam());
  options.LabelSmoothing = 2;
  const MesherResult result = RunMesher(
    MakeLabelInput({ cells, 0.0, Width }, BallLabels(cells), serial.Group()), options, serial);
  const Mesh& mesh = result.TheMesh;
  const MidNodes mids(mesh.Corners, mesh.MidsPerElement);
  std::set<Index> used(mesh.Elements.begin(), mesh.Elements.end());
  const auto corners = static_cast<Index>(used.size());
  EXPECT_EQ(*used.rbegin(), corners - 1);
  used.insert(mesh.MidPoints.begin(), mesh.MidPoints.end());
  EXPECT_EQ(used.size(), mesh.PointIds.size());
  double farthest = 0.0;
  Index curved = 0;
  for (Index e = 0; e < static_cast<Index>(mesh.ElementIds.size()); ++e)
  {
    const CurvedElement::Nodes nodes = NodesOf(mesh, e);
    for (int m = 0; m < mids.Edges; ++m)
    {
      const Index point = mesh.MidPoints[mids.Count * e + m];
      const Vector3 &p = nodes[mids.EdgeCorners[m][0]], &q = nodes[mids.EdgeCorners[m][1]];
      const Vector3 middle = 0.5 * (p + q), x = mesh.PointAt(point);
      ASSERT_GE(point, corners);
      if (mesh.GeometryDimension[point] == DimensionOfVolumes)
      {
        EXPECT_EQ(x, middle);
        EXPECT_EQ(mesh.GeometryId[point], mesh.Fragment[e]);
      }
      for (int a = 0; a < 3; ++a)
      {
        if (p[a] == q[a] && (p[a] == 0.0 || p[a] == Width * static_cast<double>(cells[a])))
        {
          EXPECT_EQ(x[a], p[a]);
        }
      }
      farthest = std::max(farthest, Norm(x - middle) / Norm(q - p));
      curved += x != middle;
    }
  }
  EXPECT_GT(curved, 50);
  EXPECT_GT(farthest, 0.01);
  EXPECT_LE(farthest, 0.2501);
  EXPECT_GT(NumberOf(result, "CurvedMidNodes"), 50.0);
}

/// The nodes of faces and the centre are where the element of 20 nodes has these points.
TEST(SecondOrder27, FollowsTheElementOf20Nodes)
{
  const Index3 cells{ { 8, 7, 9 } };
  Runtime serial;
  std::array<MesherResult, 2> results;
  for (int n = 0; n < 2; ++n)
  {
    results[n] = RunMesher(MakeLabelInput({ cells, 0.0, Width }, BallLabels(cells), serial.Group()),
      OptionsOf(Kinds[n]), serial);
  }
  const Mesh &with20 = results[0].TheMesh, &with27 = results[1].TheMesh;
  ASSERT_TRUE(std::equal(with20.Points.begin(), with20.Points.end(), with27.Points.begin()));
  for (Index e = 0; e < static_cast<Index>(with27.ElementIds.size()); ++e)
  {
    const CurvedElement::Nodes nodes = NodesOf(with20, e);
    const Index* mids = with27.MidPoints.data() + 19 * e;
    Vector3 sum{};
    for (int n = 0; n < 20; ++n)
    {
      sum = sum + (n < 8 ? -0.25 : 0.25) * nodes[n];
    }
    EXPECT_LT(Norm(with27.PointAt(mids[18]) - sum), 1e-14);
    Vector3 ofFaces{};
    for (int f = 0; f < 6; ++f)
    {
      ofFaces = ofFaces + 0.5 * with27.PointAt(mids[12 + f]);
    }
    for (int n = 0; n < 20; ++n)
    {
      ofFaces = ofFaces + (n < 8 ? 0.125 : -0.25) * nodes[n];
    }
    EXPECT_LT(Norm(ofFaces - sum), 1e-13); // transfinite interpolation
  }
}

/// The fields count what was moved back.
TEST(SecondOrder200, AllCoefficientsArePositiveOnRandomGrids)
{
  Runtime serial;
  double least = 1.0;
  Index curved = 0, straightened = 0, meshes = 0;
  for (unsigned seed : ListSeeds(200))
  {
    RandomDraw draw(seed + 1);
    const Index3 cells{ { draw.Whole(3, 6), draw.Whole(3, 6), draw.Whole(3, 6) } };
    MesherOptions options = OptionsOf(Kinds[seed % 4]);
    options.MeshVoid = draw.Chance(0.4);
    options.LabelSmoothing = draw.Whole(0, 3);
    options.SharpEdges =
      draw.Pick({ SharpEdgeMode::Off, SharpEdgeMode::On, SharpEdgeMode::Automatic });
    const MesherResult result = RunMesher(
      MakeLabelInput({ cells, 0.1, Width }, RandomLabels(cells, draw.Seed()), serial.Group()),
      options, serial);
    const double ratio = SmallestRatio(result.TheMesh);
    EXPECT_GT(ratio, 0.0999) << "seed " << seed;
    EXPECT_NEAR(ratio, NumberOf(result, "CurvedJacobian"), 1e-9) << "seed " << seed;
    least = std::min(least, ratio);
    curved += static_cast<Index>(NumberOf(result, "CurvedMidNodes"));
    straightened += static_cast<Index>(NumberOf(result, "StraightenedMidNodes"));
    ++meshes;
  }
  std::printf("%lld meshes of random labels: %lld curved mid nodes, %lld of them moved back; "
              "smallest coefficient, curved over straight: %.3f\n",
    static_cast<long long>(meshes), static_cast<long long>(curved),
    static_cast<long long>(straightened), least);
  EXPECT_GT(straightened, 0);
}

/// Volumes are those of the curved elements.
TEST_P(SecondOrder, ConservesVolumes)
{
  const Index3 cells{ { 8, 7, 9 } };
  std::vector<int> labels = BallLabels(cells);
  std::replace(labels.begin(), labels.end(), 2, 0);
  Runtime serial;
  MesherOptions options = OptionsOf(this->GetParam());
  options.LabelSmoothing = 3;
  const MesherResult result =
    RunMesher(MakeLabelInput({ cells, 0.0, Width }, labels, serial.Group()), options, serial);
  const Mesh& mesh = result.TheMesh;
  double volume = 0.0;
  for (Index e = 0; e < static_cast<Index>(mesh.ElementIds.size()); ++e)
  {
    volume += GetCurvedElement(mesh.Corners).Volume(NodesOf(mesh, e));
  }
  ASSERT_EQ(NumberOf(result, "StraightenedMidNodes"), 0.0);
  EXPECT_NEAR(volume / result.Report.MeshVolume[1], 1.0, 1e-12);
  EXPECT_NEAR(volume / result.Report.TargetVolume[1], 1.0, 2e-7);
}

TEST(SecondOrderOptions, RefusesCohesiveElements)
{
  Runtime serial;
  MesherOptions options;
  options.ElementOrder = InterpolationOrder::Quadratic;
  options.SplitInterfaces = "*";
  options.SplitConnection = ConnectionKind::Cohesive;
  const MesherInput input =
    MakeLabelInput({ { { 4, 4, 4 } }, 0.0, 1.0 }, std::vector<int>(64, 1), serial.Group());
  EXPECT_THROW(RunMesher(input, options, serial), InputError);
}

INSTANTIATE_TEST_SUITE_P(Kinds, SecondOrder, ::testing::ValuesIn(Kinds),
  [](const auto& info) { return std::string(info.param.Name); });

namespace
{

/// Returns the Jacobian of an element from derivatives by small differences of its map.
class Map
{
public:
  Map(int corners, const CurvedElement::Nodes& nodes) : Corners(corners), Nodes(nodes) {}

  double JacobianAt(const Vector3& u) const
  {
    constexpr double step = 1e-6;
    Vector3 along[3];
    for (int a = 0; a < 3; ++a)
    {
      Vector3 low = u, high = u;
      low[a] -= step;
      high[a] += step;
      along[a] = (0.5 / step) * (this->At(high) - this->At(low));
    }
    return Dot(along[0], Cross(along[1], along[2]));
  }

private:
  /// The shape functions in their usual form.
  Vector3 At(const Vector3& u) const
  {
    Vector3 x{};
    if (this->Corners == 4)
    {
      const double l[4] = { 1.0 - u[0] - u[1] - u[2], u[0], u[1], u[2] };
      constexpr int ends[6][2] = { { 0, 1 }, { 1, 2 }, { 0, 2 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };
      for (int c = 0; c < 4; ++c)
      {
        x = x + l[c] * (2.0 * l[c] - 1.0) * this->Nodes[c];
      }
      for (int e = 0; e < 6; ++e)
      {
        x = x + 4.0 * l[ends[e][0]] * l[ends[e][1]] * this->Nodes[4 + e];
      }
      return x;
    }
    constexpr int at[20][3] = { { -1, -1, -1 }, { 1, -1, -1 }, { 1, 1, -1 }, { -1, 1, -1 },
      { -1, -1, 1 }, { 1, -1, 1 }, { 1, 1, 1 }, { -1, 1, 1 }, { 0, -1, -1 }, { 1, 0, -1 },
      { 0, 1, -1 }, { -1, 0, -1 }, { 0, -1, 1 }, { 1, 0, 1 }, { 0, 1, 1 }, { -1, 0, 1 },
      { -1, -1, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { -1, 1, 0 } };
    for (int n = 0; n < 20; ++n)
    {
      double value = n < 8 ? 0.125 : 0.25, sum = -2.0;
      for (int a = 0; a < 3; ++a)
      {
        const double t = 2.0 * u[a] - 1.0;
        value *= at[n][a] == 0 ? 1.0 - t * t : 1.0 + at[n][a] * t;
        sum += at[n][a] * t;
      }
      x = x + (n < 8 ? sum : 1.0) * value * this->Nodes[n];
    }
    return x;
  }

  const int Corners;
  const CurvedElement::Nodes& Nodes;
};

/// Returns an element with corners and mid nodes moved at random.
CurvedElement::Nodes DrawElement(int corners, double size, RandomDraw& draw)
{
  constexpr int cube[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  constexpr int simplex[4][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  const MidNodes mids(corners, MidNodes::CountOf(InterpolationOrder::Quadratic, corners));
  CurvedElement::Nodes nodes{};
  for (int c = 0; c < corners; ++c)
  {
    const int* at = corners == 8 ? cube[c] : simplex[c];
    nodes[c] = draw.Vector(-size, size) + Vector3{ { 1.0 * at[0], 1.0 * at[1], 1.0 * at[2] } };
  }
  for (int e = 0; e < mids.Edges; ++e)
  {
    nodes[corners + e] = draw.Vector(-size, size) +
      0.5 * (nodes[mids.EdgeCorners[e][0]] + nodes[mids.EdgeCorners[e][1]]);
  }
  return nodes;
}

} // namespace

TEST(CurvedElement, CoefficientsAreALowerBoundOfTheJacobian)
{
  RandomDraw draw(1);
  int folded = 0;
  for (int n = 0; n < 100; ++n)
  {
    const int corners = n % 2 == 0 ? 8 : 4;
    const CurvedElement::Nodes nodes = DrawElement(corners, n % 3 == 0 ? 0.3 : 0.1, draw);
    const double bound = GetCurvedElement(corners).SmallestCoefficient(nodes);
    const Map map(corners, nodes);
    double least = 1e300, volume = 0.0;
    int inside = 0;
    for (int i = 0; i < 2000; ++i)
    {
      const Vector3 u = draw.Vector(0.0, 1.0);
      if (corners == 4 && u[0] + u[1] + u[2] > 1.0)
      {
        continue;
      }
      const double jacobian = map.JacobianAt(u);
      least = std::min(least, jacobian);
      volume += jacobian;
      ++inside;
    }
    EXPECT_GE(least, bound - 1e-6);
    EXPECT_LT(least - bound, 3.0); // of a unit cube
    EXPECT_NEAR(GetCurvedElement(corners).Volume(nodes),
      volume / inside * (corners == 8 ? 1.0 : 1.0 / 6.0), 0.03);
    folded += least < 0.0;
  }
  EXPECT_GT(folded, 5);
}
