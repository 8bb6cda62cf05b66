#include "GeometryChecks.h"

#include "Base/HexNumbering.h"
#include "Elements/TetQuality.h"

#include <set>

namespace vfm
{
namespace testing
{
namespace
{

using Edge = std::array<Index, 2>;
using Pair = GeometryTables::Pair;
using Pairs = std::set<Pair>;
using FragmentOfMaterial = std::map<int, int>;

/// Returns the fragments on the sides of each face by their materials; key:
/// the sorted points of the face.
std::map<std::set<Index>, FragmentOfMaterial> FindSides(const MergedMesh& mesh)
{
  const ElementShape& shape = ShapeOf(mesh.Corners);
  std::map<std::set<Index>, FragmentOfMaterial> sides;
  for (const auto& element : mesh.Elements)
  {
    const auto corner = [&](int c) { return static_cast<Index>(element.second[c]); };
    for (int f = 0; f < shape.Faces; ++f)
    {
      std::set<Index> face;
      for (int c = 0; c < shape.CornersOfFace; ++c)
      {
        face.insert(
          corner(AreHexes(shape.Corners) ? VtkCorner[FaceCorners[f][c]] : FaceOfTet[f][c]));
      }
      sides[face].emplace(static_cast<int>(element.second[8]), static_cast<int>(element.second[9]));
    }
  }
  return sides;
}

Pairs ToSet(const std::vector<Pair>& pairs)
{
  return Pairs(pairs.begin(), pairs.end());
}

class GeometryCheck
{
public:
  explicit GeometryCheck(const MergedMesh& mesh) : Input(mesh) {}

  std::string Run()
  {
    this->CheckSurfaces();
    this->CheckCurves();
    this->CheckPoints();
    this->CheckEnds();
    return this->Problem;
  }

private:
  void Expect(bool holds, const std::string& what)
  {
    this->Problem += !holds && this->Problem.empty() ? what : "";
  }

  void CheckSurfaces()
  {
    const GeometryTables& tables = this->Input.Tables;
    const auto sides = FindSides(this->Input);
    std::set<int> seen;
    Pairs bounds;
    for (const auto& facet : this->Input.Facets)
    {
      const int surface = facet.second[0];
      seen.insert(surface);
      const int corners = ShapeOf(this->Input.Corners).CornersOfFace;
      for (int c = 0; c < corners; ++c)
      {
        const Index a = facet.first[c], b = facet.first[(c + 1) % corners];
        this->SurfacesOfPoints[a].insert(surface);
        this->SurfacesOfEdges[{ { std::min(a, b), std::max(a, b) } }].insert(surface);
      }
      const auto side =
        sides.at(std::set<Index>(facet.first.begin(), facet.first.begin() + corners));
      const Pair& volumes = tables.SurfaceVolumes[surface - 1];
      const Pair& materials = tables.SurfaceMaterials[surface - 1];
      Expect(materials == Pair{ { facet.second[1], facet.second[2] } }, "materials of a surface");
      Expect(tables.SurfaceSides[surface - 1] == facet.second[3], "side of a surface");
      FragmentOfMaterial told;
      for (int i = 0; i < 2; ++i)
      {
        if (volumes[i] > 0)
        {
          told.emplace(materials[i], volumes[i]);
          bounds.insert({ { volumes[i], surface } });
        }
      }
      Expect(told == side, "volumes of a surface");
    }
    Expect(seen.size() == tables.SurfaceVolumes.size(), "surfaces without facets");
    Expect(bounds == ToSet(tables.VolumeSurfaces) && bounds.size() == tables.VolumeSurfaces.size(),
      "VolumeSurfaces");
  }

