/**
 * StateBalance: volume, mass, momentum and energy of each material in the input, in the mesh,
 * and unmeshed.
 */
#pragma once

#include "Base/IndexBox.h"
#include "Elements/Mesh.h"
#include "Input/FieldArray.h"
#include "Input/InputFields.h"

#include <functional>
#include <string>
#include <vector>

namespace vfm
{

/// Sums of a material over all ranks, or the state of one element; in the units of the input.
struct StateSums
{
  double Volume = 0.0; ///< not set for the mesh, see MeshReport
  double Mass = 0.0;
  Vector3 Momentum{ { 0.0, 0.0, 0.0 } };
  double Kinetic = 0.0,
         Internal = 0.0;       ///< energies; kinetic energy of the mesh is that of elements
  double LostToElements = 0.0; ///< kinetic energy of cells that elements lack
  double LostToNodes = 0.0;    ///< kinetic energy of elements that nodes lack
};

struct StateBalance
{
  bool HasDensity = false, HasVelocity = false, HasEnergy = false, HasNodes = false;
  std::vector<StateSums> Input, Mesh, Unmeshed; ///< sums of each material from 0
  std::vector<std::array<double, 2>> Factors;   ///< TransferredState::Factors
};

/// Sums over the elements of each material; bitwise reproducible for any order of elements.
/// @param find returns the state of an element
/// @pre Collective
std::vector<StateSums> SumElements(
  const Mesh& mesh, int materials, const std::function<StateSums(Index)>& find, Ranks& ranks);

/// Lists the balance, one tuple per material, void only if meshed.
/// - Always: InputVolume, UnmeshedVolume, VolumeFactors (two components)
/// - Density: InputMass, MeshMass, UnmeshedMass
/// - Velocity: InputMomentum, MeshMomentum, UnmeshedMomentum, InputKineticEnergy,
///   MeshKineticEnergy, UnmeshedKineticEnergy, LostKineticEnergy
/// - Velocity of nodes: LostNodalKineticEnergy
/// - Energy: InputInternalEnergy, MeshInternalEnergy, UnmeshedInternalEnergy
std::vector<FieldArray> ListBalance(const StateBalance& balance, bool meshVoid);

/// Returns a sentence with the amount of each material that is in no element; "" if there is none.
std::string DescribeUnmeshed(const StateBalance& balance, const Materials& table);

} // namespace vfm
