/**
 * TetFragments: fragments of a Lattice mesh, which are found by its tets.
 */
#pragma once

#include "Elements/Tet/TetFacets.h"
#include "Volumes/FragmentVolumes.h"

#include <tuple>

namespace vfm
{

/// Fragments of a Lattice mesh: face-connected sets of tets of one material, as numbered on this
/// rank (FragmentShare). Over all ranks, they are numbered by their lowest tet. Grid and partition
/// must outlive this object.
class TetFragments : public FragmentLocator
{
public:
  /// Finds the fragments and fills Mesh::Fragment of the tets.
  /// @pre Collective.
  TetFragments(TetTopology& topology, const TetFaces& faces, const CartesianGrid& grid,
    const Partition& partition);

  /// Returns the fragments of this rank, whose numbers the tets have.
  const FragmentShare& Share() const { return this->Own; }

  void ForRuns(Index j, Index k, const Body& body) const override;
  int FindNear(const Index3& cell, int material) const override;

private:
  /// Fragment of a cell that interfaces run through.
  struct Location
  {
    Index Cell;
    int Material, Fragment;
    bool operator<(const Location& other) const
    {
      return std::tie(this->Cell, this->Material, this->Fragment) <
        std::tie(other.Cell, other.Material, other.Fragment);
    }
  };
  std::vector<Piece> FindPieces(const TetTopology& topology, const TetFaces& faces);
  PiecePairs FindSame(const TetTopology& topology, Index offset) const;
  PiecePairs FindSameTets(const TetTopology& topology, Index offset) const;
  void FindLocations(const TetTopology& topology, const std::vector<int>& fragments);
  void AddLocations(const Mesh& mesh, Index tet);

  const CartesianGrid& Grid;
  const Partition& Parts;
  std::vector<int> PieceOf; // local component of each tet, -1 if it is only a barrier
  // Local component of each point, -1 if it is not an anchor; freed by FindLocations.
  std::vector<int> PieceAt;
  FragmentShare Own;
  PagedArray<int> FragmentOfCentre; // one per cell; 0 if its centre is on an interface
  std::vector<Location> Locations;  // sorted
};

} // namespace vfm
