/**
 * DeckModel: what an input file of a solver contains of a mesh, for the writers of all formats.
 *
 * Nodes and elements have the numbers 1, 2, 3, .. in the order of their global ids, because solvers
 * allocate tables up to the greatest number.
 */
#pragma once

#include "Meshes/Files/MeshModel.h"
#include "Meshes/Particles/ParticleParts.h"
#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

#include <functional>
#include <string>
#include <vector>

namespace vfm
{

/// Arrays with the state of nodes and elements; null if the mesh has none.
struct DeckState
{
  const MeshArray* Velocity = nullptr;      ///< of nodes, three components
  Index FirstVelocity = 0;                  ///< first node with a velocity
  const MeshArray* Density = nullptr;       ///< of elements, as the following ones
  const MeshArray* Energy = nullptr;        ///< internal energy per mass
  const MeshArray* Stress = nullptr;        ///< six components xx yy zz xy yz xz, or nine by row
  const MeshArray* PlasticStrain = nullptr; ///< equivalent plastic strain
};

/// Cohesive elements are numbered after all elements, elements at particles after those.
struct DeckModel : MeshModel
{
  const MeshData& Mesh; ///< whole mesh, then a node per particle; must outlive this object
  DeckState State;
  ConnectionKind Connection;                ///< of both sides of split interfaces
  std::vector<SplitFace> SplitFaces;        ///< faces at which interfaces were split
  std::vector<ParticlePart> Particles = {}; ///< empty: no particles
  /// Materials that have bins in Materials, with all their elements.
  std::vector<MaterialPart> Undivided = {};

  /// Returns whether particles have a mass.
  bool HasMasses() const { return this->Mesh.Particles->Mass != nullptr; }
  /// Returns the number of the node of a particle, from 1.
  Index NodeOf(Index particle) const
  {
    return this->Mesh.NumberOfPoints - this->Mesh.Particles->NumberOfParticles + particle + 1;
  }
  /// Returns the points of the nodes of a part, from 0.
  std::vector<Index> PointsOf(const ParticlePart& part) const;
};

/// Returns whether an array has a part of DeckState. Names contain "density", "energy", "stress" or
/// "plastic", in any case.
bool IsState(const MeshArray& array);

/// Stress of an element: xx yy zz xy yz xz.
std::array<double, 6> StressOf(const MeshArray& stress, Index element);

/// Returns a title for a line of its own. Control characters and characters outside of ASCII become
/// '_', also a first sign with which keywords, comments and directives begin: * $ # /
std::string PlainTitle(std::string text, std::size_t longest);
/// Returns a line about program and mesh for the head of a file.
std::string DescribeDeck(const DeckModel& model);

/// Throws InputError if the mesh has more nodes or elements than a format can number.
/// @param others  formats that can
void RequireNumbers(const DeckModel& model, Index largest, const char* format, const char* others);
/// Throws InputError if the mesh is one of another plane than that of x and y, at any z.
void RequirePlaneOfXY(const DeckModel& model, const char* format);
/// Throws InputError if the id of a material has too many digits for a format.
void RequireIds(const DeckModel& model, int largest, const char* format, const char* others);

/// Gathers the mesh, and calls write with its model on rank 0. The nodes of particles have the
/// velocities of particles.
/// @param mesh  part of this rank
/// @param isTaken  IsVelocity or IsState: arrays that the format contains
/// @throws InputError  if WriteWhole or write does; on all ranks
/// @pre Collective
void WriteDeck(const MeshData& mesh, Ranks& ranks, bool (*isTaken)(const MeshArray&),
  const std::function<void(const DeckModel&)>& write);

} // namespace vfm
