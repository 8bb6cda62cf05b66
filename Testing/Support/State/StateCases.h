/**
 * State transferred from fields to meshes, on one rank and on several, and its invariants.
 */
#pragma once

#include "MeshCases.h"
#include "RankFields.h"
#include "State/StateBalance.h"
#include "State/Transfer/TransferState.h"

#include <map>

namespace vfm
{
namespace testing
{

/// Sets the values of a cell and material.
using CellFunction =
  std::function<void(const CartesianGrid& grid, const Index3& cell, int material, double* values)>;

struct StateCase
{
  const CartesianGrid& Grid;
  const FractionField& Fractions;
  CellFunction Function;
  std::vector<StateQuantity> Quantities{};
  int Density = -1;
  int Order = 2;
  bool GiveUnmeshed = true;
  MeshOptions Options{};
  MeshMaker Make = MakeHexMesh;
};

struct ElementOutcome
{
  int Material, Fragment;
  double Volume, Mass;
  Vector3 Centroid;     ///< mean of the corners
  Vector3 Mean;         ///< centroid of the volume
  Vector3 Lower, Upper; ///< bounds of the element
  std::vector<double> Values;
};

struct StateOutcome
{
  std::map<Index, ElementOutcome> Elements; ///< by id
  std::vector<StateTotals> Input, Unmeshed;
  std::vector<std::array<double, 2>> Factors;
};

/// State of a rank by a function.
class FunctionValues : public StateCellValues
{
public:
  FunctionValues(const StateCase& c, const CartesianGrid& grid) : Case(c), Grid(grid) {}
  void Read(const Index3& cell, int material, double* values) const override
  {
    this->Case.Function(this->Grid, cell, material, values);
  }

private:
  const StateCase& Case;
  const CartesianGrid& Grid;
};

/// Meshes and transfers on one rank per box.
StateOutcome TransferOnRanks(const StateCase& c, const std::vector<IndexBox>& boxes);
StateOutcome TransferAlone(const StateCase& c);
StateOutcome TransferOnThreads(const StateCase& c);

/// Returns totals of the mesh by material, as StateTotals, computed only from element values.
std::vector<StateTotals> SumElements(const StateCase& c, const StateOutcome& outcome);

/// Returns an empty string, or the first total of a material that differs from the input without
/// unmeshed content. tolerance: relative to the sum of magnitudes.
std::string FindTotalsProblem(
  const StateCase& c, const StateOutcome& outcome, double tolerance = 1e-13);

/// Returns an empty string, or the number of elements that are not bitwise
/// identical, and totals that differ.
std::string FindOutcomeDifference(const StateOutcome& a, const StateOutcome& b);

/// Returns mass, momentum, internal energy, and kinetic energy with its losses, of all materials in
/// two lists: the input, or the mesh and unmeshed material.
std::array<double, 6> SumUp(const std::vector<StateSums>& one, const std::vector<StateSums>& other);

/// Lists typical quantities of a simulation: density, velocity, specific energy, heat capacity,
/// temperature, stress per volume, and a sum per volume.
std::vector<StateQuantity> MakeCodeQuantities();

} // namespace testing
} // namespace vfm
