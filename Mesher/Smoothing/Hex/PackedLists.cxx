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

void PackedNumbers::Add(std::int64_t difference)
{
  const auto bits = static_cast<std::uint64_t>(difference);
  std::uint64_t rest = bits << 1 ^ (difference < 0 ? ~std::uint64_t(0) : 0); // the sign is lowest
  for (; rest >= More; rest >>= BitsOfByte)
  {
    this->Bytes.push_back(static_cast<unsigned char>(rest | More));
  }
  this->Bytes.push_back(static_cast<unsigned char>(rest));
}

std::int64_t PackedNumbers::Reader::Next()
{
  std::uint64_t bits = 0;
  unsigned shift = 0;
  for (; *this->Byte & More; ++this->Byte, shift += BitsOfByte)
  {
    bits |= static_cast<std::uint64_t>(*this->Byte & (More - 1)) << shift;
  }
  bits |= static_cast<std::uint64_t>(*this->Byte++) << shift;
  return static_cast<std::int64_t>(bits >> 1 ^ ((bits & 1) != 0 ? ~std::uint64_t(0) : 0));
}

PackedFacets::PackedFacets(std::vector<Facet>& facets) : Count(facets.size()), Materials(1, 0)
{
  Facet last{};
  for (const Facet& facet : facets)
  {
    this->Numbers.Add(2 * facet.DomainSide + facet.IsOwned);
    this->Numbers.Add(facet.Points[0] - last.Points[0]);
    for (int c = 1; c < 4; ++c)
    {
      this->Numbers.Add(facet.Points[c] - facet.Points[c - 1]);
    }
    for (int side = 0; side < 2; ++side)
    {
      const int fragment = facet.Fragments[side];
      this->Numbers.Add(std::int64_t(fragment) - last.Fragments[side]);
      this->Materials.resize(std::max<std::size_t>(this->Materials.size(), fragment + 1));
      this->Materials[fragment] = fragment == 0 ? 0 : facet.Materials[side];
    }
    last = facet;
  }
  this->Numbers.Finish();
  std::vector<Facet>().swap(facets);
}

std::vector<Facet> PackedFacets::Unpack() const
{
  std::vector<Facet> facets;
  facets.reserve(this->Count);
  PackedNumbers::Reader reader(this->Numbers);
  Facet facet{};
  while (facets.size() < this->Count)
  {
    const std::int64_t place = reader.Next();
    facet.IsOwned = (place & 1) != 0;
    facet.DomainSide = static_cast<int>((place - facet.IsOwned) / 2);
    facet.Points[0] += reader.Next();
    for (int c = 1; c < 4; ++c)
    {
      facet.Points[c] = facet.Points[c - 1] + reader.Next();
    }
    for (int side = 0; side < 2; ++side)
    {
      facet.Fragments[side] += static_cast<int>(reader.Next());
      facet.Materials[side] = this->Materials[facet.Fragments[side]];
    }
    facets.push_back(facet);
  }
  return facets;
}

PackedPoints::PackedPoints(Buffer<double>& points, ActiveMesh& active) :
  Count(static_cast<Index>(points.size() / 3))
{
  active.CodeStarts();
  const std::vector<int> others = this->ListOthers(active);
  this->Others = CodedPoints(points.data(), others);
  if (active.Starts.IsEmpty() || this->Others.Count() < others.size())
  {
    active.Starts = CodedPoints();
    return;
  }
  points = Buffer<double>();
}

void PackedPoints::Unpack(Buffer<double>& points, ActiveMesh& active) const
{
  if (!points.empty() || this->Count == 0)
  {
    return;
  }
  points = Buffer<double>(3 * this->Count);
  const auto place = [&points](int point, const Vector3& x)
  { std::copy(x.begin(), x.end(), points.data() + 3 * static_cast<Index>(point)); };
  const std::vector<int> others = this->ListOthers(active);
  for (std::size_t p = 0; p < others.size(); ++p)
  {
    place(others[p], this->Others.At(p));
  }
  for (std::size_t p = 0; p < active.MeshPoint.size(); ++p)
  {
    place(active.MeshPoint[p], active.Starts.At(p));
  }
  active.MeshPoints = points.data();
}

/// Lists the points that the active mesh does not have.
std::vector<int> PackedPoints::ListOthers(const ActiveMesh& active) const
{
  std::vector<bool> isActive(this->Count);
  for (int point : active.MeshPoint)
  {
    isActive[point] = true;
  }
  std::vector<int> others;
  others.reserve(this->Count - active.MeshPoint.size());
  for (Index point = 0; point < this->Count; ++point)
  {
    if (!isActive[point])
    {
      others.push_back(static_cast<int>(point));
    }
  }
  return others;
}

} // namespace vfm
