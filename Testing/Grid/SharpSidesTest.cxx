/// Which facets belong to which smooth side of a solid with edges: a hexagonal nut.
#include "Base/Vector3.h"
#include "MeshCases.h"
#include "MeshChecks.h"
#include "RankMeshes.h"
#include "Shapes/ShapesFractions.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr double Across = 8.0, Height = 6.0, Hole = 4.5; // radius of the corners, height, hole
constexpr int Caps = 6, Bore = 8;                        // faces: six sides, two caps, the hole

/// A nut in the middle of n cells along the distance between two corners.
struct Nut
{
  CartesianGrid Grid;
  double Width; ///< of a cell
  FractionField Fractions;

  explicit Nut(int n) : Grid(MakeGrid(n)), Width(WidthOf(n)), Fractions(MakeFractions(this->Grid))
  {
  }

  static Vector3 SideNormal(int side)
  {
    const double angle = (side + 0.5) * M_PI / 3.0;
    return { { std::cos(angle), std::sin(angle), 0.0 } };
  }
  static double Apothem() { return Across * std::cos(M_PI / 6.0); }
  static double WidthOf(int n) { return 2.0 * Across / (n - 4); }

  /// Returns the distance of a point from a face, in cells.
  double Distance(const Vector3& x, int face) const
  {
    const double distance = face < Caps ? Dot(x, SideNormal(face)) - Apothem()
      : face == Bore                    ? std::hypot(x[0], x[1]) - Hole
                                        : x[2] - (face == Caps ? 0.0 : Height);
    return std::fabs(distance) / this->Width;
  }
  static Vector3 Normal(const Vector3& x, int face)
  {
    return face < Caps ? SideNormal(face)
      : face == Bore   ? Unit(Vector3{ { x[0], x[1], 0.0 } })
                       : Vector3{ { 0.0, 0.0, 1.0 } };
  }

private:
  static CartesianGrid MakeGrid(int n)
  {
    const double width = WidthOf(n), size[3] = { 2.0 * Across, 2.0 * Apothem(), Height };
    std::array<std::vector<double>, 3> nodes;
    for (int a = 0; a < 3; ++a)
    {
      const int cells = static_cast<int>(std::ceil(size[a] / width * (1.0 - 1e-9))) + 4;
      for (int i = 0; i <= cells; ++i)
      {
        nodes[a].push_back((a == 2 ? 0.5 * Height : 0.0) + width * (i - 0.5 * cells));
      }
    }
    return CartesianGrid(nodes);
  }
  static FractionField MakeFractions(const CartesianGrid& grid)
  {
    Shape prism = MakeHalfSpace(1, { { 0.0, 0.0, Height } }, { { 0.0, 0.0, 1.0 } });
    prism = CutShape(std::move(prism), { { 0.0, 0.0, 0.0 } }, { { 0.0, 0.0, -1.0 } });
    for (int side = 0; side < Caps; ++side)
    {
      prism = CutShape(std::move(prism), Apothem() * SideNormal(side), SideNormal(side));
    }
    const FractionField outer = FractionsOfShapes(grid, { prism });
    const FractionField hole = FractionsOfShapes(
      grid, { MakeCylinder(1, { { 0.0, 0.0, 0.5 * Height } }, Hole, Height, {}) });
    FractionField nut(grid, 1);
    ForCells(grid.Global(),
      [&](const Index3& cell)
      {
        const Index at = grid.Linear(cell);
        const double fraction = outer.Fraction(at, 1) - hole.Fraction(at, 1);
        if (fraction > 1e-12)
        {
          nut.SetParts(at, { { 1, fraction } });
        }
      });
    return nut;
  }
};

Vector3 Centre(const Mesh& mesh, std::size_t f)
{
  const int corners = mesh.CornersOfFacet();
  Vector3 sum{};
  for (int c = 0; c < corners; ++c)
  {
    sum = sum + (1.0 / corners) * mesh.PointAt(mesh.Surfaces.Points[corners * f + c]);
  }
  return sum;
}

Vector3 NormalOfFacet(const Mesh& mesh, std::size_t f)
{
  const int corners = mesh.CornersOfFacet();
  const auto x = [&](int c) { return mesh.PointAt(mesh.Surfaces.Points[corners * f + c]); };
  return Unit(Cross(x(2) - x(0), x(corners - 1) - x(1)));
}

/// Returns the face of the nut to which each surface of the mesh belongs: that of most facets.
std::map<int, int> FacesOfSurfaces(const Nut& nut, const Mesh& mesh)
{
  std::map<int, std::map<int, int>> votes;
  for (std::size_t f = 0; f < mesh.Surfaces.SurfaceId.size(); ++f)
  {
    const Vector3 x = Centre(mesh, f);
    int nearest = 0;
    for (int face = 1; face <= Bore; ++face)
    {
      nearest = nut.Distance(x, face) < nut.Distance(x, nearest) ? face : nearest;
    }
    ++votes[mesh.Surfaces.SurfaceId[f]][nearest];
  }
  std::map<int, int> faces;
  for (const auto& [surface, counts] : votes)
  {
    faces[surface] = std::max_element(counts.begin(), counts.end(),
      [](const auto& a, const auto& b) {
        return a.second < b.second;
      })->first;
  }
  return faces;
}

/// Counts the facets that are parallel to an adjacent face of the nut to 25 degrees, but belong to
/// the surface of a face that is at more than 45 degrees to them.
int CountWrongFacets(const Nut& nut, const Mesh& mesh)
{
  constexpr double isParallel = 0.906, isOblique = 0.707;
  const std::map<int, int> faces = FacesOfSurfaces(nut, mesh);
  int wrong = 0;
  for (std::size_t f = 0; f < mesh.Surfaces.SurfaceId.size(); ++f)
  {
    const Vector3 x = Centre(mesh, f), normal = NormalOfFacet(mesh, f);
    const auto cosineTo = [&](int face) { return std::fabs(Dot(normal, Nut::Normal(x, face))); };
    double best = 0.0;
    for (int face = 0; face <= Bore; ++face)
    {
      best = nut.Distance(x, face) < 0.5 ? std::max(best, cosineTo(face)) : best;
    }
    wrong += best > isParallel && cosineTo(faces.at(mesh.Surfaces.SurfaceId[f])) < isOblique;
  }
  return wrong;
}

} // namespace

TEST(SharpSides, FacetsOfANutLieOnTheirOwnSideOfEachEdge)
{
  for (int cells : { 24, 32, 40, 44, 56 })
  {
    const Nut nut(cells);
    for (MeshMaker make : { MakeHexMesh, MakeTetMesh })
    {
      SCOPED_TRACE(std::to_string(cells) + (make == MakeHexMesh ? " hexes" : " Lattice"));
      MeshOptions options;
      options.SharpEdges = SharpEdgeMode::On;
      Runtime runtime;
      MeshReport report;
      const Mesh mesh = make(nut.Grid, nut.Fractions, options, runtime, report);
      EXPECT_EQ(report.NumberOfSurfaces, 9);
      EXPECT_EQ(report.NumberOfCurves, 20);
      EXPECT_EQ(report.NumberOfVertices, 12);
      EXPECT_EQ(CountWrongFacets(nut, mesh), 0);
    }
  }
}
