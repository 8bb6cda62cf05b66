#include "Levels/LevelSetup.h"

#include "Input/NodeCoordinates.h"

#include <cmath>

namespace vfm
{
namespace
{

constexpr int LevelsOfCoarsening = 3; // default; MaximumLevel can request more

/// Returns whether the nodes that coarsening removes are midpoints of their neighbours.
bool AreHalves(const std::vector<double>& x, Index step)
{
  for (std::size_t i = step; i + step < x.size(); i += 2 * step)
  {
    const double middle = x[i - step] + 0.5 * (x[i + step] - x[i - step]);
    if (std::fabs(x[i] - middle) > MatchTolerance * (x[i + 1] - x[i]))
    {
      return false;
    }
  }
  return true;
}

/// Returns how often pairs of cells along an axis can be joined, up to most times.
int CountJoins(const std::vector<double>& x, int most)
{
  const Index cells = static_cast<Index>(x.size()) - 1;
  int joins = 0;
  while (joins < most && cells % (Index(2) << joins) == 0 && AreHalves(x, Index(1) << joins))
  {
    ++joins;
  }
  return joins;
}

/// Coarsens the base as far as the numbers and widths of cells allow.
void Coarsen(const std::array<std::vector<double>, 3>& coordinates, int requested, int alignment,
  LevelSetup& setup)
{
  const int most = requested - setup.Finest; // levels below 0; negative: the base is finer than 0
  int joins = std::min(most, alignment);
  std::string limit = joins < most ? "the boxes of the ranks, or the periods, do" : "";
  for (int axis = 0; axis < 3 && joins > 0; ++axis)
  {
    const int own = CountJoins(coordinates[axis], joins);
    if (own < joins)
    {
      joins = own;
      limit = std::to_string(coordinates[axis].size() - 1) + " cells along " + AxisNames[axis] +
        " (their number, or widths that vary) do";
    }
  }
  setup.Base = -joins;
  if (joins < most)
  {
    setup.Warning = "Coarsening makes " + std::to_string(setup.Finest - setup.Base) +
      " levels above the coarsest, not " + std::to_string(requested) + ": " + limit +
      " not allow more. A number of cells that is a multiple of a higher power of 2 does.";
  }
}

} // namespace

int CountAlignedLevels(const std::vector<IndexBox>& boxes, Ranks& ranks)
{
  int levels = AnyLevel;
  for (const IndexBox& box : boxes)
  {
    for (int a = 0; a < 3; ++a)
    {
      while (levels > 0 && ((box.Lower[a] | box.Upper[a]) & ((Index(1) << levels) - 1)) != 0)
      {
        --levels;
      }
    }
  }
  return static_cast<int>(-ranks.Max(-levels));
}

LevelSetup DecideLevels(RefinementMode how, int maximumLevel,
  const std::array<std::vector<double>, 3>& coordinates, int inputFinest, int alignment,
  int requestedFinest)
{
  LevelSetup setup;
  switch (how)
  {
    case RefinementMode::Off:
      break;
    case RefinementMode::InputLevels:
      setup.Finest = maximumLevel < 0 ? inputFinest : std::min(maximumLevel, inputFinest);
      setup.TakesInputLevels = true;
      break;
    case RefinementMode::Automatic:
      setup.Finest =
        maximumLevel < 0 ? std::max({ inputFinest, requestedFinest, 1 }) : maximumLevel;
      setup.TakesInputLevels = true;
      break;
    case RefinementMode::Uniform:
      setup.Finest = maximumLevel < 0 ? std::max(inputFinest, 1) : maximumLevel;
      setup.IsUniform = true;
      break;
    case RefinementMode::Coarsen:
      setup.Finest = inputFinest;
      Coarsen(coordinates,
        maximumLevel < 0 ? std::max(LevelsOfCoarsening, inputFinest) : maximumLevel, alignment,
        setup);
      if (maximumLevel < 0 && setup.Base < setup.Finest)
      {
        setup.Warning.clear(); // as many as the sizes allow
      }
      break;
  }
  return setup;
}

} // namespace vfm
