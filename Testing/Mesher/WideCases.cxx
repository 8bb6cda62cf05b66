#include "WideCases.h"

#include "Input/PlainArrays.h"
#include "State/StateCases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <mutex>

namespace vfm
{
namespace testing
{

std::vector<int> MakeGrains(const Index3& cells)
{
  const double seeds[4][3] = { { 0.2, 0.3, 0.2 }, { 0.8, 0.4, 0.3 }, { 0.4, 0.8, 0.7 },
    { 0.7, 0.2, 0.9 } };
  std::vector<int> labels;
  ForCells({ {}, cells },
    [&](const Index3& cell)
    {
      int nearest = 0;
      double least = 10.0;
      for (int s = 0; s < 4; ++s)
      {
        double squares = 0.0;
        for (int a = 0; a < 3; ++a)
        {
          const double x = (0.5 + static_cast<double>(cell[a])) / static_cast<double>(cells[a]);
          squares += std::pow(x - seeds[s][a], 2);
        }
        nearest = squares < least ? (s + 1) % 4 : nearest;
        least = std::min(least, squares);
      }
      labels.push_back(nearest);
    });
  return labels;
}

MesherInput WithState(bool isConserved, MesherInput input)
{
  for (InputBlocks& level : input.Levels.Levels)
  {
    for (InputBlock& block : level.Blocks)
    {
      std::array<std::vector<double>, 6> values;
      ForCells(block.Box,
        [&](const Index3& cell)
        {
          const double x = level.Coordinates[0][cell[0]], y = level.Coordinates[1][cell[1]],
                       z = level.Coordinates[2][cell[2]];
          const double state[6] = { 2.0 + std::sin(5.0 * x + y), 1.0 + y - z, std::cos(3.0 * z),
            x * y, 3.0 + x + std::sin(7.0 * z), 0.1 + x * x };
          for (std::size_t c = 0; c < values.size(); ++c)
          {
            values[c].push_back(state[c]);
          }
        });
      auto arrays = std::make_shared<PlainArrays>(block.Arrays);
      const char* const names[] = { "density", "u_x", "u_y", "u_z", "energy", "heat" };
      for (std::size_t c = 0; c < values.size(); ++c)
      {
        arrays->Store(names[c], ValueType::Double, std::move(values[c]));
      }
      block.Arrays = arrays;
    }
  }
  StateChoice& state = input.Arrays.State;
  state.Arrays = { "density", "u_x", "u_y", "u_z", "energy", "heat" };
  state.IsConserved = isConserved;
  if (isConserved)
  {
    state.Densities = { "density" };
    state.Velocity = "u_x";
    state.Energy = "energy";
    state.Kinds = { "heat=extensive" };
  }
  return input;
}

MesherInput MakeGrainsInput(Ranks& ranks)
{
  return MakeLabelInput(TheGrid, MakeGrains(GridSize), ranks);
}

MesherInput MakeLevels(Ranks& ranks)
{
  return MakeLevelInput(TheGrid,
    { { { { 2, 3, 2 } }, { { 9, 8, 11 } } }, { { { 12, 3, 14 } }, { { 20, 15, 24 } } } }, ranks);
}

MeshById MeshOnRanks(
  int count, const MesherOptions& options, const std::function<MesherInput(Ranks&)>& makeInput)
{
  MeshById joined;
  std::mutex mutex;
  RunOnRanks(count,
    [&](ThreadRanks& ranks)
    {
      RankRuntime runtime(ranks);
      const MesherResult result = RunMesher(makeInput(ranks), options, runtime);
      const std::lock_guard<std::mutex> lock(mutex);
      joined.Add(result);
    });
  return joined;
}

void ExpectSameOnRanks(
  const MesherOptions& options, const std::function<MesherInput(Ranks&)>& makeInput)
{
  const MeshById alone = MeshOnRanks(1, options, makeInput);
  EXPECT_GT(alone.Elements.size(), 50u);
  for (int count : { 2, 3, 8 })
  {
    const MeshById joined = MeshOnRanks(count, options, makeInput);
    EXPECT_TRUE(joined.Points == alone.Points) << count;
    EXPECT_TRUE(joined.Elements == alone.Elements) << count;
  }
}

void ExpectConserved(
  const MesherOptions& options, const std::function<MesherInput(Ranks&)>& makeInput)
{
  Runtime serial;
  const std::array<double, 6> expected =
    SumUp(RunMesher(makeInput(serial.Group()), MesherOptions(), serial).State.Balance.Input, {});
  const StateBalance balance = RunMesher(makeInput(serial.Group()), options, serial).State.Balance;
  const std::array<double, 6> input = SumUp(balance.Input, {});
  const std::array<double, 6> mesh = SumUp(balance.Mesh, balance.Unmeshed);
  for (int s = 0; s < 6; ++s)
  {
    EXPECT_NEAR(input[s] / expected[s], 1.0, 1e-13) << s;
    EXPECT_TRUE(s == 5 || std::fabs(mesh[s] - expected[s]) < 1e-13 * expected[0]) << s;
  }
}

} // namespace testing
} // namespace vfm
