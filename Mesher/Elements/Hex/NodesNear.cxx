#include "Elements/Hex/NodesNear.h"

namespace vfm
{

NodesNear::NodesNear(
  const CartesianGrid& finest, const std::vector<Index>& mixed, int halvings, Index rings)
{
  for (int a = 0; a < 3; ++a)
  {
    this->Box.Lower[a] = (finest.Local().Lower[a] >> halvings) - rings;
    this->Box.Upper[a] = (finest.Local().Upper[a] >> halvings) + 1 + rings;
  }
  std::vector<Run> runs;
  for (Index node : mixed)
  {
    const Index3 p = finest.Position(node);
    const Index at =
      IndexInBox(this->Box, { { p[0] >> halvings, p[1] >> halvings, p[2] >> halvings } });
    AddRun({ at - rings, at + rings + 1 }, runs);
  }
  if (!std::is_sorted(runs.begin(), runs.end()))
  {
    std::sort(runs.begin(), runs.end());
  }
  for (const Run& run : runs)
  {
    AddRun(run, this->Runs);
  }
  this->Spread(this->Box.Size(0), rings);
  this->Spread(this->Box.Size(0) * this->Box.Size(1), rings);
}

/// Appends a run, or extends the last one if both touch and are in order.
void NodesNear::AddRun(const Run& run, std::vector<Run>& runs)
{
  if (!runs.empty() && runs.back().Begin <= run.Begin && run.Begin <= runs.back().End)
  {
    runs.back().End = std::max(runs.back().End, run.End);
    return;
  }
  runs.push_back(run);
}

/// Adds copies of the runs, shifted by up to `rings` nodes on both sides along an axis.
void NodesNear::Spread(Index stride, Index rings)
{
  std::vector<Run> shifted(this->Runs), spread, merged;
  for (Index step = -rings; step <= rings; ++step)
  {
    std::transform(this->Runs.begin(), this->Runs.end(), shifted.begin(),
      [&](const Run& run) {
        return Run{ run.Begin + step * stride, run.End + step * stride };
      });
    merged.resize(spread.size() + shifted.size());
    std::merge(spread.begin(), spread.end(), shifted.begin(), shifted.end(), merged.begin());
    spread.clear();
    for (const Run& run : merged)
    {
      AddRun(run, spread);
    }
  }
  this->Runs = std::move(spread);
}

bool NodesNear::Has(const Index3& node) const
{
  if (!this->Box.Contains(node))
  {
    return false;
  }
  const Index at = IndexInBox(this->Box, node);
  const auto after = std::upper_bound(this->Runs.begin(), this->Runs.end(), at,
    [](Index i, const Run& run) { return i < run.Begin; });
  return after != this->Runs.begin() && at < std::prev(after)->End;
}

} // namespace vfm
