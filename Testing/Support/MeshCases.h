/**
 * The manufactured cases with a known truth: fields of exact shapes, the distance to their true
 * interfaces, and the figures that a mesh of them must reach.
 */
#pragma once

#include "MeshChecks.h"
#include "Shapes/ShapesFractions.h"
#include "TetPipeline.h"

namespace vfm
{
namespace testing
{

struct MeshCase
{
  std::string Name;
  CartesianGrid Grid;
  FractionField Fractions;
  /// Distance of a point to the true interface of two materials, in cells.
  std::function<double(int, int, const Vector3&)> Distance;
  /// Floors of the smallest and mean scaled Jacobian; ceilings of the distances (largest, rms; in
  /// cells) and of the relative volume error of any material.
  double MinimumJacobian, MeanJacobian, LargestDistance, RmsDistance, VolumeError;
};

/// Smooth and sharp shapes of one material and of several (names: see MeshCases.cxx).
std::vector<std::string> ListMeshCases();
MeshCase MakeMeshCase(const std::string& name);

/// A sphere of a diameter in cells.
MeshCase MakeSphereCase(int diameter);

/// Scene::EightShapes in n^3 unit cells.
MeshCase MakeEightShapesCase(int n = 46);

/// grains Voronoi cells fill n^3 unit cells.
MeshCase MakePolycrystalCase(int grains, int n, unsigned seed = 1);

/// Three concentric spheres of 10, 11 and 12 cm and the outside, as labels, in a cube of 26 cm and
/// n^3 unit cells.
FractionField MakeConcentricLabels(const CartesianGrid& grid, Index n);

/// MakeHexMesh or MakeTetMesh.
using MeshMaker = Mesh (*)(
  const CartesianGrid&, const FractionField&, const MeshOptions&, Runtime&, MeshReport&);

/// Distances of the interface points between two materials, junctions left out, and of those on
/// sides of the domain.
void MeasureInterfaces(
  const MeshCase& c, const Mesh& mesh, Distances& distance, Distances& onSides);

struct MeshFigures
{
  Mesh Result;
  MeshReport Report;
  std::size_t Elements = 0, Points = 0;
  Distances Distance;       ///< of the interface points between two materials, junctions left out
  Distances OnSides;        ///< of those on sides of the domain
  double VolumeError = 0.0; ///< largest relative error of a material
  double Seconds = 0.0;
};
MeshFigures MeasureCase(
  const MeshCase& c, const MeshOptions& options, Runtime& runtime, MeshMaker make = MakeHexMesh);

/// A row of the table of figures.
std::string FormatFigures(const std::string& name, const MeshFigures& figures);
std::string FormatHeader();

std::string NameOf(TetMethod method);
/// The same of tets.
std::string FormatTetFigures(TetMethod method, const std::string& name, const MeshFigures& figures);
std::string FormatTetHeader();

/// How many dihedral angles lie in each ten degrees.
std::string FormatAngles(TetMethod method, const std::string& name, const MeshReport& report);
std::string FormatAnglesHeader();

} // namespace testing
} // namespace vfm
