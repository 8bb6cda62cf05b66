#include "Volumes/ThinFragments.h"

namespace vfm
{

std::vector<unsigned char> FindThinFragments(const CartesianGrid& grid, const Mesh& mesh,
  const std::vector<Index>& thin, Index fragments, Ranks& ranks)
{
  if (!ranks.Any(!thin.empty()))
  {
    return {};
  }
  std::vector<std::int64_t> counts(fragments + 1, 0);
  for (std::size_t e = 0; e < mesh.ElementIds.size() && !thin.empty(); ++e)
  {
    const Index cell = grid.Linear(CellOfElement(grid, mesh, mesh.ElementIds[e]));
    counts[mesh.Fragment[e]] += std::binary_search(thin.begin(), thin.end(), cell);
  }
  ranks.Sum(counts);
  std::vector<unsigned char> isThin(counts.size());
  std::transform(counts.begin(), counts.end(), isThin.begin(), [](auto n) { return n > 0; });
  return isThin;
}

} // namespace vfm
