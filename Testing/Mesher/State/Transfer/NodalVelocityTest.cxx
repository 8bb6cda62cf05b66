/// Velocities at mesh points: momentum and kinetic energy are conserved,
/// losses included, on any ranks.
#include "State/Transfer/NodalVelocity.h"

#include "Base/Vector3.h"
#include "RankMeshes.h"
#include "State/SmoothState.h"
#include "State/Transfer/Overlaps.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// State of elements as a function of position only, so that it is the same on any ranks.
struct ElementState
{
  Buffer<double> Mass, Velocity;

  explicit ElementState(const Mesh& mesh, bool isUniform = false) :
    Mass(mesh.ElementIds.size()), Velocity(3 * mesh.ElementIds.size())
  {
    for (std::size_t e = 0; e < this->Mass.size(); ++e)
    {
      Vector3 x{};
      for (int c = 0; c < mesh.Corners; ++c)
      {
        const double* corner = mesh.Points.data() + 3 * mesh.Elements[mesh.Corners * e + c];
        x = x + (1.0 / mesh.Corners) * Vector3{ { corner[0], corner[1], corner[2] } };
      }
      const double densities[3] = { 0.0, 1.0, 1e6 };
      this->Mass[e] = densities[mesh.Material[e] % 3] * (1.0 + 0.3 * std::sin(x[1])) *
        VolumeOfElement(mesh, static_cast<Index>(e));
      const Vector3 u = isUniform
        ? Vector3{ { 3.0, -4.0, 5.0 } }
        : Vector3{ { std::sin(x[0]) + 2.0, x[1] * x[2], mesh.Material[e] - 0.1 * x[0] } };
      std::copy(u.begin(), u.end(), this->Velocity.data() + 3 * e);
    }
  }
};

/// Results of all ranks by id: mass and velocity of points, lost energy of elements.
struct Merged
{
  std::map<Index, std::array<double, 4>> Points;
  std::map<Index, double> Lost;
  /// totals of the elements; Size: sum of |momentum|
  long double Mass = 0.0, Energy = 0.0, Size = 0.0;
  std::array<long double, 3> Momentum{};
  Index Conflicts = 0, Elements = 0;

  void Add(const Mesh& mesh, const ElementState& state, const NodalVelocity& nodal)
  {
    for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
    {
      const double* u = nodal.Velocity.data() + 3 * p;
      const std::array<double, 4> point{ { nodal.Mass[p], u[0], u[1], u[2] } };
      const auto at = this->Points.emplace(mesh.PointIds[p], point);
      this->Conflicts += at.first->second != point;
    }
    for (std::size_t e = 0; e < mesh.ElementIds.size(); ++e)
    {
      this->Conflicts += !this->Lost.emplace(mesh.ElementIds[e], nodal.Lost[e]).second;
      const long double mass = state.Mass[e];
      this->Mass += mass;
      for (int a = 0; a < 3; ++a)
      {
        const long double u = state.Velocity[3 * e + a];
        this->Momentum[a] += mass * u;
        this->Size += mass * std::fabs(u);
        this->Energy += mass * u * u / 2;
      }
    }
    this->Elements += static_cast<Index>(mesh.ElementIds.size());
  }

  void ExpectConserved() const
  {
    long double mass = 0.0, energy = 0.0, lost = 0.0;
    std::array<long double, 3> momentum{};
    for (const auto& item : this->Points)
    {
      const std::array<double, 4>& point = item.second;
      mass += point[0];
      for (int a = 0; a < 3; ++a)
      {
        const long double u = point[1 + a];
        momentum[a] += point[0] * u;
        energy += point[0] * u * u / 2;
      }
    }
    for (const auto& item : this->Lost)
    {
      EXPECT_GE(item.second, 0.0);
      lost += item.second;
    }
    EXPECT_LT(std::fabs(mass - this->Mass), 1e-14L * this->Mass);
    EXPECT_GT(lost, 1e-6L * this->Energy) << "nothing tested";
    EXPECT_LT(std::fabs(energy + lost - this->Energy), 1e-13L * this->Energy);
    for (int a = 0; a < 3; ++a)
    {
      EXPECT_LT(std::fabs(momentum[a] - this->Momentum[a]), 1e-14L * this->Size);
    }
    std::printf("%lld elements: kinetic energy lost %.3Lg %%, energy off by %.1Lg\n",
      static_cast<long long>(this->Elements), 100 * lost / this->Energy,
      std::fabs(energy + lost - this->Energy) / this->Energy);
  }
};