  /// An edge belongs to a curve if several surfaces meet there; a curve is defined by its surfaces.
  void CheckCurves()
  {
    std::map<int, std::set<int>> surfaces;
    std::map<std::set<int>, int> curves;
    std::size_t edges = 0;
    for (const auto& edge : this->SurfacesOfEdges)
    {
      if (edge.second.size() < 2)
      {
        continue;
      }
      ++edges;
      const auto found = this->Input.CurveEdges.find(edge.first);
      if (found == this->Input.CurveEdges.end())
      {
        Expect(false, "an edge of several surfaces is on no curve");
        continue;
      }
      Expect(surfaces.emplace(found->second, edge.second).first->second == edge.second &&
          curves.emplace(edge.second, found->second).first->second == found->second,
        "a curve is not the intersection of its surfaces");
    }
    Expect(edges == this->Input.CurveEdges.size(), "an edge of a curve is on only one surface");
    Expect(surfaces.size() == this->Input.Tables.CurveEnds.size() &&
        (surfaces.empty() || surfaces.rbegin()->first == static_cast<int>(surfaces.size())),
      "numbers of curves");
    Pairs bounds;
    for (const auto& curve : surfaces)
    {
      for (int surface : curve.second)
      {
        bounds.insert({ { surface, curve.first } });
      }
    }
    const std::vector<Pair>& told = this->Input.Tables.SurfaceCurves;
    Expect(bounds == ToSet(told) && bounds.size() == told.size(), "SurfaceCurves");
  }

  /// A point on a curve has exactly two edges of the curve, and no others.
  void CheckPoints()
  {
    std::map<Index, std::vector<Edge>> edges;
    for (const auto& edge : this->Input.CurveEdges)
    {
      edges[edge.first[0]].push_back(edge.first);
      edges[edge.first[1]].push_back(edge.first);
    }
    int vertices = 0;
    for (const auto& point : this->Input.Points)
    {
      const auto on = this->SurfacesOfPoints.find(point.first);
      const int dimension = static_cast<int>(point.second[3]);
      const int id = static_cast<int>(point.second[4]);
      if (on == this->SurfacesOfPoints.end())
      {
        Expect(dimension == 3, "a point inside is on the geometry");
        continue;
      }
      const std::vector<Edge>& curve = edges[point.first];
      const bool isThrough = curve.size() == 2 &&
        this->SurfacesOfEdges.at(curve[0]) == on->second &&
        this->SurfacesOfEdges.at(curve[1]) == on->second;
      if (on->second.size() == 1)
      {
        Expect(dimension == 2 && id == *on->second.begin(), "a point of a surface");
      }
      else if (isThrough)
      {
        Expect(dimension == 1 && id == this->Input.CurveEdges.at(curve[0]), "a point of a curve");
        ++this->Inside[id];
      }
      else
      {
        const auto vertex = this->Input.Vertices.find(point.first);
        Expect(dimension == 0 && id == ++vertices, "a vertex");
        Expect(vertex != this->Input.Vertices.end() && vertex->second == id, "number of a vertex");
      }
    }
    Expect(vertices == static_cast<int>(this->Input.Vertices.size()), "number of vertices");
  }

  /// A piece of a curve between two vertices has one edge more than inner
  /// points; a loop has as many.
  void CheckEnds()
  {
    Pairs bounds;
    std::map<int, int> edges, ends;
    for (const auto& edge : this->Input.CurveEdges)
    {
      ++edges[edge.second];
      for (Index point : edge.first)
      {
        const auto vertex = this->Input.Vertices.find(point);
        if (vertex != this->Input.Vertices.end())
        {
          ++ends[edge.second];
          bounds.insert({ { edge.second, vertex->second } });
        }
      }
    }
    const GeometryTables& tables = this->Input.Tables;
    for (const auto& curve : edges)
    {
      const int open = curve.second - this->Inside[curve.first];
      Expect(ends[curve.first] == 2 * open, "an end of a curve is not a vertex");
      Expect(tables.CurveEnds[curve.first - 1] == ends[curve.first], "CurveEnds");
    }
    Expect(bounds == ToSet(tables.CurveVertices) && bounds.size() == tables.CurveVertices.size(),
      "CurveVertices");
  }

  const MergedMesh& Input;
  std::map<Index, std::set<int>> SurfacesOfPoints;
  std::map<Edge, std::set<int>> SurfacesOfEdges;
  std::map<int, int> Inside; // number of inner points per curve
  std::string Problem;
};

} // namespace

std::string FindGeometryProblem(const MergedMesh& mesh)
{
  return GeometryCheck(mesh).Run();
}

} // namespace testing
} // namespace vfm
