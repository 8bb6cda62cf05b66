/**
 * Solids with edges and corners: their exact fractions, and how far a mesh is from their faces,
 * edges and corners.
 *
 * Each is a prism over a plane figure, turned and put off the grid, 1.2 high and wide or about that
 * in a cube of edge 2.6; lengths here are in cells of the n^3 that this cube is cut into.
 */
#pragma once

#include "Shapes/ShapesFractions.h"
#include "TetPipeline.h"

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
  std::function<double(const Vector3&)> Distance; ///< to the surface, >= 0; exact
  std::vector<Vector3> Edges;                     ///< points along them, every tenth of a cell
  std::vector<Vector3> Corners;
};

/// The names of all, without cells.
std::vector<std::string> ListSharpCases();
/// "cube A", "cube B" (turned), "cube C" (along the axes), "cube D" (its faces on those of cells),
/// "L", "cylinder", "wedge 45" and "cube A in matrix". Throws InputError for others.
SharpCase MakeSharpCase(const std::string& name, int cells);

/// In cells.
struct SharpDistances
{
  double Largest = 0.0, RootMeanSquare = 0.0, Percentile99 = 0.0;
};

struct SharpFigures
{
  SharpDistances NodesToSurface; ///< points of the interface to the true one
  SharpDistances MeshToSurface;  ///< 16 points of each of its facets, bilinear ones
  SharpDistances
    EdgesToMesh; ///< true edges to the facets, four triangles around the centre of quads
  SharpDistances EdgesToNodes; ///< to the nearest point of the interface
  SharpDistances CornersToNodes;
  double VolumeError = 0.0; ///< of material 1, relative
};

SharpFigures MeasureSharp(const SharpCase& c, const Mesh& mesh, const MeshReport& report);

} // namespace testing
} // namespace vfm
