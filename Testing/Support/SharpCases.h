/**
 * Solids with edges and corners: their exact fractions, and the distances of a mesh from
 * their faces, edges and corners.
 *
 * Each is a prism over a plane figure, rotated and offset from the grid. Height and width are about
 * 1.2 in a cube of edge 2.6. Lengths below are in cells of the n^3 cells of this cube.
 */
#pragma once

#include "Parts/MeshInterface.h"
#include "Phases/MeshOfCells.h"
#include "Shapes/ShapesFractions.h"

#include <string>

namespace vfm
{
namespace testing
{

struct SharpCase
{
  std::string Name;
  CartesianGrid Grid; ///< unit cells
  FractionField Fractions;
  std::function<double(const Vector3&)> Distance; ///< exact distance to the surface, >= 0
  std::vector<Vector3> Edges;                     ///< points along edges, a tenth of a cell apart
  std::vector<Vector3> Corners;
};

/// Lists the names of all cases, without the number of cells.
std::vector<std::string> ListSharpCases();
/// Returns a case: "cube A", "cube B" (rotated), "cube C" (along the axes), "cube D"
/// (faces on faces of cells), "L", "cylinder", "wedge 45" or "cube A in matrix".
/// Throws InputError for other names.
SharpCase MakeSharpCase(const std::string& name, int cells);

/// Distances in cells.
struct SharpFigures
{
  SharpDistances NodesToSurface; ///< interface points to the true surface
  SharpDistances MeshToSurface;  ///< 16 points of each bilinear facet to the true surface
  /// true edges to the facets, four triangles around the centre of quads
  SharpDistances EdgesToMesh;
  SharpDistances EdgesToNodes; ///< true edges to the nearest interface point
  SharpDistances CornersToNodes;
  double VolumeError = 0.0; ///< relative error of material 1
};

SharpFigures MeasureSharp(const SharpCase& c, const Mesh& mesh, const MeshReport& report);

} // namespace testing
} // namespace vfm
