#include "Volumes/ThinFragments.h"

namespace vfm
{

std::vector<unsigned char> FindThinFragments(const CartesianGrid& grid, const Mesh& mesh,
  const std::vector<Index>& thin, const FragmentShare& share)
{
  if (!share.Group->Any(!thin.empty()))
  {
    return {};
  }
  std::vector<unsigned char> isThin(share.Size(), 0);
  for (std::size_t e = 0; e < mesh.ElementIds.size() && !thin.empty(); ++e)
  {
    const Index cell = grid.Linear(CellOfElement(grid, mesh, mesh.ElementIds[e]));
    isThin[mesh.Fragment[e]] |= std::binary_search(thin.begin(), thin.end(), cell);
  }
  share.Unite(isThin);
  isThin[0] = share.Group->Any(isThin[0] != 0);
  return isThin;
}

} // namespace vfm
