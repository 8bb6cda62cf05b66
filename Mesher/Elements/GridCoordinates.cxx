#include "Elements/GridCoordinates.h"

namespace vfm
{

Vector3 ToGrid(const CartesianGrid& grid, const double* point)
{
  const double scale = grid.MeanWidth();
  Vector3 x;
  for (int a = 0; a < 3; ++a)
  {
    x[a] = (point[a] - grid.Coordinates(a)[0]) / scale;
  }
  return x;
}

std::array<std::vector<double>, 3> ToGrid(
  const CartesianGrid& grid, std::array<std::vector<double>, 3> nodes)
{
  for (int a = 0; a < 3; ++a)
  {
    for (double& x : nodes[a])
    {
      Vector3 point{};
      point[a] = x;
      x = ToGrid(grid, point.data())[a];
    }
  }
  return nodes;
}

int FindDomainSides(const CartesianGrid& grid, const double* point)
{
  int sides = 0;
  for (int a = 0; a < 3; ++a)
  {
    sides |= (point[a] == grid.Coordinates(a).front()) << (2 * a) |
      (point[a] == grid.Coordinates(a).back()) << (2 * a + 1);
  }
  return sides;
}

} // namespace vfm
