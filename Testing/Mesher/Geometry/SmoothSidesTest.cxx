/// Sides of interfaces with edges and the resulting geometry, on faces of cells. A function
/// defines which points carry edges.
#include "Geometry/SmoothSides.h"
#include "Base/ThreadRuntime.h"
#include "Base/Vector3.h"
#include "Geometry/Geometry.h"
#include "Labels/Fragments.h"
#include "Labels/InterfaceFaces.h"
#include "MeshChecks.h"
#include "Octree/RefinedGrid.h"
#include "RankFields.h"
#include "RankMeshes.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

using Carries = std::function<bool(const Index3& node)>;

/// A body of material 1: its cells, the nodes that carry edges, and the positions of nodes.
struct Body
{
  std::function<bool(const Index3& cell)> Has;
  Carries IsEdge;
  std::function<Vector3(const Vector3& node)> Place = [](const Vector3& node) { return node; };
};

/// Results of a rank, and the surface of each owned facet by the ids of its points.
struct Classified
{
  GeometryTables Tables;
  MeshReport Report;
  std::map<std::array<Index, 4>, int> Surfaces;
};

/// A mesh of the faces between cells of a body and void; its points are nodes.
class FaceMesh
{
public:
  FaceMesh(const CartesianGrid& whole, const CartesianGrid& grid, const Body& body, Ranks& ranks) :
    Grid(grid), Parts(grid, ranks)
  {
    this->Result.Levels = std::make_shared<const RefinedGrid>(grid, ranks);
    std::vector<Index> points(grid.NumberOfEntries(), -1);
    this->AddPoints(body, points);
    const FractionField field =
      MakeLabels(whole, 1, [&](const Index3& cell) { return body.Has(cell) ? 1 : 0; });
    const LabelArray labels = AssignMaterials(grid, CopyToLocal(whole, field, grid), .5);
    const Fragments fragments(grid, labels, false, this->Parts);
    const auto addFacet = [&](const InterfaceFace& face, const Index3& lower, const Index3& upper)
    {
      const std::vector<int>& ids = fragments.Share().Ids;
      Facet facet{ {}, { { face.LowerLabel, face.UpperLabel } },
        { { ids[fragments.FragmentOfCell(lower)], ids[fragments.FragmentOfCell(upper)] } }, -1,
        this->Parts.OwnsCell(face.LowerLabel > 0 ? lower : upper) };
      const std::array<Index, 4> nodes = NodesOfFace(grid, face);
      std::transform(nodes.begin(), nodes.end(), facet.Points.begin(),
        [&points](Index node) { return points[node]; });
      this->Facets.push_back(facet);
    };
    for (Index node : FindMixedNodes(grid, labels))
    {
      ForFacesOfNode(grid, labels, node, grid.HexBox(), addFacet);
    }
  }

  Classified Classify()
  {
    Classified made;
    ThreadRuntime runtime(2, &this->Parts.Group());
    ClassifyGeometry(this->Facets,
      { FindSmoothSides(this->Facets, this->Kinds, this->Result, this->Parts) }, runtime,
      this->Result, made.Report);
    made.Tables = this->Result.Tables;
    for (std::size_t f = 0; f < this->Facets.size(); ++f)
    {
      std::array<Index, 4> key;
      std::transform(this->Facets[f].Points.begin(), this->Facets[f].Points.end(), key.begin(),
        [this](Index p) { return this->Result.PointIds[p]; });
      if (this->Facets[f].IsOwned)
      {
        made.Surfaces[key] = this->Result.Surfaces.SurfaceId[f];
      }
    }
    return made;
  }

private:
  void AddPoints(const Body& body, std::vector<Index>& points)
  {
    IndexBox nodes = this->Grid.HexBox();
    for (Index& upper : nodes.Upper)
    {
      ++upper;
    }
    std::vector<Vector3> places;
    std::vector<Index> ids;
    ForCells(nodes,
      [&](const Index3& node)
      {
        points[this->Grid.Linear(node)] = static_cast<Index>(ids.size());
        ids.push_back(this->Grid.NodeKey(node) * HexIds.PointSlots + 1);
        places.push_back(body.Place({ { 1.0 * node[0], 1.0 * node[1], 1.0 * node[2] } }));
        this->Kinds.push_back(body.IsEdge(node) ? FeatureKind::Edge : FeatureKind::None);
      });
    this->Result.PointIds = Buffer<Index>(ids.size());
    this->Result.GeometryId = Buffer<int>(ids.size(), 1);
    this->Result.Points = Buffer<double>(3 * ids.size());
    std::copy(ids.begin(), ids.end(), this->Result.PointIds.begin());
    for (std::size_t p = 0; p < places.size(); ++p)
    {
      std::copy_n(places[p].begin(), 3, this->Result.Points.data() + 3 * p);
    }
  }

