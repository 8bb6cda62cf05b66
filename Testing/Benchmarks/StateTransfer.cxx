/**
 * Cost of transferring state to a mesh compared with making the mesh, in CPU seconds of one thread,
 * and the loss if elements copy the values of cells instead.
 *
 * The state has six arrays of eight components: density, velocity, specific energy,
 * temperature, strain, pressure.
 *
 * usage: StateTransfer [diameter of the sphere in cells, default 64]
 *                      [cells along an axis of the polycrystal, default 48]
 */
#include "Base/Vector3.h"
#include "MeasureAlone.h"
#include "MeshCases.h"
#include "SerialTimes.h"
#include "State/SmoothState.h"
#include "State/Transfer/NodalVelocity.h"
#include "State/Transfer/Overlaps.h"
#include "State/Transfer/StateCells.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>

using namespace vfm;
using namespace vfm::testing;

namespace
{

const char* NameOf(Elements elements)
{
  return elements == Elements::Hexes ? "hexes"
    : elements == Elements::Lattice  ? "tets of Lattice"
                                     : "tets of Cells";
}

/// Values of cells, the same for all materials, as in arrays of a simulation.
class CellArrays : public StateCellValues
{
public:
  explicit CellArrays(const CartesianGrid& grid) :
    Grid(grid), Values(grid.Local().NumberOfCells() * SmoothComponents)
  {
    const Vector3 size = grid.NodePoint(grid.Global().Upper);
    std::size_t at = 0;
    ForCells(grid.Local(),
      [&](const Index3& cell)
      {
        const Vector3 centre = 0.5 * (grid.NodePoint(cell) + grid.NodePoint(CornerOfCell(cell, 7)));
        EvaluateSmoothState(Divided(centre, size), 1, this->Values.data() + at);
        at += SmoothComponents;
      });
  }
  void Read(const Index3& cell, int, double* values) const override
  {
    std::copy_n(this->Values.data() + IndexInBox(this->Grid.Local(), cell) * SmoothComponents,
      SmoothComponents, values);
  }

private:
  const CartesianGrid& Grid;
  std::vector<double> Values;
};

TransferredState Transfer(const Mesh& mesh, const CartesianGrid& grid,
  const FractionField& fractions, const StateCellValues& values, int order)
{
  TransferRequest request{ grid, fractions, values, ListSmoothQuantities() };
  request.Density = 0;
  request.Order = order;
  Runtime runtime;
  return TransferState(mesh, request, runtime);
}

/// Returns the smaller of two times, in CPU seconds.
template <class Work>
double Time(const Work& work)
{
  double least = 1e300;
  for (int i = 0; i < 2; ++i)
  {
    const double begin = CpuSeconds(CLOCK_PROCESS_CPUTIME_ID);
    work();
    least = std::min(least, CpuSeconds(CLOCK_PROCESS_CPUTIME_ID) - begin);
  }
  return least;
}

/// Returns peak bytes before anything is transferred.
std::vector<double> MeasureMesh(const MeshCase& c, Elements elements)
{
  const CellArrays values(c.Grid);
  const Mesh mesh = MakeMesh(c.Grid, c.Fractions, elements);
  return { static_cast<double>(PeakBytes()) };
}

/// Returns peak bytes, elements, seconds of meshing, of transfer in both orders and of copying.
std::vector<double> MeasureTransfer(const MeshCase& c, Elements elements)
{
  const CellArrays values(c.Grid);
  Mesh mesh = MakeMesh(c.Grid, c.Fractions, elements);
  Transfer(mesh, c.Grid, c.Fractions, values, 2);
  std::vector<double> figures{ static_cast<double>(PeakBytes()),
    static_cast<double>(mesh.ElementIds.size()) };
  figures.push_back(Time([&] { mesh = MakeMesh(c.Grid, c.Fractions, elements); }));
  for (int order : { 1, 2 })
  {
    figures.push_back(Time([&] { Transfer(mesh, c.Grid, c.Fractions, values, order); }));
  }
  Runtime runtime;
  figures.push_back(Time([&] { FindStateCells(mesh, c.Grid, c.Fractions, runtime); }));
  return figures;
}

/// Prints a row of the table.
void PrintCost(const MeshCase& c, Elements elements)
{
  const std::vector<double> before = MeasureAlone(1, [&] { return MeasureMesh(c, elements); });
  const std::vector<double> f = MeasureAlone(6, [&] { return MeasureTransfer(c, elements); });
  if (before.empty() || f.empty())
  {
    std::printf("| %s, %s | failed |\n", c.Name.c_str(), NameOf(elements));
    return;
  }
  std::printf("| %s | %.0f %s | %.3f | %.3f | %.3f | %.1f %% | %.3f | %.0f | %.0f |\n",
    c.Name.c_str(), f[1], NameOf(elements), f[2], f[3], f[4], 100.0 * f[4] / f[2], f[5],
    1e-6 * before[0], 1e-6 * (f[0] - before[0]));
  std::fflush(stdout);
}

/// The arrays and, as the last quantity, |u|^2 / 2 of each cell.
class WithKineticEnergy : public StateCellValues
{
public:
  explicit WithKineticEnergy(const StateCellValues& values) : Values(values) {}
  void Read(const Index3& cell, int material, double* values) const override
  {
    this->Values.Read(cell, material, values);
    const Vector3 u{ { values[1], values[2], values[3] } };
    values[SmoothComponents] = 0.5 * Dot(u, u);
  }
  static std::vector<StateQuantity> Quantities()
  {
    std::vector<StateQuantity> quantities = ListSmoothQuantities();
    quantities.push_back({ StateKind::PerMass, 1, -1 });
    return quantities;
  }

private:
  const StateCellValues& Values;
};

/// Sums over cells, elements or points.
struct Sums
{
  long double Mass = 0.0, Kinetic = 0.0, Internal = 0.0;
  std::array<long double, 3> Momentum{};

