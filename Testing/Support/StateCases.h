/**
 * State carried from fields to meshes made of them, alone and on ranks, and what must be true of
 * it.
 */
#pragma once

#include "MeshCases.h"
#include "RankFields.h"
#include "Transfer/TransferState.h"

#include <map>

namespace vfm
{
namespace testing
{

/// Values by a function of the cell.
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
  Vector3 Centroid;     ///< the mean of the corners
  Vector3 Mean;         ///< of its volume
  Vector3 Lower, Upper; ///< of the box around it
  std::vector<double> Values;
};

struct StateOutcome
{
  std::map<Index, ElementOutcome> Elements; ///< by id
  std::vector<StateTotals> Input, Unmeshed;
  std::vector<std::array<double, 2>> Factors;
};

/// Each rank meshes one of the boxes.
StateOutcome TransferOnRanks(const StateCase& c, const std::vector<IndexBox>& boxes);
StateOutcome TransferAlone(const StateCase& c);
StateOutcome TransferOnThreads(const StateCase& c);

/// Totals of the mesh by material, as StateTotals, from values alone.
std::vector<StateTotals> SumElements(const StateCase& c, const StateOutcome& outcome);

/// "", or which total of which material is not that of the input without what is not meshed.
/// tolerance: of the sum of magnitudes.
std::string FindTotalsProblem(
  const StateCase& c, const StateOutcome& outcome, double tolerance = 1e-13);

/// "", or how many elements have other bits; totals too.
std::string FindOutcomeDifference(const StateOutcome& a, const StateOutcome& b);

/// Density, velocity, specific energy, heat capacity, temperature, stress per volume, a sum per
/// volume: as a code has them.
std::vector<StateQuantity> MakeCodeQuantities();

} // namespace testing
} // namespace vfm