Merged MakeOn(
  const std::vector<IndexBox>& boxes, const MeshCase& c, const MeshOptions& options, MeshMaker make)
{
  const int count = static_cast<int>(boxes.size());
  std::vector<Mesh> meshes(count);
  std::vector<NodalVelocity> nodal(count);
  const GridLayers layers = LayersFor(options.Levels);
  RunOnRanks(count,
    [&](Ranks& ranks)
    {
      const CartesianGrid grid = MakeRankGrid(c.Grid, boxes[ranks.Rank()], layers);
      RankRuntime runtime(ranks);
      MeshReport report;
      Mesh& mesh = meshes[ranks.Rank()];
      mesh = make(grid, CopyToLocal(c.Grid, c.Fractions, grid), options, runtime, report);
      const ElementState state(mesh);
      nodal[ranks.Rank()] = FindNodalVelocity(mesh, grid, state.Mass, state.Velocity, runtime);
    });
  Merged merged;
  for (int rank = 0; rank < count; ++rank)
  {
    merged.Add(meshes[rank], ElementState(meshes[rank]), nodal[rank]);
  }
  EXPECT_EQ(merged.Conflicts, 0);
  return merged;
}

/// Expects the same points, velocities and losses on 1, 2, 3 and 8 ranks,
/// one of them without cells.
void CompareRanks(const MeshCase& c, const MeshOptions& options, MeshMaker make)
{
  const int refinements = options.Levels.Refinements;
  const Merged alone = MakeOn({ c.Grid.Global() }, c, options, make);
  alone.ExpectConserved();
  for (int count : { 2, 3, 8 })
  {
    SCOPED_TRACE(std::to_string(count) + " ranks");
    std::vector<IndexBox> boxes = CutBaseBox(c.Grid, refinements, count);
    boxes.insert(boxes.begin() + 1, IndexBox());
    const Merged merged = MakeOn(boxes, c, options, make);
    EXPECT_EQ(CountDifferences(merged.Points, alone.Points), 0u);
    EXPECT_EQ(CountDifferences(merged.Lost, alone.Lost), 0u);
  }
}

/// Smooth velocity of each cell, and |u|^2 / 2.
class SmoothVelocity : public StateCellValues
{
public:
  explicit SmoothVelocity(const CartesianGrid& grid) : Grid(grid) {}
  void Read(const Index3& cell, int, double* values) const override
  {
    const Vector3 x =
      0.5 * (this->Grid.NodePoint(cell) + this->Grid.NodePoint(CornerOfCell(cell, 7)));
    const Vector3 u{ { 1.0 + std::sin(5.0 * x[0]), x[1] * x[2], 2.0 - x[2] * x[2] } };
    std::copy(u.begin(), u.end(), values);
    values[3] = 0.5 * Dot(u, u);
  }

private:
  const CartesianGrid& Grid;
};

/// Lost kinetic energy of the elements of a ball in n^3 cells of the unit cube, and of the cells.
struct BallLoss
{
  Buffer<double> OfElements;
  double Input = 0.0, Kept = 0.0; ///< kinetic energies of cells and elements

  BallLoss(int n, Elements elements, int order)
  {
    const CartesianGrid grid = MakeUnitCube(n);
    const FractionField fractions =
      FractionsOfShapes(grid, { MakeSphere(1, { { 0.51, 0.52, 0.49 } }, 0.37) });
    const Mesh mesh = MakeMesh(grid, fractions, elements);
    const SmoothVelocity values(grid);
    TransferRequest request{ grid, fractions, values,
      { { StateKind::PerMass, 3, -1 }, { StateKind::PerMass, 1, -1 } } };
    request.Order = order;
    Runtime runtime;
    const TransferredState state = TransferState(mesh, request, runtime);
    this->OfElements = FindLostKineticEnergy(state.Mass, state.Values[0], state.Values[1], runtime);
    this->Input = state.Input[1].back();
    for (std::size_t e = 0; e < state.Mass.size(); ++e)
    {
      const double* u = state.Values[0].data() + 3 * e;
      this->Kept += 0.5 * state.Mass[e] * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    }
  }
  double Sum() const
  {
    return std::accumulate(this->OfElements.begin(), this->OfElements.end(), 0.0);
  }
};

} // namespace

