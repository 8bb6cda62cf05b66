#include "Elements/Hex/NearCells.h"

namespace vfm
{

void NearCells::AddCells(Index j, Index k, Runs& runs) const
{
  const IndexBox box = this->Grid.HexBox(), &all = this->Grid.Global();
  const auto add = [&](Index begin, Index end)
  {
    begin = std::max(begin, box.Lower[0]);
    end = std::min(end, box.Upper[0]);
    if (begin < end)
    {
      runs.push_back({ { begin, end } });
    }
  };
  const bool isOnSide =
    j == all.Lower[1] || j == all.Upper[1] - 1 || k == all.Lower[2] || k == all.Upper[2] - 1;
  if (isOnSide)
  {
    add(box.Lower[0], box.Upper[0]);
    return;
  }
  add(all.Lower[0], all.Lower[0] + 1);
  add(all.Upper[0] - 1, all.Upper[0]);
  for (int r = 0; r < 4; ++r)
  {
    this->Nodes.ForRuns(
      j + (r & 1), k + (r >> 1), [&](Index begin, Index end) { add(begin - 1, end); });
  }
}

CellRuns ListFarCells(const CartesianGrid& grid, const NearCells& near, const Fragments& fragments)
{
  const IndexBox& owned = grid.Owned();
  const std::vector<int>& materials = fragments.MaterialsOfFragments();
  CellRuns far;
  ForRows(owned,
    [&](Index j, Index k)
    {
      std::vector<std::array<Index, 2>> gaps; // between the near cells
      Index last = owned.Lower[0];
      near.ForCells(j, k,
        [&](Index begin, Index end)
        {
          gaps.push_back({ { last, begin } });
          last = end;
        });
      gaps.push_back({ { last, owned.Upper[0] } });
      auto gap = gaps.begin();
      fragments.ForRuns(j, k,
        [&](Index begin, Index end, int fragment)
        {
          for (; gap != gaps.end() && (*gap)[1] <= begin; ++gap)
          {
          }
          for (auto at = gap; fragment > 0 && at != gaps.end() && (*at)[0] < end; ++at)
          {
            const Index first = std::max(begin, (*at)[0]), stop = std::min(end, (*at)[1]);
            if (first < stop)
            {
              far.Runs.push_back(
                { { { first, j, k } }, stop - first, materials[fragment], fragment });
            }
          }
        });
    });
  return far;
}

} // namespace vfm
