/**
 * Manufactured cases with known interfaces: fractions of exact shapes, the distance to their
 * interfaces, and the figures that a mesh must reach.
 */
#pragma once

#include "MeshChecks.h"
#include "Phases/MeshOfCells.h"
#include "Shapes/ShapesFractions.h"

namespace vfm
{
namespace testing
{

struct MeshCase
{
  std::string Name;
  CartesianGrid Grid;
  FractionField Fractions;
  /// Returns the distance of a point to the true interface of two materials, in cells.
  std::function<double(int, int, const Vector3&)> Distance;
  /// Lower bounds of the smallest and mean scaled Jacobian; upper bounds of the distances (largest,
  /// rms; in cells) and of the relative volume error of any material.
  double MinimumJacobian, MeanJacobian, LargestDistance, RmsDistance, VolumeError;
};

/// Lists the names of smooth and sharp shapes, of one material and of several.
std::vector<std::string> ListMeshCases();
MeshCase MakeMeshCase(const std::string& name);

/// Returns a sphere of a diameter given in cells.
MeshCase MakeSphereCase(int diameter);

/// Returns Scene::EightShapes in n^3 unit cells.
MeshCase MakeEightShapesCase(int n = 46);

/// Returns a polycrystal of Voronoi cells that fills n^3 unit cells.
MeshCase MakePolycrystalCase(int grains, int n, unsigned seed = 1);

/// Returns labels of three concentric spheres of 10, 11 and 12 cm and the outside, in a
/// cube of 26 cm and n^3 unit cells.
FractionField MakeConcentricLabels(const CartesianGrid& grid, Index n);

/// Type of MakeHexMesh and MakeTetMesh.
using MeshMaker = Mesh (*)(
  const CartesianGrid&, const FractionField&, const MeshOptions&, Runtime&, MeshReport&);

/// A function that makes elements, with the method of tetrahedra.
struct ElementMaker
{
  const char* Name;
  MeshMaker Make;
  TetMethod Tets; ///< of no effect on hexes
};
/// Makers of hexes, and of tetrahedra without TetGen.
constexpr ElementMaker ElementMakers[] = { { "hexes", MakeHexMesh, TetMethod::Lattice },
  { "Lattice", MakeTetMesh, TetMethod::Lattice }, { "Cells", MakeTetMesh, TetMethod::Cells } };

/// Measures distances of the interface points between two materials, without junctions. onSides: of
/// interface points on sides of the domain.
void MeasureInterfaces(
  const MeshCase& c, const Mesh& mesh, Distances& distance, Distances& onSides);

struct MeshFigures
{
  Mesh Result;
  MeshReport Report;
  std::size_t Elements = 0, Points = 0;
  Distances Distance;       ///< of interface points between two materials, without junctions
  Distances OnSides;        ///< of interface points on sides of the domain
  double VolumeError = 0.0; ///< largest relative error of a material
  double Seconds = 0.0;
};
MeshFigures MeasureCase(
  const MeshCase& c, const MeshOptions& options, Runtime& runtime, MeshMaker make = MakeHexMesh);

/// Formats a row of the table of figures.
std::string FormatFigures(const std::string& name, const MeshFigures& figures);
std::string FormatHeader();

std::string NameOf(TetMethod method);
/// Formats a row of the table for tetrahedra.
std::string FormatTetFigures(TetMethod method, const std::string& name, const MeshFigures& figures);
std::string FormatTetHeader();

/// Formats the number of dihedral angles per interval of ten degrees.
std::string FormatAngles(TetMethod method, const std::string& name, const MeshReport& report);
std::string FormatAnglesHeader();

} // namespace testing
} // namespace vfm
