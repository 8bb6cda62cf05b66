#include "State/Transfer/FarContents.h"

#include <algorithm>
#include <tuple>

namespace vfm
{
namespace
{

constexpr double Rounding = 1e-9; // part of a volume that counts as nothing

} // namespace

Vector3 CentreOfCell(const CartesianGrid& grid, const Index3& cell)
{
  Vector3 centre;
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = grid.Coordinates(a);
    centre[a] = 0.5 * (x[cell[a]] + x[cell[a] + 1]);
  }
  return centre;
}

double FarContents::Take(Index cell, int material, double volume, const double* values)
{
  if (!this->Request || this->Request->Far.empty())
  {
    return volume;
  }
  const std::vector<FarVolume>& all = this->Request->Far;
  const auto found = std::lower_bound(all.begin(), all.end(), std::tie(cell, material),
    [](const FarVolume& far, const std::tuple<const Index&, const int&>& key)
    { return std::tie(far.Cell, far.Material) < key; });
  if (found == all.end() || found->Cell != cell || found->Material != material)
  {
    return volume;
  }
  const bool isAll = found->Volume >= (1.0 - Rounding) * volume;
  const double far = isAll ? volume : found->Volume;
  this->Add(cell, material, far, values);
  return volume - far;
}

bool FarContents::TakeRest(Index cell, int material, double volume, const double* values)
{
  if (!this->Request || material == 0)
  {
    return false;
  }
  this->Add(cell, material, volume, values);
  return true;
}

void FarContents::Add(Index cell, int material, double volume, const double* values)
{
  std::vector<UnmeshedRow>& rows = this->Rows.Rows;
  if (!rows.empty() && rows.back().Cell == cell && rows.back().Material == material)
  {
    rows.back().Volume += volume;
    return;
  }
  const UnmeshedRow row{ cell, material, volume,
    CentreOfCell(this->Grid, this->Grid.Position(cell)) };
  this->Rows.Add(row, values, this->Columns.Count());
}

} // namespace vfm
