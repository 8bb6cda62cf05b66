/// State on meshes of periodic domains: sums and momentum at points are conserved, values come from
/// cells across sides, and ranks do not matter.
#include "Input/PlainArrays.h"
#include "LabelInput.h"
#include "RankFields.h"
#include "Report/ElementMoments.h"
#include "State/StateCases.h"
#include "State/ViewMesh.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <mutex>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr Index3 Cells{ { 10, 8, 12 } };
constexpr double Origin = 0.1, Width = 0.25;
const double Circle = 2.0 * std::acos(-1.0);

struct Method
{
  const char* Name;
  ElementKind Elements;
  Sides Kind;
  bool HasLevels = false;
  TetMethod Tets = TetMethod::Lattice;
};

const Method Methods[] = { { "FlatHexes", ElementKind::Hexes, Sides::Flat },
  { "FreeHexes", ElementKind::Hexes, Sides::Free },
  { "JoinedHexes", ElementKind::Hexes, Sides::Joined },
  { "FlatLattice", ElementKind::Tets, Sides::Flat },
  { "JoinedLattice", ElementKind::Tets, Sides::Joined },
  { "JoinedCells", ElementKind::Tets, Sides::Joined, false, TetMethod::Cells },
  { "FlatHexesOfLevels", ElementKind::Hexes, Sides::Flat, true },
  { "FreeHexesOfLevels", ElementKind::Hexes, Sides::Free, true },
  { "FlatLatticeOfLevels", ElementKind::Tets, Sides::Flat, true } };

/// Density, velocity, specific energy.
using State = std::array<double, 5>;

/// Returns the state at a place, in periods from the origin.
State StateAt(const Vector3& x)
{
  const auto wave = [&](int a, int b, double phase)
  { return std::sin(Circle * x[a] + phase) * std::cos(Circle * x[b]); };
  return { { 2.0 + wave(0, 1, 0.3), 1.0 + wave(1, 2, 0.1), wave(2, 0, 0.5), wave(0, 2, 0.9) - 2.0,
    5.0 + wave(2, 1, 0.7) } };
}

/// Adds the state of each cell.
/// @param shift cells of level 0 by which the state is moved
void AddState(const Index3& shift, bool isConserved, MesherInput& input)
{
  for (InputBlocks& level : input.Levels.Levels)
  {
    for (InputBlock& block : level.Blocks)
    {
      std::array<std::vector<double>, 5> values;
      ForCells(block.Box,
        [&](const Index3& cell)
        {
          Vector3 x;
          for (int a = 0; a < 3; ++a)
          {
            const double middle =
              0.5 * (level.Coordinates[a][cell[a]] + level.Coordinates[a][cell[a] + 1]) - Origin;
            x[a] = middle / (Width * static_cast<double>(Cells[a])) -
              static_cast<double>(shift[a]) / static_cast<double>(Cells[a]);
          }
          const State state = StateAt(x);
          for (std::size_t c = 0; c < state.size(); ++c)
          {
            values[c].push_back(state[c]);
          }
        });
      auto arrays = std::make_shared<PlainArrays>(block.Arrays);
      const char* const names[] = { "density", "u_x", "u_y", "u_z", "energy" };
      for (std::size_t c = 0; c < values.size(); ++c)
      {
        arrays->Store(names[c], ValueType::Double, std::move(values[c]));
      }
      block.Arrays = arrays;
    }
  }
  input.Arrays.State.Arrays = { "density", "u_x", "u_y", "u_z", "energy" };
  input.Arrays.State.IsConserved = isConserved;
  if (isConserved)
  {
    input.Arrays.State.Densities = { "density" };
    input.Arrays.State.Velocity = "u_x";
    input.Arrays.State.Energy = "energy";
  }
}

/// Returns a ball across the sides, moved by some cells, and its state.
MesherInput MakeBall(const Index3& shift, bool isConserved, Ranks& ranks)
{
  std::vector<int> labels;
  ForCells({ {}, Cells },
    [&](const Index3& cell)
    {
      double squares = 0.0;
      for (int a = 0; a < 3; ++a)
      {
        const Index n = Cells[a], away = ((cell[a] - shift[a]) % n + n) % n;
        squares += std::pow(static_cast<double>(std::min(away, n - away)) + 0.1 * a, 2);
      }
      labels.push_back(squares < 10.0 ? 1 : 2);
    });
  MesherInput input = MakeLabelInput({ Cells, Origin, Width }, labels, ranks);
  AddState(shift, isConserved, input);
  return input;
}

