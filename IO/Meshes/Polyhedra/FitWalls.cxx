#include "Meshes/Polyhedra/FitWalls.h"

#include "Meshes/Polyhedra/DualMeasures.h"

#include <map>
#include <tuple>

namespace vfm
{
namespace
{

constexpr int MostSteps = 8;        ///< of the secant method
constexpr double LargestMove = 0.6; ///< of a surface, in mean widths of its triangles
constexpr double Tolerance = 1e-15; ///< of the volume, in that of the surface's largest box

/// The surface between two regions, or of one region on the boundary.
struct DualSurface
{
  std::vector<Index> Triangles;
  std::vector<Index> Faces;  ///< of the dual mesh
  std::vector<double> Signs; ///< of each face: 1 if its owner is in the front region
};

using SurfaceKey = std::tuple<std::pair<int, int>, std::pair<int, int>, int>;

SurfaceKey KeyOf(const DualTets& tets, const WallTriangle& triangle)
{
  constexpr std::pair<int, int> outside{ -1, -1 };
  return { tets.RegionOf(triangle.Front / 4),
    triangle.Back == NothingBehind ? outside : tets.RegionOf(triangle.Back / 4),
    triangle.Surface.Joined };
}

/// Returns the surfaces that may move.
std::map<SurfaceKey, DualSurface> FindSurfaces(
  const DualTets& tets, const DualWalls& walls, const DualMesh& dual)
{
  std::map<SurfaceKey, DualSurface> surfaces;
  for (std::size_t t = 0; t < walls.Triangles.size(); ++t)
  {
    if (!walls.Triangles[t].Surface.IsFixed)
    {
      surfaces[KeyOf(tets, walls.Triangles[t])].Triangles.push_back(static_cast<Index>(t));
    }
  }
  for (Index face = 0; face < dual.NumberOfFaces(); ++face)
  {
    const Index side = dual.WallSides[face];
    if (side >= 0 && !walls.Triangles[walls.OfSide[side]].Surface.IsFixed)
    {
      const WallTriangle& triangle = walls.Triangles[walls.OfSide[side]];
      DualSurface& surface = surfaces.at(KeyOf(tets, triangle));
      surface.Faces.push_back(face);
      surface.Signs.push_back(side == triangle.Front ? 1.0 : -1.0);
    }
  }
  return surfaces;
}

/// The triangles of a surface that move, their normals and first places.
struct Moves
{
  std::vector<Index> Points;
  std::vector<Vector3> Places, Normals;
};

Vector3 AreaOf(const MeshData& mesh, const WallTriangle& triangle)
{
  const Vector3 first = mesh.PointAt(triangle.Nodes[0]);
  return 0.5 *
    Cross(mesh.PointAt(triangle.Nodes[1]) - first, mesh.PointAt(triangle.Nodes[2]) - first);
}

/// Returns whether a polygon at a corner of the triangle leaves an edge of it out.
bool IsJoined(const DualWalls& walls, const WallTriangle& triangle)
{
  return std::any_of(triangle.Edges.begin(), triangle.Edges.end(),
    [&walls](Index edge) { return walls.Edges[edge].Middle < 0; });
}

Moves FindMoves(
  const MeshData& mesh, const DualWalls& walls, const DualSurface& surface, const DualMesh& dual)
{
  Moves moves;
  for (const Index t : surface.Triangles)
  {
    const WallTriangle& triangle = walls.Triangles[t];
    if (IsJoined(walls, triangle))
    {
      const double* x = dual.Points.data() + 3 * walls.CentreOf(t);
      moves.Points.push_back(walls.CentreOf(t));
      moves.Places.push_back({ { x[0], x[1], x[2] } });
      moves.Normals.push_back(Unit(AreaOf(mesh, triangle)));
    }
  }
  return moves;
}

void Move(const Moves& moves, double distance, DualMesh& dual)
{
  for (std::size_t p = 0; p < moves.Points.size(); ++p)
  {
    const Vector3 x = moves.Places[p] + distance * moves.Normals[p];
    std::copy(x.begin(), x.end(), dual.Points.begin() + 3 * moves.Points[p]);
  }
}

/// Returns the volume between a point and the polygons of a surface.
double MeasureVolume(const DualSurface& surface, const DualMesh& dual, const Vector3& from)
{
  double volume = 0.0;
  for (std::size_t f = 0; f < surface.Faces.size(); ++f)
  {
    const FaceMeasure face = MeasureFace(dual, surface.Faces[f]);
    volume += surface.Signs[f] * Dot(face.Area, face.Centre - from) / 3.0;
  }
  return volume;
}

/// Moves one surface.
/// @return false if it would have to move too far
bool FitSurface(
  const MeshData& mesh, const DualWalls& walls, const DualSurface& surface, DualMesh& dual)
{
  const Moves moves = FindMoves(mesh, walls, surface, dual);
  if (moves.Points.empty())
  {
    return true;
  }
  const Vector3 from = mesh.PointAt(walls.Triangles[surface.Triangles[0]].Nodes[0]);
  double target = 0.0, area = 0.0, scale = 0.0;
  for (const Index t : surface.Triangles)
  {
    const WallTriangle& triangle = walls.Triangles[t];
    const Vector3 normal = AreaOf(mesh, triangle);
    const double volume = Dot(normal, mesh.PointAt(triangle.Nodes[0]) - from) / 3.0;
    target += volume;
    scale += std::fabs(volume);
    area += Norm(normal);
  }
  const double width = std::sqrt(area / static_cast<double>(surface.Triangles.size()));
  double last = 0.0, lastError = MeasureVolume(surface, dual, from) - target;
  double distance = -lastError / area;
  for (int step = 0; step < MostSteps && std::fabs(lastError) > Tolerance * scale; ++step)
  {
    if (std::fabs(distance) > LargestMove * width)
    {
      Move(moves, 0.0, dual);
      return false;
    }
    Move(moves, distance, dual);
    const double error = MeasureVolume(surface, dual, from) - target;
    const double slope = (error - lastError) / (distance - last);
    last = distance;
    lastError = error;
    distance -= slope != 0.0 && std::isfinite(slope) ? error / slope : 0.0;
  }
  return true;
}

} // namespace

std::vector<Index> FitWalls(const DualTets& tets, const DualWalls& walls, DualMesh& dual)
{
  std::vector<Index> refused;
  for (const auto& [key, surface] : FindSurfaces(tets, walls, dual))
  {
    if (!FitSurface(tets.Data(), walls, surface, dual))
    {
      refused.insert(refused.end(), surface.Triangles.begin(), surface.Triangles.end());
    }
  }
  return refused;
}

} // namespace vfm
