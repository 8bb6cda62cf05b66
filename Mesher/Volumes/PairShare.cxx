#include "Volumes/PairShare.h"

namespace vfm
{

PairShare::PairShare(const FragmentShare& share, std::vector<FragmentPair> pairs) :
  ThePairs(std::move(pairs)), AreMine(this->ThePairs.size(), 1)
{
  std::vector<std::array<Index, 2>> keys;
  for (std::size_t p = 0; p < this->ThePairs.size(); ++p)
  {
    const auto& [a, b] = this->ThePairs[p];
    if ((a == 0 || share.IsShared[a]) && share.IsShared[b])
    {
      this->Shared.push_back(static_cast<int>(p));
      keys.push_back({ { share.Ids[a], share.Ids[b] } });
    }
  }
  this->Ways = KeyMerge<std::array<Index, 2>>(std::move(keys), *share.Group);
  std::vector<int> lowest(this->Shared.size(), share.Group->Rank());
  this->Ways.Merge(lowest, 1, [](int& a, int b) { a = std::min(a, b); });
  for (std::size_t s = 0; s < lowest.size(); ++s)
  {
    this->AreMine[this->Shared[s]] = lowest[s] == share.Group->Rank();
  }
}

void PairShare::Sum(std::vector<ExactSum>& sums) const
{
  std::vector<ExactSum> shared;
  shared.reserve(this->Shared.size());
  for (int pair : this->Shared)
  {
    shared.push_back(sums[pair]);
  }
  this->Ways.Merge(shared, 1, [](ExactSum& a, const ExactSum& b) { a.Add(b); });
  for (std::size_t s = 0; s < shared.size(); ++s)
  {
    sums[this->Shared[s]] = shared[s];
  }
}

} // namespace vfm