MesherInput MakeInput(const Method& method, bool isConserved, Ranks& ranks)
{
  if (!method.HasLevels)
  {
    return MakeBall({ { 0, 0, 0 } }, isConserved, ranks);
  }
  MesherInput input = MakeLevelInput({ Cells, Origin, Width },
    { { { { 0, 0, 0 } }, { { 2, 3, 2 } } }, { { { 8, 3, 1 } }, { { 10, 5, 3 } } } }, ranks);
  AddState({ { 0, 0, 0 } }, isConserved, input);
  return input;
}

MesherOptions OptionsOf(const Method& method)
{
  MesherOptions options;
  options.Elements = method.Elements;
  options.Method = method.Tets;
  options.Periodic = 7;
  options.PeriodicSides = method.Kind;
  options.MeshVoid = method.HasLevels;
  options.NodalVelocity = true;
  return options;
}

const double* ValuesOf(const TransferredArray& array)
{
  return reinterpret_cast<const double*>(array.Values.data());
}

const TransferredArray& FindArray(const MesherResult& result, const std::string& name)
{
  return *std::find_if(result.State.Arrays.begin(), result.State.Arrays.end(),
    [&](const TransferredArray& array) { return array.Name == name; });
}

/// The elements and points of a mesh with their state, by id.
struct StateById
{
  std::map<Index, std::vector<double>> Elements;
  std::map<Index, Vector3> Velocities;

  void Add(const MesherResult& result)
  {
    const Mesh& mesh = result.TheMesh;
    for (std::size_t e = 0; e < mesh.ElementIds.size(); ++e)
    {
      for (const TransferredArray& array : result.State.Arrays)
      {
        const double* tuple = ValuesOf(array) + array.Components * e;
        std::vector<double>& values = this->Elements[mesh.ElementIds[e]];
        values.insert(values.end(), tuple, tuple + array.Components);
      }
    }
    for (std::size_t p = 0; result.State.NodalVelocity && p < mesh.PointIds.size(); ++p)
    {
      std::copy_n(ValuesOf(*result.State.NodalVelocity) + 3 * p, 3,
        this->Velocities[mesh.PointIds[p]].begin());
    }
  }
};

class PeriodicState : public ::testing::TestWithParam<Method>
{
};

} // namespace

TEST_P(PeriodicState, SumsAreConserved)
{
  Runtime serial;
  const MesherResult result = RunMesher(
    MakeInput(this->GetParam(), true, serial.Group()), OptionsOf(this->GetParam()), serial);
  const StateBalance& balance = result.State.Balance;
  const std::array<double, 6> input = SumUp(balance.Input, {});
  const std::array<double, 6> mesh = SumUp(balance.Mesh, balance.Unmeshed);
  EXPECT_GT(input[0], 10.0);
  for (int s = 0; s < 5; ++s)
  {
    EXPECT_NEAR(mesh[s] / input[0], input[s] / input[0], 1e-13) << s;
  }
}

/// The momentum of the points is that of the elements, and their kinetic energy is less by what is
/// reported.
TEST_P(PeriodicState, PointsHaveTheMomentumOfElements)
{
  Runtime serial;
  const MesherResult result = RunMesher(
    MakeInput(this->GetParam(), true, serial.Group()), OptionsOf(this->GetParam()), serial);
  const Mesh& mesh = result.TheMesh;
  const std::vector<ElementMoments> moments =
    FindElementMoments(ViewMesh(mesh, result.State, result.Fields));
  std::map<Index, std::pair<double, Vector3>> points; // mass and velocity by partner
  const double* velocity = ValuesOf(*result.State.NodalVelocity);
  for (std::size_t i = 0; i < mesh.Elements.size(); ++i)
  {
    const std::size_t e = i / mesh.Corners;
    const Index p = mesh.Elements[i];
    const Vector3 u{ { velocity[3 * p], velocity[3 * p + 1], velocity[3 * p + 2] } };
    const Index id = mesh.PeriodicPartner.empty() ? mesh.PointIds[p] : mesh.PeriodicPartner[p];
    auto& point = points.emplace(id, std::pair(0.0, u)).first->second;
    point.first += ValuesOf(FindArray(result, "density"))[e] * moments[e].Volume / mesh.Corners;
    EXPECT_EQ(point.second, u); // of all copies
  }
  Vector3 momentum{};
  double kinetic = 0.0;
  for (const auto& [id, point] : points)
  {
    momentum = momentum + point.first * point.second;
    kinetic += 0.5 * point.first * Dot(point.second, point.second);
  }
  double expected = 0.0, mass = 0.0;
  Vector3 given{};
  for (const StateSums& sums : result.State.Balance.Mesh)
  {
    expected += sums.Kinetic - sums.LostToNodes;
    given = given + sums.Momentum;
    mass += sums.Mass;
  }
  EXPECT_NEAR(kinetic / mass, expected / mass, 1e-12);
  EXPECT_LT(Norm(momentum - given) / mass, 1e-12);
}

