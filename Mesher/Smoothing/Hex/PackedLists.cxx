#include "Smoothing/Hex/PackedLists.h"

#include <algorithm>
#include <cstdint>

namespace vfm
{
namespace
{

constexpr unsigned BitsOfByte = 7; // the eighth bit is set if more bytes of a number follow
constexpr unsigned char More = 1 << BitsOfByte;

} // namespace

PackedIds::PackedIds(Buffer<Index>& ids) : Count(ids.size())
{
  this->Bytes.reserve(this->Count + this->Count / 8);
  std::uint64_t last = 0;
  for (Index id : ids)
  {
    std::uint64_t rest = static_cast<std::uint64_t>(id) - last;
    for (; rest >= More; rest >>= BitsOfByte)
    {
      this->Bytes.push_back(static_cast<unsigned char>(rest | More));
    }
    this->Bytes.push_back(static_cast<unsigned char>(rest));
    last = static_cast<std::uint64_t>(id);
  }
  ids = Buffer<Index>();
}

Buffer<Index> PackedIds::Unpack() const
{
  Buffer<Index> ids(this->Count);
  auto byte = this->Bytes.begin();
  std::uint64_t last = 0;
  for (Index& id : ids)
  {
    unsigned shift = 0;
    for (; *byte & More; ++byte, shift += BitsOfByte)
    {
      last += static_cast<std::uint64_t>(*byte & (More - 1)) << shift;
    }
    last += static_cast<std::uint64_t>(*byte++) << shift;
    id = static_cast<Index>(last);
  }
  return ids;
}

PackedFacets::PackedFacets(std::vector<Facet>& facets)
{
  this->Facets.reserve(facets.size());
  this->Materials.assign(1, 0);
  for (const Facet& facet : facets)
  {
    Packed packed{ {}, facet.Fragments, static_cast<signed char>(facet.DomainSide), facet.IsOwned };
    std::transform(facet.Points.begin(), facet.Points.end(), packed.Points.begin(),
      [](Index point) { return static_cast<int>(point); });
    this->Facets.push_back(packed);
    for (int side = 0; side < 2; ++side)
    {
      const std::size_t fragment = facet.Fragments[side];
      this->Materials.resize(std::max(this->Materials.size(), fragment + 1));
      this->Materials[fragment] = fragment == 0 ? 0 : facet.Materials[side];
    }
  }
  std::vector<Facet>().swap(facets);
}

std::vector<Facet> PackedFacets::Unpack() const
{
  std::vector<Facet> facets;
  facets.reserve(this->Facets.size());
  for (const Packed& packed : this->Facets)
  {
    Facet facet{ {},
      { { this->Materials[packed.Fragments[0]], this->Materials[packed.Fragments[1]] } },
      packed.Fragments, packed.DomainSide, packed.IsOwned };
    std::copy(packed.Points.begin(), packed.Points.end(), facet.Points.begin());
    facets.push_back(facet);
  }
  return facets;
}

} // namespace vfm
