#include "Volumes/PairShare.h"

namespace vfm
{

PairShare::PairShare(
  const FragmentShare& share, std::vector<FragmentPair> pairs, const std::vector<int>& fragments) :
  ThePairs(std::move(pairs)), AreMine(this->ThePairs.size(), 1)
{
  using Key = std::array<Index, 2>;
  std::vector<std::pair<Key, int>> items;
  for (std::size_t p = 0; p < this->ThePairs.size(); ++p)
  {
    const auto& [a, b] = this->ThePairs[p];
    if ((a == 0 || share.IsShared[a]) && share.IsShared[b])
    {
      items.push_back({ { { share.Ids[a], share.Ids[b] } }, static_cast<int>(p) });
    }
  }
  for (int f : fragments)
  {
    items.push_back({ { { share.Ids[f], share.Ids[f] } }, ~f });
  }
  std::sort(items.begin(), items.end());
  std::vector<Key> keys;
  for (const auto& [key, item] : items)
  {
    keys.push_back(key);
    this->Items.push_back(item);
  }
  this->Ways = KeyMerge<Key>(std::move(keys), *share.Group);
  std::vector<int> lowest(this->Items.size(), share.Group->Rank());
  this->Ways.Merge(lowest, 1, [](int& a, int b) { a = std::min(a, b); });
  for (std::size_t i = 0; i < this->Items.size(); ++i)
  {
    if (this->Items[i] >= 0)
    {
      this->AreMine[this->Items[i]] = lowest[i] == share.Group->Rank();
    }
  }
}

void PairShare::Sum(std::vector<ExactSum>& pairs, std::vector<ExactSum>& fragments) const
{
  const auto sumOf = [&](int item) -> ExactSum&
  { return item >= 0 ? pairs[item] : fragments[~item]; };
  std::vector<ExactSum> sums;
  sums.reserve(this->Items.size());
  for (int item : this->Items)
  {
    sums.push_back(sumOf(item));
  }
  this->Ways.Merge(sums, 1, [](ExactSum& a, const ExactSum& b) { a.Add(b); });
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    sumOf(this->Items[i]) = sums[i];
  }
}

void PairShare::Sum(std::vector<ExactSum>& pairs) const
{
  std::vector<ExactSum> none;
  this->Sum(pairs, none);
}

} // namespace vfm
