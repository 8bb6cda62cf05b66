#include "Labels/PartsAround.h"

#include <array>

namespace vfm
{
namespace
{

constexpr int Middle = 13;
constexpr CellsAround AllButMiddle = ((1u << 27) - 1) & ~(1u << Middle);

/// Returns the sum of the distances along the axes between two of the 27 cells, or 0 if a distance
/// is above 1.
constexpr int StepsBetween(int a, int b)
{
  int sum = 0;
  for (int axis = 0; axis < 3; ++axis, a /= 3, b /= 3)
  {
    const int d = a % 3 - b % 3;
    if (d < -1 || d > 1)
    {
      return 0;
    }
    sum += d != 0;
  }
  return sum;
}

using Neighbours = std::array<CellsAround, 27>;

/// Returns the cells that are at most `most` steps from each cell.
constexpr Neighbours MakeNeighbours(int most)
{
  Neighbours neighbours{};
  for (int a = 0; a < 27; ++a)
  {
    for (int b = 0; b < 27; ++b)
    {
      const int steps = StepsBetween(a, b);
      neighbours[a] |= steps > 0 && steps <= most ? 1u << b : 0u;
    }
  }
  return neighbours;
}

constexpr Neighbours ByFace = MakeNeighbours(1), ByEdge = MakeNeighbours(2),
                     ByCorner = MakeNeighbours(3);

/// Returns the part of a set that contains its cell `start`, a mask of one bit.
CellsAround PartOf(CellsAround start, CellsAround set, const Neighbours& neighbours)
{
  CellsAround part = start, front = start;
  while (front != 0)
  {
    const int cell = __builtin_ctz(front);
    const CellsAround next = neighbours[cell] & set & ~part;
    part |= next;
    front = (front & (front - 1)) | next;
  }
  return part;
}

/// Counts the parts of a set that contain any of the cells `starts`.
int CountParts(CellsAround starts, CellsAround set, const Neighbours& neighbours)
{
  int count = 0;
  for (; starts != 0; ++count)
  {
    starts &= ~PartOf(starts & (~starts + 1), set, neighbours);
  }
  return count;
}

} // namespace

int CountPartsOfSet(CellsAround set)
{
  const CellsAround near = set & ByEdge[Middle];
  return CountParts(near & ByFace[Middle], near, ByFace);
}

int CountPartsOfRest(CellsAround set)
{
  const CellsAround rest = ~set & AllButMiddle;
  return CountParts(rest, rest, ByCorner);
}

} // namespace vfm
