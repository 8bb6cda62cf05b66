/**
 * MeshSummary: size, quality, volume and conserved sums of a mesh over all ranks.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

namespace vfm
{

/// Sums over a material, a fragment, or the whole mesh.
struct PartSizes
{
  int Material = 0;
  /// Points between parts count in each part, points between ranks count once.
  Index Elements = 0, Points = 0;
  double MinimumQuality = 1.0; ///< minimum scaled Jacobian
  double MeanQuality = 0.0;
  double Volume = 0.0; ///< length units cubed
};

/// A material, or the whole mesh.
struct PartSummary : PartSizes
{
  std::string Name;
  double TargetVolume = 0.0; ///< length units cubed
};

/// A fragment. Fragments are ordered by volume, the largest first, then by id.
struct FragmentSizes : PartSizes
{
  int Id = 0;
  bool operator<(const FragmentSizes& other) const
  {
    return this->Volume != other.Volume ? this->Volume > other.Volume : this->Id < other.Id;
  }
  bool operator==(const FragmentSizes& other) const { return this->Id == other.Id; }
};

/// A conserved quantity, summed over all materials.
struct StateTotal
{
  std::string Name;
  double Input = 0.0, Mesh = 0.0, Unmeshed = 0.0, Particles = 0.0;
};

/// Material without elements.
struct ParticleSummary
{
  Index Count = 0;
  double Volume = 0.0;        ///< length units cubed
  std::optional<double> Mass; ///< empty without a density
  double LostEnergy = 0.0;    ///< kinetic energy that joined particles lack
};

/// A surface of the input, and what the mesh keeps of it (BodyFields.h).
struct SurfaceSummary
{
  std::string Name; ///< of the material
  int Material = 0;
  double Thickness = 0.0;      ///< in finest cells
  double SuggestedWidth = 0.0; ///< of cells, length units
  double Lost = 0.0;           ///< share of the area
  Index Solids = 0, Fragments = 0;
};

struct MeshSummary
{
  bool IsTets = false, HasQuality = false;
  std::vector<PartSummary> Materials;
  Index NumberOfFragments = 0;
  std::vector<FragmentSizes> LargestFragments; ///< at most MaximumFragments, in their order
  PartSummary Total;
  std::vector<SurfaceSummary> Surfaces;           ///< empty if the input has no surfaces
  double MinimumAngle = 0.0, MaximumAngle = 0.0;  ///< dihedral angles of tets, degrees
  std::vector<Index> Angles;                      ///< tets: histogram in steps of ten degrees
  std::vector<StateTotal> State;                  ///< empty unless state was conserved
  double LostToElements = 0.0, LostToNodes = 0.0; ///< lost kinetic energy
  std::optional<ParticleSummary> Particles;       ///< empty if it does not become particles
};

class MeshWithRuns;

/// Number of fragments that a summary lists.
constexpr std::size_t MaximumFragments = 10;

/// Summarises a mesh. The result is equal on all ranks and for any number of ranks.
/// @param mesh part of this rank, with the fields of RunMesher
/// @param whole the mesh with the hexes that it leaves out; null: none
/// @pre Collective
MeshSummary Summarise(const MeshData& mesh, Ranks& ranks, const MeshWithRuns* whole = nullptr);

} // namespace vfm