  const CartesianGrid& Grid;
  const Partition Parts;
  Mesh Result;
  std::vector<Facet> Facets;
  std::vector<FeatureKind> Kinds;
};

/// Returns the classification on one rank; checks that 2, 3 and 8 ranks agree.
Classified Classify(const std::string& name, const Index3& cells, const Body& body)
{
  const CartesianGrid whole = MakeUnitGrid(cells[0], cells[1], cells[2]);
  Ranks one;
  const Classified alone = FaceMesh(whole, whole, body, one).Classify();
  for (int count : { 2, 3, 8 })
  {
    const std::vector<IndexBox> boxes = CutBox(whole.Global(), count);
    std::vector<Classified> made(count);
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()]);
        made[ranks.Rank()] = FaceMesh(whole, grid, body, ranks).Classify();
      });
    std::map<std::array<Index, 4>, int> surfaces;
    GeometryTables tables, expected;
    JoinTables(alone.Tables, expected);
    for (const Classified& rank : made)
    {
      EXPECT_EQ(JoinTables(rank.Tables, tables), 0) << name << " on " << count;
      EXPECT_EQ(rank.Report.NumberOfVertices, alone.Report.NumberOfVertices);
      surfaces.insert(rank.Surfaces.begin(), rank.Surfaces.end());
    }
    EXPECT_TRUE(tables == expected) << name << " on " << count;
    EXPECT_EQ(surfaces, alone.Surfaces) << name << " on " << count;
  }
  std::printf("%-32s %lld surfaces, %lld curves, %lld vertices; the same on 1, 2, 3, 8 ranks\n",
    name.c_str(), static_cast<long long>(alone.Report.NumberOfSurfaces),
    static_cast<long long>(alone.Report.NumberOfCurves),
    static_cast<long long>(alone.Report.NumberOfVertices));
  return alone;
}

void ExpectCounts(const Classified& made, int surfaces, int curves, int vertices)
{
  EXPECT_EQ(made.Report.NumberOfSurfaces, surfaces);
  EXPECT_EQ(made.Report.NumberOfCurves, curves);
  EXPECT_EQ(made.Report.NumberOfVertices, vertices);
}

const IndexBox Cube{ { { 2, 2, 2 } }, { { 10, 10, 10 } } };
const Index3 CubeGrid{ { 12, 12, 12 } };

/// Counts the sides of a box on which a node lies.
int CountSides(const IndexBox& box, const Index3& node)
{
  int sides = 0;
  for (int a = 0; a < 3; ++a)
  {
    if (node[a] < box.Lower[a] || node[a] > box.Upper[a])
    {
      return 0;
    }
    sides += node[a] == box.Lower[a] || node[a] == box.Upper[a];
  }
  return sides;
}

Body MakeCube(const Carries& isEdge)
{
  return { [](const Index3& cell) { return Cube.Contains(cell); }, isEdge };
}

bool IsEdgeOfCube(const Index3& node)
{
  return CountSides(Cube, node) > 1;
}

/// Returns a prism whose square section is mapped to a disk.
Body MakeCylinder(const IndexBox& box)
{
  const Vector3 centre{ { .5 * (box.Lower[0] + box.Upper[0]), .5 * (box.Lower[1] + box.Upper[1]),
    0.0 } };
  return { [box](const Index3& cell) { return box.Contains(cell); },
    [box](const Index3& node)
    {
      const bool isEnd = node[2] == box.Lower[2] || node[2] == box.Upper[2];
      return isEnd && CountSides(box, node) > 1;
    },
    [centre](const Vector3& node)
    {
      const Vector3 d = node - centre;
      const double across = std::max(std::fabs(d[0]), std::fabs(d[1]));
      const double length = std::hypot(d[0], d[1]);
      const double scale = length > 0.0 ? across / length : 1.0;
      return Vector3{ { centre[0] + scale * d[0], centre[1] + scale * d[1], node[2] } };
    } };
}

} // namespace

TEST(SmoothSides, ACubeHasSixSidesTwelveCurvesEightVertices)
{
  const Classified made = Classify("cube", CubeGrid, MakeCube(IsEdgeOfCube));
  ExpectCounts(made, 6, 12, 8);
  const GeometryTables& tables = made.Tables;
  EXPECT_EQ(tables.SurfaceParts, (std::vector<int>{ 1, 2, 3, 4, 5, 6 }));
  EXPECT_EQ(tables.SurfaceVolumes, std::vector<GeometryTables::Pair>(6, { { 0, 1 } }));
  EXPECT_EQ(tables.CurveEnds, std::vector<int>(12, 2));
  EXPECT_EQ(tables.SurfaceCurves.size(), 24u);
  EXPECT_EQ(tables.CurveVertices.size(), 24u);
  EXPECT_TRUE(tables.EdgeFacets.empty());
  std::map<Vector3, int> normals;
  for (int s = 0; s < 6; ++s)
  {
    ++normals[tables.SurfaceNormals[s]];
    EXPECT_EQ(tables.SurfaceAreas[s], 64.0);
    const Vector3 centre{ { 6.0, 6.0, 6.0 } };
    EXPECT_LT(Norm(tables.SurfaceCentroids[s] - (centre + 4.0 * tables.SurfaceNormals[s])), 1e-10);
  }
  EXPECT_EQ(normals.size(), 6u);
}

