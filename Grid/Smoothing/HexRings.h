/**
 * HexRings: the distinct points around each active point of a hex mesh, and the hexes at it as
 * indices of these points. The hexes are in the order in which HexEnergy reads them.
 *
 * Most points have the hexes of an equal star of cells in equal order. Such lists of indices are
 * stored once for all points that share them.
 */
#pragma once

#include "Base/Runtime.h"

#include <array>

namespace vfm
{

struct ActiveMesh;

/// Points and hexes around each active point. Thread safe once made.
class HexRings
{
public:
  /// Hex at a point, with the axes of the hex. The first two axes are exchanged if that makes the
  /// edges at the point a right-handed frame.
  struct Hex
  {
    /// Indices in the ring: far ends of the edges along axes 0, 1, 2, then far corners of the faces
    /// along axes 0 and 1, 1 and 2, 2 and 0.
    std::array<std::uint8_t, 6> Ends;
    std::uint8_t IsExchanged;
  };

  static constexpr int LargestRing = 256;

  HexRings() = default;
  /// Finds the rings of all active points.
  /// @pre The corners of the mesh are listed (ActiveMesh::ListCorners).
  HexRings(const ActiveMesh& mesh, Runtime& runtime);

  bool IsEmpty() const { return this->Blocks.empty(); }
  /// Points around an active point. From Near on, they are only far corners of its hexes.
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
  /// Returns the hexes at an active point, in number and order of ActiveMesh::CornerList.
  const Hex* HexesAt(int point) const
  {
    return this->Hexes.data() +
      this->Blocks[point / PointsOfBlock].Places[point % PointsOfBlock].Hexes;
  }

private:
  static constexpr int PointsOfBlock = 2048;
  /// Offsets of a point: in the points of its block, and of its hexes among all.
  struct Place
  {
    std::uint32_t First, Near, Hexes;
  };
  struct Block
  {
    std::vector<Place> Places; // one per point, and the end
    std::vector<int> Points;
  };
  class Finder;

  std::vector<Block> Blocks;
  std::vector<Hex> Hexes;
};

} // namespace vfm
