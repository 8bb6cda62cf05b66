/// Polyhedra around the nodes of tetrahedra: closed cells, volumes of regions, files, messages.
#include "Meshes/Polyhedra/DualMesh.h"
#include "Atlas.h"
#include "FileCases.h"
#include "Meshes/OpenFoam/FoamPatches.h"
#include "Meshes/OpenFoam/FoamReader.h"
#include "Meshes/Polyhedra/ApartCells.h"
#include "Meshes/Polyhedra/DualMeasures.h"
#include "Meshes/Polyhedra/FitWalls.h"
#include "Meshes/Polyhedra/MoveTetPoints.h"
#include "Meshes/Polyhedra/WriteDual.h"
#include "Meshes/WriteMesh.h"

#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

double VolumeOfTet(const MeshData& mesh, Index tet)
{
  const Index* nodes = mesh.Element(tet);
  const Vector3 first = mesh.PointAt(nodes[0]);
  return Dot(Cross(mesh.PointAt(nodes[1]) - first, mesh.PointAt(nodes[2]) - first),
           mesh.PointAt(nodes[3]) - first) /
    6.0;
}

WallSurface SurfaceOf(const FoamSurfaces& surfaces, const ElementSide& side)
{
  const SideSurface* found = surfaces.Find(side);
  const int number = found ? found->Surface : -1;
  return { number, number, !found || surfaces.Surfaces[number].IsDomainSide };
}

DualMesh MakeDual(const MeshData& mesh)
{
  Ranks alone;
  const FoamSurfaces surfaces = FindFoamSurfaces(mesh, alone);
  return MakeDualMesh(
    mesh, [&surfaces](const ElementSide& side) { return SurfaceOf(surfaces, side); });
}

/// Calls check(mesh, dual) for the grains.
template <class Check>
void WithDual(const Check& check)
{
  WithMesh(1, MakeTetMesh,
    [&check](const FileCase& part, Ranks&) { check(part.Mesh, MakeDual(part.Mesh)); });
}

/// Calls check(mesh, dual) for a small atlas: 20 regions that meet at sharp corners.
template <class Check>
void WithAtlas(const Check& check)
{
  const CartesianGrid grid = MakePolycrystalCase(2, 12).Grid;
  RunOnRanks(1,
    [&](Ranks& ranks)
    {
      RankRuntime runtime(ranks);
      MeshReport report;
      const Mesh made = MakeTetMesh(grid, MakeAtlas(grid, 20, 1), {}, runtime, report);
      const MeshData mesh = ViewMesh(made);
      check(mesh,
        MakeDualMesh(mesh,
          [](const ElementSide&) {
            return WallSurface{ 0, 0, false };
          }));
    });
}

/// Expects that each edge of a cell is in two of its faces, in opposite directions.
void ExpectClosed(const DualMesh& dual)
{
  std::map<std::array<Index, 3>, int> uses;
  ForFaces(dual,
    [&](Index face, Index cell, double sign)
    {
      const std::span<const Index> points = dual.PointsOf(face);
      ASSERT_GE(points.size(), 3u);
      EXPECT_EQ(std::set<Index>(points.begin(), points.end()).size(), points.size());
      for (std::size_t p = 0; p < points.size(); ++p)
      {
        const Index from = points[p], to = points[(p + 1) % points.size()];
        ++uses[sign > 0 ? std::array<Index, 3>{ { cell, from, to } }
                        : std::array<Index, 3>{ { cell, to, from } }];
      }
    });
  for (const auto& [edge, count] : uses)
  {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(uses.count({ { edge[0], edge[2], edge[1] } }), 1u);
  }
  std::vector<Vector3> openings(dual.Cells.Nodes.size(), Vector3{});
  ForFaces(dual,
    [&](Index face, Index cell, double sign)
    { openings[cell] = openings[cell] + sign * MeasureFace(dual, face).Area; });
  for (const Vector3& opening : openings)
  {
    EXPECT_LT(Norm(opening), 1e-13);
  }
}

