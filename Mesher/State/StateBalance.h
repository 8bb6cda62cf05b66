/**
 * StateBalance: volume, mass, momentum and energy of each material in the input, in the mesh,
 * and unmeshed.
 */
#pragma once

#include "Base/IndexBox.h"
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
  double Volume = 0.0; ///< not set for elements, see MeshReport
  double Mass = 0.0;
  Vector3 Momentum{ { 0.0, 0.0, 0.0 } };
  double Kinetic = 0.0,
         Internal = 0.0;       ///< energies; kinetic energy of the mesh is that of elements
  double LostToElements = 0.0; ///< kinetic energy of cells that elements or particles lack
  double LostToNodes = 0.0;    ///< kinetic energy of elements that nodes lack
};

struct StateBalance
{
  bool HasDensity = false, HasVelocity = false, HasEnergy = false, HasNodes = false;
  std::vector<StateSums> Input, Mesh, Unmeshed; ///< sums of each material from 0
  std::vector<std::array<double, 2>> Factors;   ///< TransferredState::Factors
  std::vector<StateSums> Particles;  ///< of each material from 0; empty: there are no particles
  std::vector<Index> ParticleCounts; ///< numbers of particles, in the same way
};

/// Sums over the elements or particles of each material; bitwise reproducible for any order.
/// @param material  material of each item
/// @param find  returns the state of an item
/// @pre Collective
std::vector<StateSums> SumByMaterial(const int* material, std::size_t count, int materials,
  const std::function<StateSums(Index)>& find, Ranks& ranks);

/// Lists the balance, one tuple per material, void only if meshed.
/// - Always: InputVolume, UnmeshedVolume, VolumeFactors (two components)
/// - Density: InputMass, MeshMass, UnmeshedMass
/// - Velocity: InputMomentum, MeshMomentum, UnmeshedMomentum, InputKineticEnergy,
///   MeshKineticEnergy, UnmeshedKineticEnergy, LostKineticEnergy
/// - Velocity of nodes: LostNodalKineticEnergy
/// - Energy: InputInternalEnergy, MeshInternalEnergy, UnmeshedInternalEnergy
/// - Particles: Particles (their number), ParticleVolume; with density, velocity or energy
///   ParticleMass, ParticleMomentum, ParticleKineticEnergy, ParticleLostKineticEnergy,
///   ParticleInternalEnergy
std::vector<FieldArray> ListBalance(const StateBalance& balance, bool meshVoid);

/// Returns a sentence with the amount of each material that is in no element; "" if there is none.
std::string DescribeUnmeshed(const StateBalance& balance, const Materials& table);

} // namespace vfm
