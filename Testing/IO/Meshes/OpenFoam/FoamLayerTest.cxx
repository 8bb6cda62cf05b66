/// Meshes of a plane as cases of OpenFOAM: a layer of prisms with patches of type empty.
#include "Meshes/OpenFoam/FoamLayer.h"
#include "Base/Vector3.h"
#include "FoamReader.h"
#include "Meshes/OpenFoam/WriteFoam.h"
#include "Report/FlatData.h"

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Two squares of materials 1 and 2, 2 wide, in a plane across an axis at 0.5. The second one ends
/// inside of the domain. As triangles each square has two.
struct TwoSquares
{
  explicit TwoSquares(int axis, bool areTriangles = false)
  {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int point = 0; point < 6; ++point)
    {
      Vector3 x{};
      x[axis] = 0.5;
      x[u] = 2.0 * (point % 3);
      x[v] = 2.0 * (point / 3);
      this->Points.insert(this->Points.end(), x.begin(), x.end());
      this->PointIds.push_back(1 + 10 * point);
    }
    this->Elements = areTriangles ? std::vector<Index>{ 0, 1, 3, 1, 4, 3, 1, 2, 4, 2, 5, 4 }
                                  : std::vector<Index>{ 0, 1, 4, 3, 1, 2, 5, 4 };
    this->Material = areTriangles ? std::vector<int>{ 1, 1, 2, 2 } : std::vector<int>{ 1, 2 };
    this->Data.Corners = areTriangles ? 3 : 4;
    this->Data.NumberOfPoints = 6;
    this->Data.NumberOfElements = static_cast<Index>(this->Material.size());
    this->Data.Points = this->Points.data();
    this->Data.Elements = this->Elements.data();
    this->Data.PointIds = this->PointIds.data();
    this->Data.ElementIds = this->ElementIds.data();
    this->Data.Material = this->Material.data();
    std::vector<double> bounds(6, 0.5);
    bounds[2 * u] = bounds[2 * v] = 0.0;
    bounds[2 * u + 1] = 6.0;
    bounds[2 * v + 1] = 2.0;
    this->Data.Fields = { { FlatAxisName, std::vector<int>{ axis } }, { "DomainBounds", bounds, 6 },
      { "MaterialNames", std::vector<std::string>{ "a", "b" } },
      { "MaterialIds", std::vector<int>{ 1, 2 } } };
  }

  std::vector<double> Points;
  std::vector<Index> Elements, PointIds, ElementIds{ 3, 4, 7, 9 };
  std::vector<int> Material;
  MeshData Data;
};

Vector3 PointOf(const FoamContent& content, Index point)
{
  const double* x = content.Points.data() + 3 * point;
  return { { x[0], x[1], x[2] } };
}

/// Returns the vector of the area of a face.
Vector3 AreaOf(const FoamContent& content, const std::vector<Index>& face)
{
  Vector3 area{};
  const Vector3 first = PointOf(content, face[0]);
  for (std::size_t i = 2; i < face.size(); ++i)
  {
    area =
      area + 0.5 * Cross(PointOf(content, face[i - 1]) - first, PointOf(content, face[i]) - first);
  }
  return area;
}

/// Checks that each cell is closed and has a volume, with normals out of the owners.
void CheckCells(const FoamContent& content, double volume)
{
  const std::size_t cells = 1 + *std::max_element(content.Owners.begin(), content.Owners.end());
  std::vector<Vector3> areas(cells);
  std::vector<double> volumes(cells, 0.0);
  for (std::size_t f = 0; f < content.Faces.size(); ++f)
  {
    const Vector3 area = AreaOf(content, content.Faces[f]);
    const double part = Dot(area, PointOf(content, content.Faces[f][0])) / 3.0;
    areas[content.Owners[f]] = areas[content.Owners[f]] + area;
    volumes[content.Owners[f]] += part;
    if (f < content.Neighbours.size())
    {
      areas[content.Neighbours[f]] = areas[content.Neighbours[f]] - area;
      volumes[content.Neighbours[f]] -= part;
    }
  }
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    EXPECT_NEAR(Norm(areas[cell]), 0.0, 1e-12);
    EXPECT_NEAR(volumes[cell], volume, 1e-12);
  }
}

