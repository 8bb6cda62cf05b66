/**
 * ExodusModel: the part of a mesh on one rank in the numbering of Exodus, which lists elements
 * block by block, with the totals over all ranks.
 */
#pragma once

#include "Elements/MeshWithRuns.h"
#include "Meshes/Exodus/ExodusVariables.h"
#include "Meshes/Files/MeshModel.h"
#include "Meshes/Particles/ParticleParts.h"
#include "Report/SharedPoints.h"

namespace vfm
{

/// Attributes of blocks of particles; variables of these names would be the same values.
constexpr const char *RadiusAttribute = "radius", *VolumeAttribute = "volume";

/// Element block, which holds the elements of one material or bin, cohesive elements, or the
/// particles of one material.
struct ExodusBlock
{
  int Id; ///< material or bin id; for the void, material 0, FindVoidId(); CohesiveBlock::Id,
          ///< ParticlePart::Id
  std::string Name;
  std::vector<Index> Elements;             ///< elements of this rank, ascending
  const CohesiveBlock* Cohesive = nullptr; ///< set for cohesive elements; Elements is then empty
  bool HasParticles = false;               ///< whether Elements are particles of this rank
  Index Total = 0;                         ///< number of elements on all ranks
  int Material = 0;                        ///< of elements of the mesh
  Index LeftOut = 0;                       ///< number of hexes in MeshWithRuns::Cells

  /// Returns the number of elements on this rank.
  Index Count() const
  {
    const auto stored =
      static_cast<Index>(this->Cohesive ? this->Cohesive->Ids.size() : this->Elements.size());
    return stored + this->LeftOut;
  }
};

/// Contents of the Exodus file of one rank. Materials have lost their elements to Blocks; sets have
/// unique names.
struct ExodusModel : MeshModel
{
  /// Part of this rank; points and elements in the order of their ids, then nodes of particles.
  StoredMesh Mesh;
  const MeshWithRuns* Whole = nullptr; ///< with the hexes that Mesh leaves out; null: none
  std::shared_ptr<const ParticleData> Particles; ///< of this rank; never null
  std::vector<Index> ParticleIds;  ///< element ids, above those of all elements, also cohesive ones
  std::vector<ExodusBlock> Blocks; ///< list of blocks by id, equal on all ranks
  std::vector<Index> Numbers;      ///< number of each element in the file, from 1; then come the
                                   ///< cohesive elements, then the particles
  std::vector<Index> SideTotals;   ///< number of sides of each side set on all ranks
  std::vector<Index> NodeTotals;   ///< number of different nodes of each node set on all ranks
  Index TotalNodes = 0, TotalElements = 0;
  SharedPoints Sharing;
  std::vector<ExodusVariable> PointVariables, ElementVariables, ParticleVariables;
  /// Names of ElementVariables, then of ParticleVariables with other names.
  std::vector<std::string> ElementNames;
  std::vector<ExodusNumber> GlobalVariables;
  std::size_t LongestName = 0;
  bool HasWideIds = false; ///< an id is greater than 2^31 - 1
  /// An array exceeds the limit of the classic file format, 4 GiB.
  bool HasLargeArrays = false;

  /// Returns the number of elements on this rank, with cohesive elements and particles.
  Index NumberOfElements() const
  {
    const Index hexes =
      this->Whole ? this->Whole->NumberOfElements() : this->Mesh.Data.NumberOfElements;
    return hexes + CountElements(this->Cohesive) + this->Particles->NumberOfParticles;
  }
  Index NumberOfPoints() const
  {
    return this->Whole ? this->Whole->NumberOfPoints() : this->Mesh.Data.NumberOfPoints;
  }
  /// Returns the number in the file of a point of Mesh, from 1.
  Index NumberOfPoint(Index point) const
  {
    return (this->Whole ? this->Whole->NumberOfPoint(point) : point) + 1;
  }
  /// Returns the variable of a name in ElementNames that a block has, or null.
  const ExodusVariable* VariableOf(const ExodusBlock& block, std::size_t name) const;
};

/// Makes the contents of the file of this rank.
/// @param mesh  part of this rank, made by the mesher or read from a file; must outlive the model
/// @throws InputError  if the mesh is empty, lacks a required array, or has different arrays on
///   different ranks; on all ranks
/// @param whole  the mesh with the hexes that it leaves out; null: none
/// @pre Collective
ExodusModel MakeExodusModel(
  const MeshData& mesh, Ranks& ranks, const MeshWithRuns* whole = nullptr);

} // namespace vfm
