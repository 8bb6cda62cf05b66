#include "Volumes/IslandLevels.h"

#include "Volumes/MatchFragments.h"

namespace vfm
{
namespace
{

constexpr Index LargestCoarsest = 500; // groups that are factored
constexpr int Matchings = 3;           // per level; each halves the number of groups
constexpr double Damping = 0.75;       // of corrections by the diagonal, which overshoot

Index CountAll(const FragmentShare& share)
{
  std::vector<std::int64_t> count{ std::count(share.IsMine.begin(), share.IsMine.end(), 1) };
  share.Group->Sum(count);
  return count[0];
}

/// Finds the groups of the next level and its values.
IslandLevel MakeCoarser(IslandLevel& level, IslandValues& values)
{
  std::vector<Index> groups = MatchFragments(level, values);
  IslandLevel next = MakeNextLevel(level, groups);
  IslandValues nextValues = SumValues(level, values, next);
  for (int matching = 1; matching < Matchings; ++matching)
  {
    const std::vector<Index> joined = MatchFragments(next, nextValues);
    for (std::size_t f = 1; f < groups.size(); ++f)
    {
      groups[f] = joined[level.GroupOf[f]];
    }
    next = MakeNextLevel(level, groups);
    nextValues = SumValues(level, values, next);
  }
  values = std::move(nextValues);
  return next;
}

/// Corrects x by the damped residuals over the diagonal.
void CorrectEach(const IslandLevel& level, const IslandValues& values,
  const std::vector<double>& right, std::vector<double>& x)
{
  const std::vector<double> product = Multiply(level, values, x);
  for (std::size_t f = 1; f < x.size(); ++f)
  {
    x[f] += Damping * (right[f] - product[f]) / values.Diagonal[f];
  }
}

std::vector<double> Times(double factor, std::vector<double> values)
{
  for (double& value : values)
  {
    value *= factor;
  }
  return values;
}

} // namespace

IslandLevels::IslandLevels(IslandLevel first, const std::vector<double>& areas)
{
  IslandValues values = MakeValues(first, areas);
  this->Levels.push_back(std::move(first));
  for (Index count = CountAll(this->First().Share), last = 2 * count;
       count > LargestCoarsest && count < last;)
  {
    IslandLevel next = MakeCoarser(this->Levels.back(), values);
    last = count;
    count = CountAll(next.Share);
    this->Levels.push_back(std::move(next));
  }
  this->Coarsest = CoarsestLevel(this->Levels.back());
}

IslandLevels::System IslandLevels::MakeSystem(std::vector<double> areas) const
{
  System system;
  system.Values.push_back(MakeValues(this->First(), std::move(areas)));
  for (std::size_t l = 1; l < this->Levels.size(); ++l)
  {
    system.Values.push_back(SumValues(this->Levels[l - 1], system.Values.back(), this->Levels[l]));
  }
  system.Factors = this->Coarsest.Factor(this->Levels.back(), system.Values.back());
  return system;
}

std::vector<double> IslandLevels::Cycle(
  const System& system, std::size_t level, const std::vector<double>& right) const
{
  if (level + 1 == this->Levels.size())
  {
    return this->Coarsest.Solve(*system.Factors, right);
  }
  const IslandLevel &own = this->Levels[level], &next = this->Levels[level + 1];
  const IslandValues& values = system.Values[level];
  std::vector<double> x(right.size(), 0.0), rest(right);
  for (std::size_t f = 1; f < x.size(); ++f)
  {
    x[f] = Damping * right[f] / values.Diagonal[f];
  }
  AddTimes(-1.0, Multiply(own, values, x), rest);
  const std::vector<double> ofGroups = SumByGroup(own, next, rest);
  const bool isLast = level + 2 == this->Levels.size();
  const std::vector<double> shifts = isLast ? this->Cycle(system, level + 1, ofGroups)
                                            : this->CycleTwice(system, level + 1, ofGroups);
  for (std::size_t f = 1; f < x.size(); ++f)
  {
    x[f] += shifts[own.GroupOf[f]];
  }
  CorrectEach(own, values, right, x);
  return x;
}

/// Takes two steps of conjugate gradients.
std::vector<double> IslandLevels::CycleTwice(
  const System& system, std::size_t level, const std::vector<double>& right) const
{
  const IslandLevel& own = this->Levels[level];
  const IslandValues& values = system.Values[level];
  const std::vector<double> first = this->Cycle(system, level, right),
                            firstProduct = Multiply(own, values, first);
  const double square = Dot(own.Share, first, firstProduct);
  if (!(square > 0.0))
  {
    return first;
  }
  const double step = Dot(own.Share, first, right) / square;
  std::vector<double> rest(right);
  AddTimes(-step, firstProduct, rest);
  const std::vector<double> second = this->Cycle(system, level, rest),
                            secondProduct = Multiply(own, values, second);
  const double common = Dot(own.Share, second, firstProduct) / square;
  const double rise = Dot(own.Share, second, secondProduct) - common * common * square;
  std::vector<double> x = Times(step, first);
  if (rise > 0.0)
  {
    const double secondStep = Dot(own.Share, second, rest) / rise;
    AddTimes(secondStep, second, x);
    AddTimes(-secondStep * common, first, x);
  }
  return x;
}

} // namespace vfm
