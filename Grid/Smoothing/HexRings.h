/**
 * What the active points of hexes see of them, in the order in which the energy reads it: the points around each, once each, and its
 * hexes as numbers of these.
 *
 * Most points see the same: the hexes of a star of cells in the same order. So these numbers are kept once for all points that share
 * them.
 */
#pragma once

#include "Base/Runtime.h"

#include <array>

namespace vfm
{

struct ActiveMesh;

class HexRings
{
public:
  /// A hex at a point. Its axes are those of the hex, the first two exchanged where that makes its edges a right-handed frame.
  struct Hex
  {
    /// In the ring: the other ends of the edges along the axes, then the far corners of the faces along axes 0 and 1, 1 and 2, 2 and 0.
    std::array<std::uint8_t, 6> Ends;
    std::uint8_t IsExchanged;
  };

  static constexpr int LargestRing = 256;

  HexRings() = default;
  /// Of a mesh of hexes whose corners are listed.
  HexRings(const ActiveMesh& mesh, Runtime& runtime);

  bool IsEmpty() const { return this->Blocks.empty(); }
  /// The points around an active point; those from Near on are the far corners of its hexes alone.
  struct Ring
  {
    const int *First, *Near, *Last;
  };
  Ring PointsAt(int point) const
  {
    const Block& block = this->Blocks[point / PointsOfBlock];
    const Place& place = block.Places[point % PointsOfBlock];
    const int* points = block.Points.data();
    return { points + place.First, points + place.Near,
      points + block.Places[point % PointsOfBlock + 1].First };
  }
  /// As many as in ActiveMesh::CornerList, in its order.
  const Hex* HexesAt(int point) const
  {
    return this->Hexes.data() +
      this->Blocks[point / PointsOfBlock].Places[point % PointsOfBlock].Hexes;
  }

private:
  static constexpr int PointsOfBlock = 2048;
  /// Of a point in its block, and of its hexes among all.
  struct Place
  {
    std::uint32_t First, Near, Hexes;
  };
  struct Block
  {
    std::vector<Place> Places; // and the end
    std::vector<int> Points;
  };
  class Finder;

  std::vector<Block> Blocks;
  std::vector<Hex> Hexes;
};

} // namespace vfm