TEST_P(PeriodicState, RanksGiveTheSameState)
{
  for (bool isConserved : { true, false })
  {
    StateById alone;
    for (int count : { 1, 2, 3 })
    {
      StateById joined;
      std::mutex mutex;
      RunOnRanks(count,
        [&](ThreadRanks& ranks)
        {
          RankRuntime runtime(ranks);
          const MesherResult result = RunMesher(
            MakeInput(this->GetParam(), isConserved, ranks), OptionsOf(this->GetParam()), runtime);
          const std::lock_guard<std::mutex> lock(mutex);
          joined.Add(result);
        });
      alone = count == 1 ? joined : alone;
      EXPECT_TRUE(joined.Elements == alone.Elements) << count;
      EXPECT_TRUE(joined.Velocities == alone.Velocities) << count;
    }
  }
}

TEST_P(PeriodicState, ThreadsGiveTheSameMeshAndState)
{
  Runtime serial;
  ThreadedRuntime threaded;
  StateById states[2];
  std::vector<double> points[2];
  int at = 0;
  for (Runtime* runtime : { &serial, static_cast<Runtime*>(&threaded) })
  {
    const MesherResult result = RunMesher(
      MakeInput(this->GetParam(), true, runtime->Group()), OptionsOf(this->GetParam()), *runtime);
    states[at].Add(result);
    points[at].assign(result.TheMesh.Points.begin(), result.TheMesh.Points.end());
    ++at;
  }
  EXPECT_TRUE(points[0] == points[1]);
  EXPECT_TRUE(states[0].Elements == states[1].Elements);
  EXPECT_TRUE(states[0].Velocities == states[1].Velocities);
}

INSTANTIATE_TEST_SUITE_P(Methods, PeriodicState, ::testing::ValuesIn(Methods),
  [](const auto& info) { return std::string(info.param.Name); });

/// Without smoothing, the mesh of a field that is moved by whole cells is the moved mesh: its state
/// is the same only if cells across the sides count.
TEST(PeriodicState, MovedFieldGivesTheSameState)
{
  Runtime serial;
  using Place = std::array<std::int64_t, 4>; // centroid in the period, and material
  for (bool isConserved : { true, false })
  {
    std::map<Place, std::vector<double>> first;
    for (const Index3& shift :
      { Index3{ { 0, 0, 0 } }, Index3{ { 5, 4, 6 } }, Index3{ { 3, 7, 1 } } })
    {
      MesherOptions options = OptionsOf({ "", ElementKind::Hexes, Sides::Free });
      options.Smoothing = SmoothingMethod::Off;
      const MesherResult result =
        RunMesher(MakeBall(shift, isConserved, serial.Group()), options, serial);
      StateById state;
      state.Add(result);
      const std::vector<ElementMoments> moments =
        FindElementMoments(ViewMesh(result.TheMesh, result.State, result.Fields));
      std::map<Place, std::vector<double>> moved;
      for (std::size_t e = 0; e < moments.size(); ++e)
      {
        Place place{};
        for (int a = 0; a < 3; ++a)
        {
          const double n = static_cast<double>(Cells[a]);
          const double x = (moments[e].Moment[a] / moments[e].Volume - Origin) / Width -
            static_cast<double>(shift[a]) + 0.123;
          place[a] = std::llround(1e6 * (x - n * std::floor(x / n)));
        }
        place[3] = result.TheMesh.Material[e];
        moved[place] = state.Elements.at(result.TheMesh.ElementIds[e]);
      }
      EXPECT_EQ(moved.size(), moments.size());
      first = first.empty() ? moved : first;
      ASSERT_EQ(moved.size(), first.size());
      double largest = 0.0;
      for (const auto& [place, values] : moved)
      {
        ASSERT_EQ(first.count(place), 1u);
        for (std::size_t c = 0; c < values.size(); ++c)
        {
          largest = std::max(largest, std::fabs(values[c] - first.at(place)[c]));
        }
      }
      EXPECT_LT(largest, isConserved ? 1e-11 : 1e-14);
    }
  }
}