TEST(SmoothSides, WithoutCarriersASurfaceGoesAllRound)
{
  const Classified made =
    Classify("cube without carriers", CubeGrid, MakeCube([](const Index3&) { return false; }));
  ExpectCounts(made, 1, 0, 0);
  EXPECT_EQ(made.Tables.SurfaceParts, std::vector<int>{ 0 });
  EXPECT_EQ(made.Tables.SurfaceAreas, std::vector<double>{ 384.0 });
  EXPECT_LT(Norm(made.Tables.SurfaceNormals[0]), 1e-12);
}

TEST(SmoothSides, RimsOfACylinderAreClosed)
{
  const IndexBox box{ { { 2, 2, 2 } }, { { 14, 14, 12 } } };
  const Classified made = Classify("cylinder", { { 16, 16, 14 } }, MakeCylinder(box));
  ExpectCounts(made, 3, 2, 0);
  EXPECT_EQ(made.Tables.CurveEnds, (std::vector<int>{ 0, 0 }));
}

/// An edge that ends within a side does not divide it; a gap in an edge is closed.
TEST(SmoothSides, AnOpenEdgeCutsNothingAndAGapIsClosed)
{
  const auto isOnOneEdge = [](const Index3& node)
  { return CountSides(Cube, node) > 1 && node[0] == 2 && node[1] == 2; };
  ExpectCounts(Classify("one edge of a cube", CubeGrid, MakeCube(isOnOneEdge)), 1, 0, 0);
  const auto hasGap = [&](const Index3& node)
  { return IsEdgeOfCube(node) && !(isOnOneEdge(node) && node[2] > 3 && node[2] < 9); };
  ExpectCounts(Classify("cube with a gap", CubeGrid, MakeCube(hasGap)), 6, 12, 8);
}

/// A shell's outer boundary has edges: then each connected part of the interface has its own sides.
/// Without edges both parts are one surface.
TEST(SmoothSides, AnInterfaceOfTwoPieces)
{
  const IndexBox hollow{ { { 4, 4, 4 } }, { { 8, 8, 8 } } };
  const auto has = [&](const Index3& cell)
  { return Cube.Contains(cell) && !hollow.Contains(cell); };
  const Body shell{ has, IsEdgeOfCube };
  ExpectCounts(Classify("hollow cube", CubeGrid, shell), 7, 12, 8);
  const Body smooth{ has, [](const Index3&) { return false; } };
  ExpectCounts(Classify("hollow cube without carriers", CubeGrid, smooth), 1, 0, 0);
}

/// A point enclosed by carriers belongs to the side around it.
TEST(SmoothSides, SliversJoinTheAdjacentSide)
{
  const auto isEdge = [](const Index3& node)
  {
    const bool isRing = node[2] == 10 && node[0] >= 5 && node[0] <= 7 && node[1] >= 5 &&
      node[1] <= 7 && !(node[0] == 6 && node[1] == 6);
    return IsEdgeOfCube(node) || isRing;
  };
  ExpectCounts(Classify("cube with an island", CubeGrid, MakeCube(isEdge)), 6, 12, 8);
}

TEST(SmoothSides, AnyKindsGiveEachFacetOneSurface)
{
  ExpectCounts(
    Classify("carriers everywhere", CubeGrid, MakeCube([](const Index3&) { return true; })), 1, 0,
    0);
  for (unsigned share : { 30u, 95u })
  {
    const auto isEdge = [share](const Index3& node)
    {
      std::mt19937 engine(static_cast<unsigned>(node[0] + 64 * (node[1] + 64 * node[2])));
      return engine() % 100 < share;
    };
    const Classified made =
      Classify("carriers " + std::to_string(share) + " %", CubeGrid, MakeCube(isEdge));
    EXPECT_EQ(made.Surfaces.size(), 384u);
    double area = 0.0;
    for (double part : made.Tables.SurfaceAreas)
    {
      EXPECT_GT(part, 0.0);
      area += part;
    }
    EXPECT_NEAR(area, 384.0, 1e-9);
    for (const auto& facet : made.Surfaces)
    {
      ASSERT_GE(facet.second, 1);
      ASSERT_LE(facet.second, made.Report.NumberOfSurfaces);
    }
  }
}
