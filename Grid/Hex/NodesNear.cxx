#include "Hex/NodesNear.h"

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
  for (Index node : mixed)
  {
    const Index3 p = finest.Position(node);
    const Index at =
      IndexInBox(this->Box, { { p[0] >> halvings, p[1] >> halvings, p[2] >> halvings } });
    this->Runs.push_back({ at, at + 1 });
  }
  this->Spread(1, rings);
  this->Spread(this->Box.Size(0), rings);
  this->Spread(this->Box.Size(0) * this->Box.Size(1), rings);
}

/// Extends the runs by `rings` nodes on both sides along an axis, and joins runs that touch.
void NodesNear::Spread(Index stride, Index rings)
{
  std::vector<Run> spread;
  for (const Run& run : this->Runs)
  {
    for (Index step = -rings * stride; step <= rings * stride; step += stride)
    {
      spread.push_back({ run.Begin + step, run.End + step });
    }
  }
  std::sort(spread.begin(), spread.end());
  this->Runs.clear();
  for (const Run& run : spread)
  {
    if (!this->Runs.empty() && run.Begin <= this->Runs.back().End)
    {
      this->Runs.back().End = std::max(this->Runs.back().End, run.End);
      continue;
    }
    this->Runs.push_back(run);
  }
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
