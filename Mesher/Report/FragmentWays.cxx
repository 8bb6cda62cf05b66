#include "Report/FragmentWays.h"

#include "Base/Sorted.h"

namespace vfm
{
namespace
{

/// Returns the fragments of elements and further ones, ascending.
std::vector<int> ListFragments(const MeshData& mesh, const std::vector<int>& more)
{
  std::vector<int> ids = more;
  for (Index e = 0; e < mesh.NumberOfElements; ++e)
  {
    if (e == 0 || mesh.Fragment[e] != mesh.Fragment[e - 1])
    {
      ids.push_back(mesh.Fragment[e]);
    }
  }
  SortUnique(ids);
  ids.shrink_to_fit();
  return ids;
}

std::vector<int> FindPlaces(const MeshData& mesh, const std::vector<int>& ids)
{
  std::vector<int> places(mesh.NumberOfElements);
  for (Index e = 0; e < mesh.NumberOfElements; ++e)
  {
    places[e] = e > 0 && mesh.Fragment[e] == mesh.Fragment[e - 1]
      ? places[e - 1]
      : static_cast<int>(FindSorted(ids, mesh.Fragment[e]));
  }
  return places;
}

} // namespace

FragmentWays::FragmentWays(const MeshData& mesh, const std::vector<int>& more, Ranks& ranks) :
  Homes(CountHomes(ranks)), Own(ListFragments(mesh, more)), Places(FindPlaces(mesh, this->Own))
{
  this->Last = static_cast<Index>(ranks.Max(this->Own.empty() ? 1.0 : this->Own.back()));
  this->Ways = KeyMerge<int>(
    this->Own, [this](int id) { return this->HomeOf(id); }, ranks);
}

int FragmentWays::HomeOf(int id) const
{
  return static_cast<int>((id - 1) * static_cast<Index>(this->Homes) / this->Last);
}

} // namespace vfm
