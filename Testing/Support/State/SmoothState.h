/**
 * A smooth state of every material on the unit cube, stored in cells as in a simulation: means
 * over the part of each material.
 */
#pragma once

#include "Fractions/FractionField.h"
#include "State/Transfer/TransferState.h"

#include <functional>

namespace vfm
{
namespace testing
{

/// Lists density, velocity, specific energy, temperature, strain per mass and pressure per volume:
/// six arrays with eight components.
std::vector<StateQuantity> ListSmoothQuantities();
constexpr int SmoothComponents = 8;

/// Sets values at a point of a material.
using StateFunction = std::function<void(const Vector3& x, int material, double* values)>;

/// Evaluates sines and products on the unit cube, different in each material. Material 2 is
/// 8 times as dense as the others.
void EvaluateSmoothState(const Vector3& x, int material, double* values);

/// Means of a function in the cells of a grid; in mixed cells over sample points of each material.
class CellMeans : public StateCellValues
{
public:
  /// materialAt: material at a point of a mixed cell
  CellMeans(const CartesianGrid& grid, const FractionField& fractions,
    const StateFunction& function, const std::function<int(const Vector3&)>& materialAt);
  void Read(const Index3& cell, int material, double* values) const override;

private:
  const CartesianGrid& Grid;
  int Materials;
  std::vector<double> Means; ///< by cell of the local box, then material from 0
};

/// Returns n^3 cells of the unit cube.
CartesianGrid MakeUnitCube(int n);

/// Type of element and method.
enum class Elements
{
  Hexes,
  Lattice,
  Cells
};

/// Makes a mesh with default options.
Mesh MakeMesh(const CartesianGrid& grid, const FractionField& fractions, Elements elements);

/// Volumes and centroids of elements, computed from overlaps with the cells.
struct MeasuredShapes
{
  std::vector<double> Volumes;
  std::vector<Vector3> Centroids;
};
MeasuredShapes MeasureElements(const Mesh& mesh, const CartesianGrid& grid);

} // namespace testing
} // namespace vfm
