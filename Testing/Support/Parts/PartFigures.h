/**
 * PartFigures: how near a mesh comes to the surfaces, the sharp edges and the sides of parts.
 *
 * Sharp edges are those of the triangles where these turn by more than an angle; sides are the
 * pieces between them and between patches of the input. All lengths are in the unit of the grid,
 * which is the width of a cell.
 */
#pragma once

#include "Elements/MeshReport.h"
#include "Parts/MeshInterface.h"
#include "Surfaces/InputSurfaces.h"

namespace vfm
{
namespace testing
{

/// Surfaces of a part, prepared for measurements.
class TrueSurface
{
public:
  /// @param angle  least angle of sharp edges, degrees
  TrueSurface(const InputSurfaces& surfaces, double angle);

  /// Returns the distance of a point.
  double Distance(const Vector3& x) const { return this->Nearest.Distance(x); }
  /// Returns the side that is nearest to a point with an outward normal.
  int FindSide(const Vector3& x, const Vector3& normal) const;

  const std::vector<double>& SideAreas() const { return this->Areas; }
  const std::vector<Vector3>& EdgeSamples() const { return this->Edges; }
  const std::vector<Vector3>& Samples() const { return this->Inner; }

private:
  struct Pieces
  {
    std::vector<NearestTriangle::Corners> Triangles; ///< parts of triangles, below a cell
    std::vector<int> Sides;
  };
  TrueSurface(Pieces pieces, std::vector<double> areas, std::vector<Vector3> edges);
  static TrueSurface Make(const InputSurfaces& surfaces, double angle);

  std::vector<int> Sides; // of the pieces
  std::vector<Vector3> Normals;
  std::vector<Vector3> Inner;
  NearestTriangle Nearest;
  std::vector<double> Areas;  // of the sides
  std::vector<Vector3> Edges; // points along sharp edges, a tenth of a cell apart
};

struct PartFigures
{
  SharpDistances Nodes;       ///< interface nodes to the true surface
  SharpDistances Edges;       ///< true edges to the mesh
  double EdgesNear = 1.0;     ///< share of the true edges within a quarter of a cell
  double Hausdorff = 0.0;     ///< of mesh and true surface, both ways
  double RmsDistance = 0.0;   ///< of mesh and true surface, the larger of both ways
  Index Sides = 0;            ///< sides of the part
  Index SidesFound = 0;       ///< of these, sides with a surface of the mesh of their own
  Index MeshSurfaces = 0;     ///< surfaces of the mesh
  double WorstSideArea = 0.0; ///< largest relative error of the area of a side
  double MeanSideArea = 0.0;  ///< mean of these errors
  double VolumeError = 0.0;   ///< largest relative error of a material
};

/// @pre The mesh is not cut by the sides of the domain.
PartFigures MeasurePart(const TrueSurface& part, const Mesh& mesh, const MeshReport& report);

} // namespace testing
} // namespace vfm