/// Expects that regions have the volumes of their tetrahedra.
void ExpectVolumes(const MeshData& mesh, const DualMesh& dual)
{
  std::map<std::pair<int, int>, std::array<double, 2>> sums; // polyhedra, tetrahedra
  const CellMeasures cells = MeasureCells(dual);
  const auto regionOf = [&mesh](Index tet)
  { return std::pair<int, int>(mesh.Material[tet], mesh.Fragment ? mesh.Fragment[tet] : 0); };
  for (Index cell = 0; cell < dual.NumberOfCells(); ++cell)
  {
    EXPECT_GT(cells.Volumes[cell], 0.0);
    sums[regionOf(dual.Cells.Tets[cell])][0] += cells.Volumes[cell];
  }
  for (Index tet = 0; tet < mesh.NumberOfElements; ++tet)
  {
    sums[regionOf(tet)][1] += VolumeOfTet(mesh, tet);
  }
  EXPECT_GE(sums.size(), 3u);
  for (const auto& [region, sum] : sums)
  {
    EXPECT_NEAR(sum[0] / sum[1], 1.0, 1e-12);
  }
}

Index CountPoor(const DualMesh& dual)
{
  const CellMeasures cells = MeasureCells(dual);
  Index count = 0;
  for (Index face = 0; face < dual.NumberOfFaces(); ++face)
  {
    EXPECT_TRUE(!IsRejected(dual, cells, face) || IsPoor(dual, cells, face));
    count += IsPoor(dual, cells, face);
  }
  return count;
}

TEST(DualMesh, CellsAreClosed)
{
  WithDual([](const MeshData&, const DualMesh& dual) { ExpectClosed(dual); });
}

TEST(DualMesh, RegionsKeepTheirVolumes)
{
  WithDual(ExpectVolumes);
}

/// Where regions meet at sharp corners, rounding does not make all cells good. Some of them are
/// split.
TEST(DualMesh, CornersOfManyRegions)
{
  WithAtlas(
    [](const MeshData& mesh, const DualMesh& dual)
    {
      EXPECT_EQ(CountPoor(dual), 0);
      ExpectClosed(dual);
      ExpectVolumes(mesh, dual);
      const std::size_t whole = FindDualCells(DualTets(mesh)).Nodes.size();
      EXPECT_GT(dual.Cells.Nodes.size(), whole);
      EXPECT_LT(dual.Cells.Nodes.size(), whole + whole / 100);
      EXPECT_TRUE(std::is_sorted(dual.Cells.Nodes.begin(), dual.Cells.Nodes.end()));
    });
}

/// Good cells keep their points; cells with a point at a wrong place become good.
TEST(DualMesh, MovesTetPoints)
{
  WithDual(
    [](const MeshData& mesh, const DualMesh& dual)
    {
      const DualTets tets(mesh);
      DualMesh moved = dual;
      MoveTetPoints(tets, moved);
      EXPECT_EQ(moved.Points, dual.Points);
      const Index tet = mesh.NumberOfElements / 2;
      const Vector3 place = PointOfDual(dual, tet), node = mesh.PointAt(tets.Node(tet, 0));
      const Vector3 wrong = node + 0.1 * (place - node);
      std::copy(wrong.begin(), wrong.end(), moved.Points.begin() + 3 * tet);
      ASSERT_GT(CountPoor(moved), 0);
      MoveTetPoints(tets, moved);
      EXPECT_EQ(CountPoor(moved), 0);
      ExpectVolumes(mesh, moved);
    });
}

