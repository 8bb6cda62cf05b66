#include "State/MakeParticles.h"

#include "Base/PortableMath.h"
#include "State/Transfer/NodalVelocity.h"

namespace vfm
{
namespace
{

/// Columns of the rows, as values of all particles.
class RowValues
{
public:
  RowValues(const UnmeshedRows& rows, const InputContents& contents) :
    Rows(rows),
    Contents(contents),
    Width(rows.Rows.empty() ? 0 : rows.Values.size() / rows.Rows.size())
  {
  }

  /// Returns columns of all rows, row-major.
  Buffer<double> Take(int first, int count) const
  {
    Buffer<double> values(this->Rows.Rows.size() * count);
    for (std::size_t i = 0; i < this->Rows.Rows.size(); ++i)
    {
      std::copy_n(
        this->Rows.Values.data() + i * this->Width + first, count, values.data() + i * count);
    }
    return values;
  }
  Buffer<double> TakeArray(int array) const
  {
    return this->Take(
      this->Contents.FirstColumn(array), this->Contents.GetPlan().Conserved[array].Components);
  }

private:
  const UnmeshedRows& Rows;
  const InputContents& Contents;
  const std::size_t Width;
};

/// State with roles, of all particles; empty without the role.
struct RoleValues
{
  Buffer<double> Mass; ///< volume without a density
  Buffer<double> Velocity, Energy, Lost;
};

RoleValues FindRoles(const UnmeshedRows& rows, const InputContents& contents,
  const ConserveOptions& options, Runtime& runtime)
{
  const StatePlan& plan = contents.GetPlan();
  const RowValues values(rows, contents);
  RoleValues roles;
  roles.Mass = Buffer<double>(rows.Rows.size());
  const Buffer<double> density =
    plan.Density >= 0 ? values.TakeArray(plan.Density) : Buffer<double>();
  for (std::size_t i = 0; i < rows.Rows.size(); ++i)
  {
    roles.Mass[i] = rows.Rows[i].Volume * (plan.Density >= 0 ? density[i] : 1.0);
  }
  if (plan.Energy >= 0)
  {
    roles.Energy = values.TakeArray(plan.Energy);
  }
  if (plan.Velocity >= 0)
  {
    roles.Velocity = values.TakeArray(plan.Velocity);
    roles.Lost = FindLostKineticEnergy(
      roles.Mass, roles.Velocity, values.Take(contents.NumberOfColumns() - 1, 1), runtime);
  }
  if (plan.Velocity >= 0 && plan.Energy >= 0 &&
    options.LostKineticEnergy == LostEnergy::InternalEnergy)
  {
    for (std::size_t i = 0; i < rows.Rows.size(); ++i)
    {
      roles.Energy[i] += roles.Mass[i] > 0.0 ? roles.Lost[i] / roles.Mass[i] : 0.0;
    }
  }
  return roles;
}

StateSums SumsOfParticle(const UnmeshedRow& row, const RoleValues& roles, std::size_t i)
{
  StateSums sums;
  sums.Volume = row.Volume;
  sums.Mass = roles.Mass[i];
  if (!roles.Velocity.empty())
  {
    const double* u = roles.Velocity.data() + 3 * i;
    sums.Momentum = { { sums.Mass * u[0], sums.Mass * u[1], sums.Mass * u[2] } };
    sums.Kinetic = 0.5 * sums.Mass * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    sums.LostToElements = roles.Lost[i];
  }
  if (!roles.Energy.empty())
  {
    sums.Internal = sums.Mass * roles.Energy[i];
  }
  return sums;
}

/// Fills what does not depend on the state.
void FillPlaces(const UnmeshedRows& rows, const CartesianGrid& grid, const DonorCells& cells,
  ConservedParticles& made)
{
  const Index materials = cells.GetFractions().NumberOfMaterials();
  for (const UnmeshedRow& row : rows.Rows)
  {
    Index3 cell = grid.Position(row.Cell);
    for (int a = 0; a < 3; ++a)
    {
      cell[a] -= grid.Domain().Lower[a];
    }
    made.Cells.push_back(cell);
    made.Items.Ids.push_back(cells.GetGrid().CellKey(cell) * materials + row.Material - 1);
    made.Items.Material.push_back(row.Material);
    made.Items.Volume.push_back(row.Volume);
    made.Items.Radius.push_back(CubeRoot(0.75 / Pi * row.Volume));
    made.Items.Positions.insert(
      made.Items.Positions.end(), row.Position.begin(), row.Position.end());
  }
}

void AddArrays(const UnmeshedRows& rows, const InputContents& contents, RoleValues roles,
  std::vector<TransferredArray>& arrays)
{
  const StatePlan& plan = contents.GetPlan();
  const RowValues values(rows, contents);
  for (std::size_t a = 0; a < plan.Conserved.size(); ++a)
  {
    const ConservedArray& array = plan.Conserved[a];
    Buffer<double> own = static_cast<int>(a) == plan.Energy ? std::move(roles.Energy)
                                                            : values.TakeArray(static_cast<int>(a));
    for (std::size_t i = 0; array.Meaning == StateMeaning::Extensive && i < own.size(); ++i)
    {
      own[i] *= rows.Rows[i / array.Components].Volume;
    }
    arrays.push_back(contents.MakeArray(a, own));
  }
}

} // namespace

ConservedParticles MakeParticles(const UnmeshedRows& rows, const CartesianGrid& grid,
  const DonorCells& cells, const ConserveOptions& options, Runtime& runtime)
{
  const InputContents& contents = cells.GetContents();
  const int materials = cells.GetFractions().NumberOfMaterials() + 1;
  ConservedParticles made;
  FillPlaces(rows, grid, cells, made);
  RoleValues roles = FindRoles(rows, contents, options, runtime);
  made.Sums = SumByMaterial(
    made.Items.Material.data(), rows.Rows.size(), materials,
    [&](Index i) { return SumsOfParticle(rows.Rows[i], roles, i); }, runtime.Group());
  std::vector<std::int64_t> counts(materials, 0);
  for (int material : made.Items.Material)
  {
    ++counts[material];
  }
  runtime.Group().Sum(counts);
  made.Counts.assign(counts.begin(), counts.end());
  made.Items.HasMass = contents.GetPlan().Density >= 0;
  if (made.Items.HasMass)
  {
    made.Items.Mass.assign(roles.Mass.begin(), roles.Mass.end());
  }
  AddArrays(rows, contents, std::move(roles), made.Items.Arrays);
  return made;
}

} // namespace vfm
