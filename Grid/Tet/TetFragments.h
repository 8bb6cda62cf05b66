/**
 * Fragments of a tetrahedral mesh that were not made of fragments of cells.
 */
#pragma once

#include "Smoothing/Volumes.h"
#include "Tet/TetFacets.h"

#include <tuple>

namespace vfm
{

/// Face-connected pieces of one material of a lattice mesh, numbered from 1 over all ranks by their lowest tet.
class TetFragments : public FragmentLocator
{
public:
  /// Fills mesh.Fragment. Collective.
  TetFragments(TetTopology& topology, const TetFaces& faces, const CartesianGrid& grid,
    const Partition& partition);

  /// Of every fragment; [0] unused.
  const std::vector<int>& Materials() const { return this->MaterialOf; }

  void ForRuns(Index j, Index k, const Body& body) const override;
  int FindNear(const Index3& cell, int material) const override;

private:
  /// A fragment in a cell with several.
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
  std::vector<int> PieceOf; // of each tet
  std::vector<int>
    PieceAt; // of each point that is an anchor, else -1; while pieces become fragments
  std::vector<int> MaterialOf;      // of each fragment
  PagedArray<int> FragmentOfCentre; // by cell; 0 where the centre lies on an interface
  std::vector<Location> Locations;  // sorted
};

} // namespace vfm