// The difference of two means that are equal but for rounding has either sign.
TEST(NodalVelocity, NoElementGainsKineticEnergyInFirstOrder)
{
  for (Elements elements : { Elements::Hexes, Elements::Lattice })
  {
    const BallLoss loss(24, elements, 1);
    EXPECT_GE(*std::min_element(loss.OfElements.begin(), loss.OfElements.end()), 0.0);
    EXPECT_GT(loss.Sum(), 1e-6 * loss.Input) << "nothing tested";
    EXPECT_NEAR(loss.Kept + loss.Sum(), loss.Input, 1e-13 * loss.Input);
  }
}

TEST(NodalVelocity, SecondOrderGainsLittleKineticEnergyAndCountsIt)
{
  for (Elements elements : { Elements::Hexes, Elements::Lattice })
  {
    const BallLoss loss(24, elements, 2);
    EXPECT_NEAR(loss.Kept + loss.Sum(), loss.Input, 1e-13 * loss.Input);
    EXPECT_LT(std::fabs(loss.Sum()), 5e-4 * loss.Input);
  }
}

TEST(NodalVelocity, KeepsMomentumOnAnyRanks)
{
  MeshOptions options;
  options.MeshVoid = true; // void has no mass
  const MeshCase c = MakeMeshCase("ball of 3 sectors");
  CompareRanks(c, options, MakeHexMesh);
  CompareRanks(c, options, MakeTetMesh);
}

TEST(NodalVelocity, KeepsMomentumOfNoise)
{
  CartesianGrid grid = MakeUnitGrid(6, 5, 7);
  FractionField labels = MakeRandomLabels(grid, 4, 0, 5);
  const MeshCase c{ "noise", std::move(grid), std::move(labels), {}, 0, 0, 0, 0, 0 };
  MeshOptions options;
  CompareRanks(c, options, MakeHexMesh);
  options.Method = TetMethod::Cells;
  CompareRanks(c, options, MakeTetMesh);
}

TEST(NodalVelocity, KeepsMomentumAcrossLevels)
{
  MeshOptions options;
  options.MeshVoid = true;
  options.Levels.Refinements = 1;
  const MeshCase c = MakeMeshCase("sphere 16");
  CompareRanks(c, options, MakeHexMesh);
  CompareRanks(c, options, MakeTetMesh);
}

TEST(NodalVelocity, KeepsMomentumOfTetGensTets)
{
  if (!HasTetGen())
  {
    GTEST_SKIP() << "built without TetGen";
  }
  MeshOptions options;
  options.Method = TetMethod::TetGen; // tetrahedra of TetGen depend on the number of ranks
  const MeshCase c = MakeMeshCase("sphere 16");
  for (int count : { 1, 2, 4 })
  {
    MakeOn(CutBox(c.Grid.Global(), count), c, options, MakeTetMesh).ExpectConserved();
  }
}

TEST(NodalVelocity, OfOneVelocityLosesNothing)
{
  const MeshCase c = MakeMeshCase("sphere 8");
  Runtime runtime;
  MeshReport report;
  const Mesh mesh = MakeHexMesh(c.Grid, c.Fractions, MeshOptions(), runtime, report);
  const ElementState state(mesh, true);
  const NodalVelocity nodal = FindNodalVelocity(mesh, c.Grid, state.Mass, state.Velocity, runtime);
  for (std::size_t p = 0; p < nodal.Mass.size(); ++p)
  {
    EXPECT_NEAR(nodal.Velocity[3 * p], 3.0, 1e-14);
    EXPECT_NEAR(nodal.Velocity[3 * p + 1], -4.0, 1e-14);
    EXPECT_NEAR(nodal.Velocity[3 * p + 2], 5.0, 1e-14);
  }
  for (double lost : nodal.Lost)
  {
    EXPECT_LT(lost, 1e-27);
  }
}

TEST(NodalVelocity, JoinedCellsLoseWhatTheyMoveApart)
{
  Buffer<double> mass(2), velocity(6, 0.0), kinetic(2);
  mass[0] = 3.0; // mass 1 at rest joined with mass 2 of velocity 3
  velocity[0] = 2.0;
  kinetic[0] = 2.0 * 4.5 / 3.0;
  mass[1] = 0.0;
  kinetic[1] = 1.0;
  Runtime runtime;
  const Buffer<double> lost = FindLostKineticEnergy(mass, velocity, kinetic, runtime);
  EXPECT_DOUBLE_EQ(lost[0], 3.0); // half the reduced mass 2/3, times 9
  EXPECT_EQ(lost[1], 0.0);
}
