#include "Smoothing/TetStars.h"

#include <algorithm>

namespace vfm
{

void TetStars::Build(const std::vector<int>& elements, const std::vector<std::uint32_t>& begin,
  const std::vector<std::uint32_t>& corners)
{
  const std::size_t points = begin.size() - 1;
  this->Neighbours.clear();
  this->Tets.clear();
  this->FirstNeighbour.assign(1, 0);
  this->FirstTets.assign(1, 0);
  this->FirstNeighbour.reserve(points + 1);
  this->FirstTets.reserve(points + 1);
  // Index of each point in the star in which it was found last, and the centre of that star.
  std::vector<int> star, placeOf(points);
  std::vector<int> starOf(points, -1);
  for (std::size_t p = 0; p < points; ++p)
  {
    star.clear();
    const std::size_t firstTets = this->Tets.size();
    for (Index at = begin[p]; at < begin[p + 1]; ++at)
    {
      const int lane = static_cast<int>((at - begin[p]) % Width);
      if (lane == 0)
      {
        this->Tets.emplace_back();
      }
      for (int k = 0; k < 3; ++k)
      {
        // c ^ 1, c ^ 2, c ^ 3 follow c in an even permutation for every corner c
        const int other = elements[corners[at] ^ (k + 1)];
        if (starOf[other] != static_cast<int>(p))
        {
          starOf[other] = static_cast<int>(p);
          placeOf[other] = static_cast<int>(star.size());
          star.push_back(other);
        }
        std::fill(this->Tets.back()[k].begin() + lane, this->Tets.back()[k].end(),
          static_cast<unsigned char>(placeOf[other]));
      }
    }
    if (star.size() > MaximumNeighbours)
    {
      star.clear();
      this->Tets.resize(firstTets);
    }
    this->Neighbours.insert(this->Neighbours.end(), star.begin(), star.end());
    this->FirstNeighbour.push_back(static_cast<Index>(this->Neighbours.size()));
    this->FirstTets.push_back(static_cast<Index>(this->Tets.size()));
  }
}

} // namespace vfm
