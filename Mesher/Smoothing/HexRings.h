/**
 * HexRings: the distinct points around each active point of a hex mesh, and the hexes at it as
 * indices of these points. The hexes are in the order in which HexEnergy reads them.
 *
 * Most points have the hexes of an equal star of cells in equal order. Such lists of indices are
 * stored once for all points that share them.
 *
 * Points of a ring are near each other in memory, so most rings are stored in 16 bits per point.
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
  /// @pre The corners of the mesh are listed (ActiveMesh::ListCorners) and its demands set.
  HexRings(const ActiveMesh& mesh, Runtime& runtime);

  bool IsEmpty() const { return this->Blocks.empty(); }

  /// Points of two ranges of numbers as codes of 16 bits: first the points that move, then the rim.
  struct PointCodes
  {
    int MovingShift = 0, RimShift = 0; ///< point minus code
    int FirstOfRim = 0;                ///< code
    int Point(int code) const
    {
      return code + (code < this->FirstOfRim ? this->MovingShift : this->RimShift);
    }
  };
  /// Points around an active point. From Near on, they are only far corners of its hexes.
  class Ring
  {
  public:
    int Near, Count;
    int operator[](int n) const
    {
      return this->Wide ? this->Wide[n] : this->Codes->Point(this->Narrow[n]);
    }

  private:
    friend class HexRings;
    Ring(int near, int count) : Near(near), Count(count) {}

    const PointCodes* Codes = nullptr;
    const std::uint16_t* Narrow = nullptr;
    const int* Wide = nullptr; // nullptr if the points have codes
  };
  Ring PointsAt(int point) const
  {
    const Block& block = this->Blocks[point / PointsOfBlock];
    const Place* place = block.Places.data() + point % PointsOfBlock;
    Ring ring(place->Near, static_cast<int>(place[1].First - place->First));
    ring.Codes = &block.Codes;
    ring.Narrow = block.Narrow.data() + place->First;
    ring.Wide = block.Wide.empty() ? nullptr : block.Wide.data() + place->First;
    return ring;
  }
  /// Returns whether a hex at an active point has a demand other than 1 (ActiveMesh::Demands).
  bool HasDemands(int point) const
  {
    return this->Blocks[point / PointsOfBlock].Places[point % PointsOfBlock].HasDemands;
  }
  /// Finds HasDemands again after demands have changed.
  void UpdateDemands(const ActiveMesh& mesh);
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
    std::uint32_t First, Hexes;
    std::uint16_t Near; // points of the ring that are not only far corners
    bool HasDemands;    // whether the demand of a hex is not 1
  };
  struct Block
  {
    std::vector<Place> Places; // one per point, and the end
    // Points of the rings: codes, or the points themselves if codes need more than 16 bits.
    PointCodes Codes;
    std::vector<std::uint16_t> Narrow;
    std::vector<int> Wide;

    void Store(const std::vector<int>& points, int firstOfRim);
  };
  class Finder;

  std::vector<Block> Blocks;
  std::vector<Hex> Hexes;
};

} // namespace vfm
