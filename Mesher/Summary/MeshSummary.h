/**
 * MeshSummary: what a mesh is, as numbers over all ranks.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Summary/MeshData.h"

namespace vfm
{

/// A material, a fragment, or the whole.
struct PartSummary
{
  std::string Name;
  int Material = 0;
  Index Elements = 0, Points = 0; ///< points between parts count in each, points between ranks once
  double MinimumQuality = 1.0;    ///< scaled Jacobian
  double MeanQuality = 0.0;
  double Volume = 0.0, TargetVolume = 0.0; ///< length units cubed; targets not of fragments
};

/// A sum over all materials that was carried from the cells to the elements.
struct StateTotal
{
  std::string Name;
  double Input = 0.0, Mesh = 0.0, Unmeshed = 0.0;
};

struct MeshSummary
{
  bool IsTets = false, HasQuality = false;
  std::vector<PartSummary> Materials, Fragments; ///< Fragments[f] has FragmentId f + 1
  PartSummary Total;
  double MinimumAngle = 0.0, MaximumAngle = 0.0;  ///< dihedral, degrees; of tets
  std::vector<Index> Angles;                      ///< of tets: how many in each ten degrees
  std::vector<StateTotal> State;                  ///< where state was conserved
  double LostToElements = 0.0, LostToNodes = 0.0; ///< kinetic energy that the cells had
};

/// Collective. mesh: this rank's part of the mesh of a mesher, with its fields. Equal on all ranks, and for any number of them.
MeshSummary Summarise(const MeshData& mesh, Ranks& ranks);

} // namespace vfm