  void Add(long double mass, const double* velocity, double energy)
  {
    this->Mass += mass;
    this->Internal += mass * energy;
    for (int a = 0; a < 3; ++a)
    {
      this->Momentum[a] += mass * velocity[a];
      this->Kinetic += mass * velocity[a] * velocity[a] / 2;
    }
  }
};

Sums SumCells(
  const CartesianGrid& grid, const FractionField& fractions, const StateCellValues& values)
{
  Sums sums;
  ForCells(grid.Global(),
    [&](const Index3& cell)
    {
      const double fraction = fractions.Fraction(grid.Linear(cell), 1);
      double own[SmoothComponents + 1];
      if (fraction > 0.0)
      {
        values.Read(cell, 1, own);
        sums.Add(
          static_cast<long double>(fraction) * grid.CellVolume(cell) * own[0], own + 1, own[4]);
      }
    });
  return sums;
}

/// Returns the values of the cells, copied to elements.
TransferredState CopyState(const Mesh& mesh, const CartesianGrid& grid,
  const FractionField& fractions, const StateCellValues& values)
{
  Runtime runtime;
  const std::vector<Index> cells = FindStateCells(mesh, grid, fractions, runtime);
  TransferredState state;
  for (const StateQuantity& quantity : WithKineticEnergy::Quantities())
  {
    state.Values.emplace_back(cells.size() * quantity.Components);
  }
  state.Mass = Buffer<double>(cells.size());
  for (std::size_t e = 0; e < cells.size(); ++e)
  {
    double own[SmoothComponents + 1];
    values.Read(CellInBox(grid.Local(), cells[e]), mesh.Material[e], own);
    const double* from = own;
    for (Buffer<double>& to : state.Values)
    {
      const std::size_t components = to.size() / cells.size();
      std::copy_n(from, components, to.data() + components * e);
      from += components;
    }
    state.Mass[e] = own[0] * VolumeOfElement(mesh, static_cast<Index>(e));
  }
  return state;
}

long double Sum(const Buffer<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0L);
}

