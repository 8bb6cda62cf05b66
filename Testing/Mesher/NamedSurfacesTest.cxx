/// Named surfaces contain each face once, skins are closed and point outward, and the entities of a
/// mesh equal the geometry of the mesher; on any ranks.
#include "Report/Sets/NamedSurfaces.h"
#include "RankMeshes.h"
#include "Report/MeshFields.h"
#include "Report/Sets/MeshEntities.h"
#include "SharpCases.h"
#include "State/ViewMesh.h"

#include <gtest/gtest.h>

#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// A group over all ranks: kind, id, name and number of faces.
using Row = std::tuple<SurfaceKind, int, std::string, std::int64_t>;

using Work = std::function<void(const Mesh&, const MeshData&, Ranks&)>;

void WithMesh(int count, const CartesianGrid& whole, const FractionField& field, MeshMaker make,
  const MeshOptions& options, const Work& work)
{
  const std::vector<IndexBox> boxes = CutBox(whole.Global(), count);
  RunOnRanks(count,
    [&](Ranks& ranks)
    {
      const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()]);
      RankRuntime runtime(ranks);
      MeshReport report;
      const Mesh mesh = make(grid, CopyToLocal(whole, field, grid), options, runtime, report);
      MeshData data = ViewMesh(mesh, OutputState(), ListSides(mesh.Tables));
      for (FieldArray& domain : ListDomain(whole, ImageFrame()))
      {
        data.Fields.push_back(std::move(domain));
      }
      data.Fields.push_back({ "MaterialNames", std::vector<std::string>{ "one", "two", "one" } });
      data.Fields.push_back({ "MaterialIds", std::vector<int>{ 1, 2, 3 } });
      work(mesh, data, ranks);
    });
}

std::vector<Row> ListRows(const MeshData& data, Ranks& ranks)
{
  std::vector<Row> rows;
  for (const NamedSurface& surface : FindNamedSurfaces(data, ranks))
  {
    std::vector<std::int64_t> faces{ static_cast<std::int64_t>(surface.Sides.size()) };
    ranks.Sum(faces);
    rows.emplace_back(surface.Kind, surface.Id, surface.Name, faces[0]);
  }
  return rows;
}

/// Returns six times the volume inside faces, quads as two pairs of triangles.
double MeasureInside(const MeshData& data, const std::vector<ElementSide>& sides)
{
  double volume = 0.0;
  for (const ElementSide& side : sides)
  {
    const FaceIds points = PointsOfSide(data, side);
    const auto add = [&](int a, int b, int c, double share)
    {
      const double *x = data.Point(points[a]), *y = data.Point(points[b]),
                   *z = data.Point(points[c]);
      volume += share *
        (x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) +
          x[2] * (y[0] * z[1] - y[1] * z[0]));
    };
    if (data.Corners == 4)
    {
      add(0, 1, 2, 1.0);
      continue;
    }
    for (int c = 0; c < 4; ++c)
    {
      add(c, (c + 1) % 4, (c + 2) % 4, 0.5);
    }
  }
  return volume / 6.0;
}

std::int64_t CountFaces(const std::vector<Row>& rows, const std::set<SurfaceKind>& kinds)
{
  std::int64_t faces = 0;
  for (const Row& row : rows)
  {
    faces += kinds.count(std::get<0>(row)) > 0 ? std::get<3>(row) : 0;
  }
  return faces;
}

} // namespace

TEST(NamedSurfaces, AreTheSameOnAnyNumberOfRanks)
{
  const MeshCase c = MakePolycrystalCase(3, 8);
  for (const MeshMaker make : { MakeHexMesh, MakeTetMesh })
  {
    std::vector<std::vector<Row>> found;
    for (int count : { 1, 3 })
    {
      std::vector<Row> first;
      WithMesh(count, c.Grid, c.Fractions, make, {},
        [&](const Mesh&, const MeshData& data, Ranks& ranks)
        {
          const std::vector<Row> rows = ListRows(data, ranks);
          if (ranks.Rank() == 0)
          {
            first = rows;
          }
        });
      found.push_back(first);
    }
    EXPECT_EQ(found[0], found[1]);
    std::vector<std::pair<int, std::string>> names;
    for (const Row& row : found[0])
    {
      names.emplace_back(std::get<1>(row), std::get<2>(row));
    }
    EXPECT_EQ(names,
      (std::vector<std::pair<int, std::string>>{ { 1, "x_min" }, { 2, "x_max" }, { 3, "y_min" },
        { 4, "y_max" }, { 5, "z_min" }, { 6, "z_max" }, { 1002, "one_to_two" },
        { 1003, "one_to_one" }, { 2003, "two_to_one_2" }, { 7, "interfaces" }, { 8, "one_skin" },
        { 9, "two_skin" }, { 10, "one_skin_2" } }));
  }
}

