/**
 * StateBalance: volume, mass, momentum and energy of each material, of the input, of the mesh, and of what is not meshed.
 */
#pragma once

#include "Base/IndexBox.h"
#include "Input/FieldArray.h"
#include "Input/InputFields.h"
#include "Mesh/Mesh.h"

#include <functional>
#include <string>
#include <vector>

namespace vfm
{

/// Of a material over all ranks, or of one element; in the units of the input.
struct StateSums
{
  double Volume = 0.0; ///< not of the mesh: MeshReport has it
  double Mass = 0.0;
  Vector3 Momentum{ { 0.0, 0.0, 0.0 } };
  double Kinetic = 0.0, Internal = 0.0; ///< energies; kinetic of the mesh: of its elements
  double LostToElements = 0.0;          ///< kinetic energy of the cells that elements have not
  double LostToNodes = 0.0;             ///< and of elements that nodes have not
};

struct StateBalance
{
  bool HasDensity = false, HasVelocity = false, HasEnergy = false, HasNodes = false;
  std::vector<StateSums> Input, Mesh, Unmeshed; ///< of each material from 0
  std::vector<std::array<double, 2>> Factors;   ///< TransferredState::Factors
};

/// Collective: sums over the elements of each material, whatever their order. find: of an element.
std::vector<StateSums> SumElements(
  const Mesh& mesh, int materials, const std::function<StateSums(Index)>& find, Ranks& ranks);

/// Of each material, void only when meshed: InputVolume, UnmeshedVolume, VolumeFactors (two each); with a density InputMass,
/// MeshMass, UnmeshedMass; with a velocity InputMomentum, MeshMomentum, UnmeshedMomentum, InputKineticEnergy, MeshKineticEnergy,
/// UnmeshedKineticEnergy, LostKineticEnergy; with an energy InputInternalEnergy, MeshInternalEnergy, UnmeshedInternalEnergy; with
/// velocities of nodes LostNodalKineticEnergy.
std::vector<FieldArray> ListBalance(const StateBalance& balance, bool meshVoid);

/// How much of which materials is in no element; "" where that is nothing.
std::string DescribeUnmeshed(const StateBalance& balance, const Materials& table);

} // namespace vfm