/// The tetrahedra around a node inside of a region, the sides between them and the edges to the
/// node fulfil Euler's formula.
TEST(DualMesh, PointsOfPartsAroundANode)
{
  WithDual(
    [](const MeshData& mesh, const DualMesh& dual)
    {
      const DualTets tets(mesh);
      const DualWalls walls = FindDualWalls(
        tets,
        [](const ElementSide&) {
          return WallSurface{ 0, 0, false };
        },
        std::vector<NodeEdges>(mesh.NumberOfPoints, NodeEdges::ByAngle), tets.Count());
      std::set<Index> onWalls;
      for (const WallTriangle& triangle : walls.Triangles)
      {
        onWalls.insert(triangle.Nodes.begin(), triangle.Nodes.end());
      }
      Index cell = 0;
      while (onWalls.count(dual.Cells.Nodes[cell]))
      {
        ASSERT_LT(++cell, dual.NumberOfCells());
      }
      std::vector<char> isApart;
      for (const Index at : dual.Cells.OfCorner)
      {
        isApart.push_back(at == cell);
      }
      std::vector<double> points(3 * walls.NumberOfPoints);
      const ApartPoints apart = AddApartPoints(tets, walls, isApart, points);
      const auto count = std::count(isApart.begin(), isApart.end(), 1);
      EXPECT_EQ(apart.Nodes.size(), 1u);
      EXPECT_EQ(2 * static_cast<long>(apart.Centres.size()), 3 * count);
      EXPECT_EQ(
        static_cast<long>(apart.Middles.size()) - static_cast<long>(apart.Centres.size()) + count,
        2);
      EXPECT_EQ(points.size(),
        3 * (walls.NumberOfPoints + 1 + apart.Middles.size() + apart.Centres.size()));
      EXPECT_EQ(FindDualCells(tets, isApart).Nodes.size(),
        dual.Cells.Nodes.size() + static_cast<std::size_t>(count) - 1);
    });
}

/// All cells contain their centres, lines between centres meet faces, and there are fewer cells
/// than tetrahedra.
TEST(DualMesh, CellsAreGood)
{
  WithDual(
    [](const MeshData& mesh, const DualMesh& dual)
    {
      EXPECT_GT(mesh.NumberOfElements, 3 * dual.NumberOfCells());
      EXPECT_GE(dual.NumberOfCells(), mesh.NumberOfPoints);
      const CellMeasures cells = MeasureCells(dual);
      for (Index face = 0; face < dual.NumberOfFaces(); ++face)
      {
        EXPECT_FALSE(IsPoor(dual, cells, face)) << face;
      }
    });
}

/// A node inside has one cell, a node on an interface one per material.
TEST(DualMesh, OneCellPerNodeAndMaterial)
{
  WithDual(
    [](const MeshData& mesh, const DualMesh& dual)
    {
      std::vector<std::set<int>> materials(mesh.NumberOfPoints);
      for (Index tet = 0; tet < mesh.NumberOfElements; ++tet)
      {
        for (int c = 0; c < 4; ++c)
        {
          materials[mesh.Element(tet)[c]].insert(mesh.Material[tet]);
        }
      }
      Index expected = 0;
      for (const std::set<int>& around : materials)
      {
        expected += static_cast<Index>(around.size());
      }
      EXPECT_EQ(dual.NumberOfCells(), expected); // no grain of this case is pinched at a node
      EXPECT_TRUE(std::is_sorted(dual.Cells.Nodes.begin(), dual.Cells.Nodes.end()));
    });
}

void Write(int ranks, const std::string& path, OutputForm form)
{
  form.IsDual = true;
  WithMesh(ranks, MakeTetMesh,
    [&](const FileCase& part, Ranks& all) { WriteMesh(part.Mesh, path, all, form); });
}

TEST(WriteDual, FoamCase)
{
  const Folder tets, cells;
  WithMesh(1, MakeTetMesh,
    [&](const FileCase& part, Ranks& all) { WriteMesh(part.Mesh, tets / "mesh.foam", all); });
  Write(1, cells / "mesh.foam", {});
  const FoamContent before = ReadFoam(tets / ""), after = ReadFoam(cells / "");
  std::vector<std::array<Index, 2>> inner;
  for (std::size_t face = 0; face < after.Neighbours.size(); ++face)
  {
    EXPECT_LT(after.Owners[face], after.Neighbours[face]);
    inner.push_back({ { after.Owners[face], after.Neighbours[face] } });
  }
  EXPECT_TRUE(std::is_sorted(inner.begin(), inner.end()));
  ASSERT_EQ(after.Patches.size(), before.Patches.size());
  Index next = static_cast<Index>(after.Neighbours.size());
  for (std::size_t p = 0; p < after.Patches.size(); ++p)
  {
    EXPECT_EQ(after.Patches[p].Name, before.Patches[p].Name);
    EXPECT_EQ(after.Patches[p].First(), next);
    EXPECT_LT(after.Patches[p].Count(), before.Patches[p].Count());
    next += after.Patches[p].Count();
  }
  EXPECT_EQ(next, static_cast<Index>(after.Faces.size()));
  ASSERT_EQ(after.FaceZones.size(), before.FaceZones.size());
  for (std::size_t z = 0; z < after.FaceZones.size(); ++z)
  {
    EXPECT_EQ(after.FaceZones[z].Name, before.FaceZones[z].Name);
    EXPECT_LT(after.FaceZones[z].Members.size(), before.FaceZones[z].Members.size());
  }
  ASSERT_EQ(after.CellZones.size(), before.CellZones.size());
  std::vector<int> zones(1 + *std::max_element(after.Owners.begin(), after.Owners.end()), -1);
  for (std::size_t z = 0; z < after.CellZones.size(); ++z)
  {
    EXPECT_EQ(after.CellZones[z].Name, before.CellZones[z].Name);
    for (const Index cell : after.CellZones[z].Members)
    {
      EXPECT_EQ(zones[cell], -1);
      zones[cell] = static_cast<int>(z);
    }
  }
  EXPECT_EQ(std::count(zones.begin(), zones.end(), -1), 0);
}