std::map<std::string, std::string> TypesOf(const FoamContent& content)
{
  std::map<std::string, std::string> types;
  for (const FoamPatchEntry& patch : content.Patches)
  {
    types[patch.Name] = patch.Words.at("type") + " " + patch.Words.at("nFaces");
  }
  return types;
}

FoamContent Write(const MeshData& mesh, bool isBinary)
{
  const Folder folder;
  Ranks alone;
  WriteFoam(mesh, folder / "mesh.foam", alone, { false, isBinary });
  return ReadFoam(folder / "");
}

TEST(FoamLayer, SquaresBecomeHexahedraWithEmptySides)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const TwoSquares squares(axis);
    const FoamContent found = Write(squares.Data, false);
    ASSERT_EQ(found.Points.size(), 36u);
    EXPECT_EQ(found.Neighbours, std::vector<Index>{ 1 });
    EXPECT_EQ(found.Faces.size(), 11u);
    CheckCells(found, 8.0); // as high as wide
    const std::string u(1, "xyz"[(axis + 1) % 3]), v(1, "xyz"[(axis + 2) % 3]);
    const std::string across(1, "xyz"[axis]);
    EXPECT_EQ(TypesOf(found),
      (std::map<std::string, std::string>{ { u + "_min", "patch 1" }, { v + "_min", "patch 2" },
        { v + "_max", "patch 2" }, { "b_to_Void", "wall 1" }, { across + "_min", "empty 2" },
        { across + "_max", "empty 2" } }));
    ASSERT_EQ(found.CellZones.size(), 2u);
    EXPECT_EQ(found.CellZones[1].Name, "b");
    EXPECT_EQ(found.CellZones[1].Members, std::vector<Index>{ 1 });
    ASSERT_EQ(found.FaceZones.size(), 1u);
    EXPECT_EQ(found.FaceZones[0].Name, "a_to_b");
    EXPECT_EQ(found.FaceZones[0].Members, std::vector<Index>{ 0 });
    for (Index point = 0; point < 6; ++point)
    {
      EXPECT_EQ(PointOf(found, point)[axis], 0.5);
      EXPECT_EQ(PointOf(found, point + 6)[axis], 2.5);
      EXPECT_EQ(*std::min_element(found.Faces[point].begin(), found.Faces[point].end()),
        found.Faces[point][0]);
    }
  }
}

TEST(FoamLayer, TrianglesBecomePrismsInBothForms)
{
  const TwoSquares squares(2, true);
  const FoamContent text = Write(squares.Data, false), binary = Write(squares.Data, true);
  EXPECT_EQ(text.Neighbours.size(), 3u);
  ASSERT_EQ(text.Faces.size(), 3u + 6u + 8u);
  EXPECT_EQ(text.Faces[8].size(), 4u);
  EXPECT_EQ(text.Faces[9].size(), 3u);
  CheckCells(text, 2.0 * std::sqrt(2.0));
  EXPECT_EQ(binary.Faces, text.Faces);
  EXPECT_EQ(binary.Points, text.Points);
  EXPECT_EQ(binary.Owners, text.Owners);
  EXPECT_EQ(TypesOf(binary), TypesOf(text));
}

TEST(FoamLayer, ThicknessIsThatOfTheLayer)
{
  TwoSquares squares(2, true);
  squares.Data.Fields.push_back({ FlatThicknessName, std::vector<double>{ 0.25 } });
  CheckCells(Write(squares.Data, false), 2.0 * 0.25); // areas of 2
}

TEST(FoamLayer, FacesOfALayerBeginWithTheLowestPoint)
{
  const TwoSquares squares(2);
  Ranks alone;
  FoamMesh foam = MakeFoamMesh(squares.Data, alone);
  EXPECT_EQ(foam.NumberOfFaces(), 11);
  const std::vector<double> points = PointsOfLayer(squares.Data);
  EXPECT_EQ(points.size(), 36u);
  for (Index face = 0; face < foam.NumberOfFaces(); ++face)
  {
    const std::vector<Index> ids = PointsOfLayerFace(foam, face);
    EXPECT_EQ(ids[0], *std::min_element(ids.begin(), ids.end()));
  }
}

} // namespace
