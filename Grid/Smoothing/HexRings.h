/**
 * What the active points of hexes see of them, in the order in which the energy reads it: the points around each, once each, and its
 * hexes as numbers of these.
 */
#pragma once

#include "Base/IndexBox.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vfm
{

struct ActiveMesh;

struct HexRings
{
  /// A hex at a point. Its axes are those of the hex, the first two exchanged where that makes its edges a right-handed frame.
  struct Hex
  {
    /// In the ring: the other ends of the edges along the axes, then the far corners of the faces along axes 0 and 1, 1 and 2, 2 and 0.
    std::array<std::uint8_t, 6> Ends;
    std::uint8_t IsExchanged;
  };

  static constexpr int LargestRing = 256;

  /// Around point p are Points[Offset[2 p] .. Offset[2 p + 2]); those from Offset[2 p + 1] on are the far corners of its hexes alone.
  std::vector<Index> Offset;
  std::vector<int> Points;
  std::vector<Hex> Hexes; ///< as ActiveMesh::CornerList
};

/// Of a mesh of hexes whose corners are listed.
HexRings FindHexRings(const ActiveMesh& mesh);

} // namespace vfm