TEST(WriteDual, SameBytesOnRanks)
{
  for (const bool isBinary : { false, true })
  {
    const Folder one, three;
    const OutputForm form{ .IsSingle = true, .IsBinary = isBinary };
    Write(1, one / "mesh.foam", form);
    Write(3, three / "mesh.foam", form);
    for (const char* name : { "points", "faces", "owner", "neighbour", "boundary", "cellZones" })
    {
      const std::string file = std::string("constant/polyMesh/") + name;
      EXPECT_EQ(ReadBytes(one / file), ReadBytes(three / file)) << file;
    }
  }
  const Folder folder;
  Write(1, folder / "one.vtu", {});
  Write(3, folder / "three.vtu", {});
  EXPECT_EQ(ReadBytes(folder / "one.vtu"), ReadBytes(folder / "three.vtu"));
  EXPECT_NE(ReadBytes(folder / "one.vtu").find("faceoffsets"), std::string::npos);
}

/// Returns the error of writing a mesh, on all ranks the same.
std::string ErrorOf(
  int ranks, MeshMaker make, const std::string& name, const MeshOptions& options = {})
{
  const Folder folder;
  std::string message;
  WithMesh(
    ranks, make,
    [&](const FileCase& part, Ranks& all)
    {
      std::string mine;
      try
      {
        WriteMesh(part.Mesh, folder / name, all, { .IsDual = true });
      }
      catch (const InputError& error)
      {
        mine = error.what();
      }
      EXPECT_NE(mine, "");
      if (all.Rank() == 0)
      {
        message = mine;
      }
    },
    options);
  EXPECT_EQ(folder.CountFiles(), 0u);
  return message;
}

TEST(WriteDual, Messages)
{
  const auto has = [](const std::string& text, const char* part)
  { return text.find(part) != std::string::npos; };
  EXPECT_TRUE(has(ErrorOf(2, MakeHexMesh, "mesh.vtu"), "this mesh has hexahedra"));
  EXPECT_TRUE(has(ErrorOf(1, MakeHexMesh, "mesh.foam"), "this mesh has hexahedra"));
  EXPECT_TRUE(has(ErrorOf(2, MakeTetMesh, "mesh.foam"), "--single-file"));
  EXPECT_TRUE(has(ErrorOf(1, MakeTetMesh, "mesh.msh"), "has no polyhedra"));
  WithMesh(1, MakeTetMesh,
    [&has](const FileCase& part, Ranks&)
    {
      MeshData changed = part.Mesh;
      const auto problem = [&changed]
      {
        try
        {
          RequireDual(changed);
        }
        catch (const InputError& error)
        {
          return std::string(error.what());
        }
        return std::string();
      };
      EXPECT_EQ(problem(), "");
      changed.OriginalPointIds = changed.PointIds;
      EXPECT_TRUE(has(problem(), "split interfaces"));
      changed.OriginalPointIds = nullptr;
      changed.MidsPerElement = 6;
      EXPECT_TRUE(has(problem(), "second order"));
    });
}

} // namespace
