/**
 * A smooth state of every material on the unit cube, as codes hold it in cells: means over the part
 * of each material.
 */
#pragma once

#include "Fractions/FractionField.h"
#include "Transfer/TransferState.h"

#include <functional>

namespace vfm
{
namespace testing
{

/// Density, velocity, specific energy, temperature, strain per mass, pressure per volume: six
/// arrays of eight components.
std::vector<StateQuantity> ListSmoothQuantities();
constexpr int SmoothComponents = 8;

/// Values at a point of a material.
using StateFunction = std::function<void(const Vector3& x, int material, double* values)>;

/// Of the unit cube: sines and products, different in each material; material 2 is 8 times as dense
/// as the others.
void EvaluateSmoothState(const Vector3& x, int material, double* values);

/// Means of a function in the cells of a grid: of mixed ones by points of each material.
class CellMeans : public StateCellValues
{
public:
  /// materialAt: of a point of a mixed cell.
  CellMeans(const CartesianGrid& grid, const FractionField& fractions,
    const StateFunction& function, const std::function<int(const Vector3&)>& materialAt);
  void Read(const Index3& cell, int material, double* values) const override;

private:
  const CartesianGrid& Grid;
  int Materials;
  std::vector<double> Means; ///< by cell of the local box, then material from 0
};

/// n^3 cells of the unit cube.
CartesianGrid MakeUnitCube(int n);

/// And who makes them.
enum class Elements
{
  Hexes,
  Lattice,
  Cells
};

/// With default options.
Mesh MakeMesh(const CartesianGrid& grid, const FractionField& fractions, Elements elements);

/// Volumes and centroids of elements, as Overlaps know them.
struct ElementShapes
{
  std::vector<double> Volumes;
  std::vector<Vector3> Centroids;
};
ElementShapes MeasureElements(const Mesh& mesh, const CartesianGrid& grid);

} // namespace testing
} // namespace vfm
