/**
 * TetStars: the tets around each point that moves, in the layout that TetEnergy reads. A star lists
 * the far ends of the edges at the point once each. Each tet has three indices into this list, its
 * other corners, in positive order as seen with the point first. Eight tets form a SIMD group; the
 * last group is filled up with the last tet.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <array>

namespace vfm
{

/// Neighbours and tets of each point that moves. Thread safe once made.
class TetStars
{
public:
  static constexpr int Width = 8;
  /// Points with more neighbours have no star.
  static constexpr int MaximumNeighbours = 64;
  /// k: index of corner k of each tet among the neighbours.
  using Eight = std::array<std::array<unsigned char, Width>, 3>;

  /// Finds the stars of all points.
  /// @param elements  four points per tet
  /// @param begin  first entry of each point in corners, and the end
  /// @param corners  positions in elements of the tets at each point
  void Build(const std::vector<int>& elements, const std::vector<std::uint32_t>& begin,
    const std::vector<std::uint32_t>& corners);

  struct Star
  {
    const int *FirstNeighbour, *LastNeighbour;
    const Eight* Tets;
  };
  /// Returns whether a point has a star: it moves and has at most MaximumNeighbours neighbours.
  bool Has(int point) const
  {
    return !this->Tets.empty() && this->FirstTets[point] < this->FirstTets[point + 1];
  }
  Star At(int point) const
  {
    const int* neighbours = this->Neighbours.data();
    return { neighbours + this->FirstNeighbour[point], neighbours + this->FirstNeighbour[point + 1],
      this->Tets.data() + this->FirstTets[point] };
  }

private:
  std::vector<Index> FirstNeighbour, FirstTets;
  std::vector<int> Neighbours;
  std::vector<Eight> Tets;
};

} // namespace vfm
