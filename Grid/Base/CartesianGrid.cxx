#include "Base/CartesianGrid.h"

#include "Base/PortableMath.h"
#include "Base/Runtime.h"

#include <cmath>
#include <sstream>
#include <string>

namespace vfm
{
namespace
{

constexpr double WidthTolerance = 1e-9; // relative difference of equal widths

// Range of widths. Volumes and moments of meshes stay in the range of double.
constexpr double SmallestWidth = 1e-50, LargestWidth = 1e50;
constexpr double LargestRatio = 1e10; // of two widths of a grid
// Largest coordinate along an axis over the smallest width there. Coordinates are rounded to 1e-16
// of their magnitude, so that positions have errors of up to 1e-6 widths, and volumes too.
constexpr double LargestDistance = 1e10;
constexpr double Slack = 1.0 + 1e-6; // of the limits, for rounded coordinates

using AxisLists = std::array<std::vector<double>, 3>;

/// Smallest and largest width of the cells along an axis, and the largest magnitude of its
/// coordinates.
struct AxisLengths
{
  char Name;
  double Narrowest, Widest, Farthest;
};

AxisLengths LengthsOf(const std::vector<double>& x, char name)
{
  AxisLengths lengths{ name, x[1] - x[0], 0.0,
    std::max(std::fabs(x.front()), std::fabs(x.back())) };
  for (std::size_t i = 1; i < x.size(); ++i)
  {
    lengths.Narrowest = std::min(lengths.Narrowest, x[i] - x[i - 1]);
    lengths.Widest = std::max(lengths.Widest, x[i] - x[i - 1]);
  }
  return lengths;
}

void CheckAxis(const AxisLengths& axis)
{
  std::ostringstream text;
  const bool isWide = axis.Narrowest * Slack >= SmallestWidth;
  if (!(isWide && axis.Widest <= Slack * LargestWidth))
  {
    text << "The grid has cells of width " << (isWide ? axis.Widest : axis.Narrowest) << " along "
         << axis.Name << ". Widths, also of refined cells, must be from " << SmallestWidth << " to "
         << LargestWidth << ". Scale the coordinates: use another unit of length.";
    throw InputError(text.str());
  }
  if (!(axis.Farthest <= Slack * LargestDistance * axis.Narrowest))
  {
    text << "The grid has cells of width " << axis.Narrowest << " along " << axis.Name
         << ", where its coordinates reach " << axis.Farthest << ". Coordinates must be at most "
         << LargestDistance << " times the smallest width, also of refined cells, because "
         << "they are rounded to 16 digits. Move the origin to the grid, or use wider cells.";
    throw InputError(text.str());
  }
}

/// Throws InputError if lengths are so large, small or different that a mesh would not be valid or
/// measurements of it would leave the range of double.
void CheckLengths(const AxisLists& coordinates)
{
  AxisLengths narrowest{}, widest{};
  for (int a = 0; a < 3; ++a)
  {
    const AxisLengths axis = LengthsOf(coordinates[a], static_cast<char>('x' + a));
    CheckAxis(axis);
    narrowest = a == 0 || axis.Narrowest < narrowest.Narrowest ? axis : narrowest;
    widest = a == 0 || axis.Widest > widest.Widest ? axis : widest;
  }
  if (!(widest.Widest <= Slack * LargestRatio * narrowest.Narrowest))
  {
    std::ostringstream text;
    text << "The grid has cells of width " << narrowest.Narrowest << " along " << narrowest.Name
         << " and of width " << widest.Widest << " along " << widest.Name
         << ". The largest width must be at most " << LargestRatio
         << " times the smallest. Use a grid with widths that differ less.";
    throw InputError(text.str());
  }
}

IndexBox WholeBox(const AxisLists& coordinates)
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
  CheckLengths(coordinates);
  return box;
}

/// Returns the coordinates of one period with `layers` copies of cells before and after it. Both
/// ends of the period are copies of its upper end, whose node has an owned cell below.
std::vector<double> RepeatCoordinates(const std::vector<double>& x, Index layers)
{
  const Index period = static_cast<Index>(x.size()) - 1;
  const double length = x.back() - x.front();
  std::vector<double> all;
  for (Index i = -layers; i <= period + layers; ++i)
  {
    const Index own = (i - 1 + (layers + 1) * period) % period + 1; // 1 to period
    const Index shift = (i - own) / period;
    all.push_back(shift == 0 ? x[own] : x[own] + static_cast<double>(shift) * length);
  }
  return all;
}

} // namespace

CartesianGrid::CartesianGrid(std::array<std::vector<double>, 3> coordinates, const IndexBox& owned,
  int ghostLayers, int hexLayers) :
  X(std::move(coordinates)),
  GlobalBox(WholeBox(this->X)),
  DomainBox(GlobalBox),
  OwnedBox(owned),
  HexGhosts(hexLayers)
{
  this->SetWidths();
  this->SetLocal(ghostLayers);
}

CartesianGrid::CartesianGrid(
  const CartesianGrid& other, const IndexBox& owned, int ghostLayers, int hexLayers) :
  CartesianGrid(other)
{
  this->OwnedBox = owned;
  this->HexGhosts = hexLayers;
  this->SetLocal(ghostLayers);
}

/// Sets the widths of cells. Those of copies are not differences of their rounded coordinates.
void CartesianGrid::SetWidths()
{
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = this->X[a];
    this->Widths[a].resize(x.size() - 1);
    for (Index i = 0; i < this->GlobalBox.Upper[a]; ++i)
    {
      Index3 cell{};
      cell[a] = i;
      const Index own = this->Canonical(cell)[a];
      this->Widths[a][i] = x[own + 1] - x[own];
    }
  }
}

