/**
 * TetStars: the tets around each point that moves, as its energy reads them: the other ends of the edges at the point, once each, and of
 * each tet which three of these are its corners, in positive order as seen with the point first. Eight tets stand side by side; the last
 * eight are filled up with the last tet.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <array>

namespace vfm
{

class TetStars
{
public:
  static constexpr int Width = 8;
  /// Points with more have no star.
  static constexpr int MaximumNeighbours = 64;
  /// k: places of corner k of each tet among the neighbours.
  using Eight = std::array<std::array<unsigned char, Width>, 3>;

  /// elements: four points a tet. The tets at point p: those at positions corners[begin[p] .. begin[p + 1]) in elements.
  void Build(const std::vector<int>& elements, const std::vector<Index>& begin,
    const std::vector<std::uint32_t>& corners);

  struct Star
  {
    const int *FirstNeighbour, *LastNeighbour;
    const Eight* Tets;
  };
  /// Whether the point moves, and has not too many neighbours.
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