/// Prints the change of the sums relative to the cells.
void PrintLosses(const char* rule, const CartesianGrid& grid, const Mesh& mesh, const Sums& input,
  const TransferredState& state)
{
  Sums elements, points;
  for (std::size_t e = 0; e < state.Mass.size(); ++e)
  {
    elements.Add(state.Mass[e], state.Values[1].data() + 3 * e, state.Values[2][e]);
  }
  Runtime runtime;
  const NodalVelocity nodal = FindNodalVelocity(mesh, grid, state.Mass, state.Values[1], runtime);
  for (std::size_t p = 0; p < nodal.Mass.size(); ++p)
  {
    points.Add(nodal.Mass[p], nodal.Velocity.data() + 3 * p, 0.0);
  }
  const long double lost =
    Sum(FindLostKineticEnergy(state.Mass, state.Values[1], state.Values.back(), runtime));
  const auto distance = [](const Sums& a, const Sums& b)
  {
    long double squares = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      squares += (a.Momentum[k] - b.Momentum[k]) * (a.Momentum[k] - b.Momentum[k]);
    }
    return std::sqrt(squares);
  };
  const long double momentum = distance(input, Sums()), total = input.Kinetic + input.Internal;
  std::printf("| %s | %.2Lg | %.2Lg | %.2Lg | %.2Lg | %.2Lg | %.2Lg | %.2Lg |\n", rule,
    (elements.Mass - input.Mass) / input.Mass, distance(elements, input) / momentum,
    (elements.Kinetic - input.Kinetic) / input.Kinetic,
    (elements.Kinetic + lost + elements.Internal - total) / total,
    (points.Kinetic - input.Kinetic) / input.Kinetic, distance(points, input) / momentum,
    (points.Kinetic + Sum(nodal.Lost) + lost + elements.Internal - total) / total);
}

/// Compares the rules for a ball in n^3 cells of the unit cube.
void CompareRules(int n, Elements elements)
{
  const CartesianGrid grid = MakeUnitCube(n);
  const FractionField fractions =
    FractionsOfShapes(grid, { MakeSphere(1, { { 0.51, 0.52, 0.49 } }, 0.37) });
  const CellArrays arrays(grid);
  const WithKineticEnergy values(arrays);
  const Mesh mesh = MakeMesh(grid, fractions, elements);
  const Sums input = SumCells(grid, fractions, values);
  std::printf(
    "\n| ball, %d^3 cells, %zu %s | mass | momentum | kinetic energy | energy, what is lost "
    "counted "
    "| kinetic energy of points | momentum of points | energy of points, what is lost counted |\n"
    "|---|---|---|---|---|---|---|---|\n",
    n, mesh.ElementIds.size(), NameOf(elements));
  PrintLosses("copied", grid, mesh, input, CopyState(mesh, grid, fractions, values));
  for (int order : { 1, 2 })
  {
    TransferRequest request{ grid, fractions, values, WithKineticEnergy::Quantities() };
    request.Density = 0;
    request.Order = order;
    Runtime runtime;
    PrintLosses(order == 1 ? "conserved, order 1" : "conserved, order 2", grid, mesh, input,
      TransferState(mesh, request, runtime));
  }
}

} // namespace

int main(int argc, char** argv)
{
  const int diameter = argc > 1 ? std::atoi(argv[1]) : 64;
  const int cells = argc > 2 ? std::atoi(argv[2]) : 48;
  std::printf(
    "| mesh | elements | mesh s | transfer s, order 1 | order 2 | of the mesh | copying s "
    "| peak MB | added MB |\n|---|---|---|---|---|---|---|---|---|\n");
  for (const MeshCase& c : { MakeSphereCase(diameter), MakePolycrystalCase(100, cells) })
  {
    for (Elements elements : { Elements::Hexes, Elements::Lattice, Elements::Cells })
    {
      PrintCost(c, elements);
    }
  }
  for (Elements elements : { Elements::Hexes, Elements::Lattice })
  {
    CompareRules(32, elements);
  }
  return 0;
}
