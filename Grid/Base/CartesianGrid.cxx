#include "Base/CartesianGrid.h"

#include "Base/PortableMath.h"
#include "Base/Runtime.h"

#include <cmath>
#include <string>

namespace vfm
{
namespace
{

constexpr double WidthTolerance = 1e-9; // relative difference of equal widths

IndexBox WholeBox(const std::array<std::vector<double>, 3>& coordinates)
{
  IndexBox box;
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = coordinates[a];
    const std::string name(1, static_cast<char>('x' + a));
    if (x.size() < 2)
    {
      throw InputError("The grid has no cells along " + name + ": a 3D grid of cells is needed.");
    }
    for (std::size_t i = 1; i < x.size(); ++i)
    {
      if (!(x[i] > x[i - 1]))
      {
        throw InputError("The " + name + " coordinates of the grid do not increase at index " +
          std::to_string(i) + ".");
      }
    }
    box.Upper[a] = static_cast<Index>(x.size()) - 1;
  }
  return box;
}

} // namespace

CartesianGrid::CartesianGrid(std::array<std::vector<double>, 3> coordinates, const IndexBox& owned,
  int ghostLayers, int hexLayers) :
  X(std::move(coordinates)), GlobalBox(WholeBox(this->X)), OwnedBox(owned), HexGhosts(hexLayers)
{
  this->LocalBox = this->GlobalBox; // Extended clips at LocalBox: here at the domain
  this->LocalBox = this->Extended(ghostLayers);
  Index stride = 1;
  for (int a = 0; a < 3; ++a)
  {
    this->Origin[a] = this->LocalBox.Lower[a] - 1;
    this->Strides[a] = stride;
    stride *= this->LocalBox.Size(a) + 2;
  }
  this->Entries = stride;
  for (int c = 0; c < 8; ++c)
  {
    this->Corners[c] = (c & 1) * this->Strides[0] + (c >> 1 & 1) * this->Strides[1] +
      (c >> 2 & 1) * this->Strides[2];
  }
}

CartesianGrid::CartesianGrid(std::array<std::vector<double>, 3> coordinates) :
  CartesianGrid(coordinates, WholeBox(coordinates))
{
}

IndexBox CartesianGrid::Extended(int levels) const
{
  return Grow(this->OwnedBox, levels, this->LocalBox);
}

Index3 CartesianGrid::CellAt(const Vector3& point) const
{
  Index3 cell;
  for (int a = 0; a < 3; ++a)
  {
    cell[a] =
      std::upper_bound(this->X[a].begin(), this->X[a].end(), point[a]) - this->X[a].begin() - 1;
  }
  return cell;
}

double CartesianGrid::MeanWidth() const
{
  double volume = 1.0;
  for (int a = 0; a < 3; ++a)
  {
    volume *=
      (this->X[a].back() - this->X[a].front()) / static_cast<double>(this->GlobalBox.Upper[a]);
  }
  return CubeRoot(volume);
}

bool IsUniform(const CartesianGrid& grid)
{
  for (int a = 0; a < 3; ++a)
  {
    for (Index i = 1; i < grid.Global().Upper[a]; ++i)
    {
      if (std::fabs(grid.Width(a, i) - grid.Width(a, 0)) > WidthTolerance * grid.Width(a, 0))
      {
        return false;
      }
    }
  }
  return true;
}

bool HasCubes(const CartesianGrid& grid)
{
  const double width = grid.Width(0, 0);
  return IsUniform(grid) && std::fabs(grid.Width(1, 0) - width) < WidthTolerance * width &&
    std::fabs(grid.Width(2, 0) - width) < WidthTolerance * width;
}

} // namespace vfm
