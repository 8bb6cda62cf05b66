#include "Volumes/PairShare.h"

namespace vfm
{

PairShare::PairShare(const FragmentShare& share, std::vector<FragmentPair> pairs) :
  ThePairs(std::move(pairs)), AreMine(this->ThePairs.size(), 1), Fragments(share.Shared)
{
  using Key = std::array<Index, 2>;
  std::vector<Key> ofPairs, ofFragments;
  for (std::size_t p = 0; p < this->ThePairs.size(); ++p)
  {
    const auto& [a, b] = this->ThePairs[p];
    if ((a == 0 || share.IsShared[a]) && share.IsShared[b])
    {
      this->Shared.push_back(static_cast<int>(p));
      ofPairs.push_back({ { share.Ids[a], share.Ids[b] } });
    }
  }
  for (int fragment : this->Fragments)
  {
    ofFragments.push_back({ { share.Ids[fragment], share.Ids[fragment] } });
  }
  std::vector<Key> keys;
  std::merge(ofPairs.begin(), ofPairs.end(), ofFragments.begin(), ofFragments.end(),
    std::back_inserter(keys));
  const auto findPlaces = [&keys](const std::vector<Key>& some)
  {
    std::vector<std::size_t> places;
    for (const Key& key : some)
    {
      places.push_back(FindSorted(keys, key));
    }
    return places;
  };
  this->PlacesOfPairs = findPlaces(ofPairs);
  this->PlacesOfFragments = findPlaces(ofFragments);
  std::vector<int> lowest(keys.size(), share.Group->Rank());
  this->Ways = KeyMerge<Key>(std::move(keys), *share.Group);
  this->Ways.Merge(lowest, 1, [](int& a, int b) { a = std::min(a, b); });
  for (std::size_t s = 0; s < this->Shared.size(); ++s)
  {
    this->AreMine[this->Shared[s]] = lowest[this->PlacesOfPairs[s]] == share.Group->Rank();
  }
}

void PairShare::Sum(std::vector<ExactSum>& pairs, std::vector<ExactSum>& fragments) const
{
  std::vector<ExactSum> sums(this->Shared.size() + this->Fragments.size());
  for (std::size_t s = 0; s < this->Shared.size(); ++s)
  {
    sums[this->PlacesOfPairs[s]] = pairs[this->Shared[s]];
  }
  for (std::size_t s = 0; s < this->Fragments.size(); ++s)
  {
    sums[this->PlacesOfFragments[s]] = fragments[this->Fragments[s]];
  }
  this->Ways.Merge(sums, 1, [](ExactSum& a, const ExactSum& b) { a.Add(b); });
  for (std::size_t s = 0; s < this->Shared.size(); ++s)
  {
    pairs[this->Shared[s]] = sums[this->PlacesOfPairs[s]];
  }
  for (std::size_t s = 0; s < this->Fragments.size(); ++s)
  {
    fragments[this->Fragments[s]] = sums[this->PlacesOfFragments[s]];
  }
}

} // namespace vfm