/// Sets the local box and the layout of arrays.
void CartesianGrid::SetLocal(int ghostLayers)
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

CartesianGrid CartesianGrid::Covering(const std::array<std::vector<double>, 3>& coordinates,
  const IndexBox& owned, const std::array<bool, 3>& isPeriodic, Seam seam, int ghostLayers,
  int hexLayers, Index layers)
{
  const IndexBox domain = WholeBox(coordinates);
  std::array<std::vector<double>, 3> all = coordinates;
  Index3 periods{ { 0, 0, 0 } }, copies = periods;
  layers = std::max<Index>(layers, ghostLayers);
  layers += layers & 1;
  for (int a = 0; a < 3; ++a)
  {
    if (isPeriodic[a])
    {
      periods[a] = domain.Upper[a];
      all[a] = RepeatCoordinates(coordinates[a], layers);
      copies[a] = layers;
    }
  }
  CartesianGrid grid(std::move(all), Moved(owned, copies), ghostLayers, hexLayers);
  grid.DomainBox = Moved(domain, copies);
  grid.Periods = periods;
  grid.TheSeam = seam;
  grid.SetWidths();
  return grid;
}

CartesianGrid CartesianGrid::WithCells(const std::array<std::vector<double>, 3>& coordinates,
  const IndexBox& owned, int ghostLayers, Index layers) const
{
  return Covering(coordinates, owned,
    { { this->Periods[0] > 0, this->Periods[1] > 0, this->Periods[2] > 0 } }, this->TheSeam,
    ghostLayers, HexLayers, layers);
}

CartesianGrid CartesianGrid::OfDomain(int ghostLayers) const
{
  std::array<std::vector<double>, 3> coordinates;
  Index3 back;
  for (int a = 0; a < 3; ++a)
  {
    const Index first = this->DomainBox.Lower[a], last = this->DomainBox.Upper[a];
    coordinates[a].assign(this->X[a].begin() + first, this->X[a].begin() + last + 1);
    back[a] = -first;
  }
  return CartesianGrid(
    std::move(coordinates), Moved(this->OwnedBox, back), ghostLayers, this->HexGhosts);
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

Index3 CartesianGrid::CellAt(const Vector3& point, Index3 near) const
{
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = this->X[a];
    const Index last = static_cast<Index>(x.size()) - 1;
    while (near[a] < last && point[a] >= x[near[a] + 1])
    {
      ++near[a];
    }
    while (near[a] >= 0 && point[a] < x[near[a]])
    {
      --near[a];
    }
  }
  return near;
}

double CartesianGrid::PeriodLength(int axis) const
{
  const IndexBox& box = this->DomainBox;
  return this->Periods[axis] > 0 ? this->X[axis][box.Upper[axis]] - this->X[axis][box.Lower[axis]]
                                 : 0.0;
}

Index3 CartesianGrid::Canonical(const Index3& p) const
{
  Index3 own = p;
  for (int a = 0; a < 3; ++a)
  {
    const Index period = this->Periods[a], lower = this->DomainBox.Lower[a];
    if (period > 0)
    {
      own[a] = lower + ((p[a] - lower) % period + period) % period;
    }
  }
  return own;
}

Index3 CartesianGrid::CanonicalNode(const Index3& node) const
{
  Index3 own = this->Canonical(node);
  for (int a = 0; a < 3; ++a)
  {
    const bool isLower = this->Periods[a] > 0 && own[a] == this->DomainBox.Lower[a];
    own[a] += isLower ? this->Periods[a] : 0;
  }
  return own;
}

int CartesianGrid::FlatSeams(const Index3& node) const
{
  int axes = 0;
  if (this->TheSeam == Seam::Flat && this->IsPeriodic())
  {
    const Index3 own = this->Canonical(node);
    for (int a = 0; a < 3; ++a)
    {
      axes |= (this->Periods[a] > 0 && own[a] == this->DomainBox.Lower[a]) << a;
    }
  }
  return axes;
}

int CartesianGrid::FlatSeams(const Vector3& point) const
{
  int axes = 0;
  for (int a = 0; this->TheSeam == Seam::Flat && a < 3; ++a)
  {
    const Index period = this->Periods[a], first = this->DomainBox.Lower[a];
    for (Index i = period > 0 ? first % period : 0; period > 0 && i <= this->GlobalBox.Upper[a];
         i += period)
    {
      axes |= (this->X[a][i] == point[a]) << a;
    }
  }
  return axes;
}

int CartesianGrid::Colour(const Index3& node) const
{
  const Index3 own = this->Canonical(node);
  int colour = 0;
  for (int a = 2; a >= 0; --a)
  {
    const bool isOdd = (this->Periods[a] & 1) != 0;
    const bool isLast = isOdd && own[a] == this->DomainBox.Upper[a] - 1;
    const int digit = static_cast<int>((own[a] - this->DomainBox.Lower[a]) & 1);
    colour = colour * (isOdd ? 3 : 2) + (isLast ? 2 : digit);
  }
  return colour;
}

int CartesianGrid::NumberOfColours() const
{
  int count = 1;
  for (Index period : this->Periods)
  {
    count *= (period & 1) != 0 ? 3 : 2;
  }
  return count;
}

double CartesianGrid::MeanWidth() const
{
  double volume = 1.0;
  for (int a = 0; a < 3; ++a)
  {
    const IndexBox& box = this->DomainBox;
    volume *=
      (this->X[a][box.Upper[a]] - this->X[a][box.Lower[a]]) / static_cast<double>(box.Size(a));
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