TEST(NamedSurfaces, ContainEachFaceOnce)
{
  const MeshCase c = MakePolycrystalCase(3, 8);
  for (const MeshMaker make : { MakeHexMesh, MakeTetMesh })
  {
    WithMesh(1, c.Grid, c.Fractions, make, {},
      [](const Mesh& mesh, const MeshData& data, Ranks& ranks)
      {
        const std::vector<Row> rows = ListRows(data, ranks);
        const auto between = CountFaces(rows, { SurfaceKind::Interface });
        EXPECT_EQ(between + CountFaces(rows, { SurfaceKind::DomainSide }),
          static_cast<std::int64_t>(mesh.Surfaces.SurfaceId.size()));
        EXPECT_EQ(between, CountFaces(rows, { SurfaceKind::AllInterfaces }));
        EXPECT_EQ(
          static_cast<std::int64_t>(data.Facets->size()), CountFaces(rows, { SurfaceKind::Skin }));
        double volume = 0.0;
        for (const NamedSurface& surface : FindNamedSurfaces(data, ranks))
        {
          if (surface.Kind == SurfaceKind::Skin)
          {
            const double inside = MeasureInside(data, surface.Sides);
            EXPECT_GT(inside, 0.0) << surface.Name;
            volume += inside;
          }
          for (const ElementSide& side : surface.Sides)
          {
            const int material = data.Material[side.Element];
            const bool isOfMaterial = surface.Materials[0] == material;
            EXPECT_TRUE(isOfMaterial || surface.Materials[0] == 0) << surface.Name;
          }
        }
        EXPECT_NEAR(volume, 512.0, 1e-9);
      });
  }
}

/// The free surface and the faces to a meshed void have the same name, and the faces of a free
/// surface are not in "interfaces".
TEST(NamedSurfaces, OfAMeshedVoid)
{
  const MeshCase c = MakeSphereCase(8);
  for (bool meshVoid : { false, true })
  {
    MeshOptions options;
    options.MeshVoid = meshVoid;
    WithMesh(1, c.Grid, c.Fractions, MakeHexMesh, options,
      [&](const Mesh&, const MeshData& data, Ranks& ranks)
      {
        std::map<std::string, std::int64_t> faces;
        for (const Row& row : ListRows(data, ranks))
        {
          faces[std::get<2>(row)] = std::get<3>(row);
        }
        EXPECT_GT(faces["one_to_Void"], 100);
        EXPECT_EQ(faces["one_to_Void"], faces["one_skin"]);
        EXPECT_EQ(faces.count("Void_to_one"), 0u);
        EXPECT_EQ(faces["interfaces"], meshVoid ? faces["one_to_Void"] : 0);
        EXPECT_EQ(faces.count("Void_skin"), meshVoid ? 1u : 0u);
      });
  }
}

TEST(MeshEntities, AreTheGeometryOfTheMesher)
{
  const SharpCase sharp = MakeSharpCase("cube A in matrix", 12);
  const MeshCase grains = MakePolycrystalCase(5, 8);
  MeshOptions options;
  options.SharpEdges = SharpEdgeMode::On;
  for (const MeshMaker make : { MakeHexMesh, MakeTetMesh })
  {
    const auto compare = [](const Mesh& mesh, const MeshData& data, Ranks&)
    {
      const MeshEntities entities = FindMeshEntities(data);
      const GeometryTables& tables = mesh.Tables;
      ASSERT_EQ(entities.Surfaces.size(), tables.SurfaceVolumes.size());
      EXPECT_EQ(entities.Curves.size(), tables.CurveEnds.size());
      EXPECT_GT(entities.Curves.size(), 11u);
      EXPECT_TRUE(std::equal(entities.PointDimension.begin(), entities.PointDimension.end(),
        mesh.GeometryDimension.begin()));
      EXPECT_TRUE(std::equal(
        entities.PointEntity.begin(), entities.PointEntity.end(), mesh.GeometryId.begin()));
      EXPECT_TRUE(std::equal(entities.Vertices.begin(), entities.Vertices.end(),
        mesh.Vertices.Points.begin(), mesh.Vertices.Points.end()));
      std::vector<Index> faces(entities.Surfaces.size(), 0);
      for (int surface : mesh.Surfaces.SurfaceId)
      {
        ++faces[surface - 1];
      }
      std::vector<GeometryTables::Pair> curves, ends;
      for (std::size_t s = 0; s < faces.size(); ++s)
      {
        EXPECT_EQ(static_cast<Index>(entities.Surfaces[s].Sides.size()), faces[s]);
        EXPECT_EQ(entities.Surfaces[s].DomainSide, tables.SurfaceSides[s]);
      }
      for (std::size_t curve = 0; curve < entities.Curves.size(); ++curve)
      {
        const int number = static_cast<int>(curve) + 1;
        for (int surface : entities.Curves[curve].Surfaces)
        {
          curves.push_back({ { surface, number } });
        }
        for (int vertex : entities.Curves[curve].Vertices)
        {
          ends.push_back({ { number, vertex } });
        }
      }
      std::sort(curves.begin(), curves.end());
      EXPECT_EQ(curves, tables.SurfaceCurves);
      EXPECT_EQ(ends, tables.CurveVertices);
    };
    WithMesh(1, sharp.Grid, sharp.Fractions, make, options, compare);
    WithMesh(1, grains.Grid, grains.Fractions, make, {}, compare);
  }
}
