/**
 * The label condition: which 2x2x2 stars of labels give manifold interfaces and a valid start.
 *
 * A star is the eight cells around a grid node, numbered by bits (x first). The region of a label in it
 * is a mask of eight bits. An axis is violated by a region when both a + and a - face normal of the
 * region occur along it; a region with no violated axis is unate. A star passes when the region of every
 * label in it, void included, is unate. Unate regions and their complements are face connected, so
 * passing stars are manifold for every label.
 *
 * Validity. In a passing star put the surface node S on the grid node v and the inner node I of a label
 * at v + d, d = +-delta against the outward normals of its region, 0 on axes without one. With
 * delta = 1/8 of the smaller of the two widths at the node along the axis all hexes are positive throughout, whatever the widths. Measure in
 * each cell by its own: delta <= 1/8 there. The twelve edges of a core hex are 1 - 2 delta or more along their axis and at most 2 delta along
 * the two others, so any three, one of each axis, are diagonally dominant and have a positive determinant (delta < 1/6); the Bernstein
 * coefficients of the Jacobian are means of such. In a buffer hex the edges across are delta along that axis, the others 0, and among these
 * others the same holds of two. Beyond the domain the star mirrors.
 */
#pragma once

#include <array>

namespace vfm
{

struct RegionNormals
{
  unsigned char Plus = 0;  ///< bit a: a face of the region looks along +a
  unsigned char Minus = 0; ///< bit a: a face of the region looks along -a
  constexpr int ViolatedAxes() const
  {
    const int both = this->Plus & this->Minus;
    return (both & 1) + (both >> 1 & 1) + (both >> 2 & 1);
  }
};

namespace detail
{

constexpr std::array<RegionNormals, 256> MakeRegionNormals()
{
  std::array<RegionNormals, 256> table{};
  for (int region = 0; region < 256; ++region)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int low = 0; low < 8; ++low)
      {
        if (low >> axis & 1)
        {
          continue;
        }
        const bool lowIn = region >> low & 1;
        const bool highIn = region >> (low | 1 << axis) & 1;
        if (lowIn && !highIn)
        {
          table[region].Plus |= 1 << axis;
        }
        if (!lowIn && highIn)
        {
          table[region].Minus |= 1 << axis;
        }
      }
    }
  }
  return table;
}

} // namespace detail

/// Outward face normals of every region of a star.
constexpr std::array<RegionNormals, 256> RegionNormalsTable = detail::MakeRegionNormals();

constexpr int CountUnateRegions()
{
  int count = 0;
  for (int region = 1; region < 255; ++region)
  {
    count += RegionNormalsTable[region].ViolatedAxes() == 0;
  }
  return count;
}
static_assert(CountUnateRegions() == 102, "of the 254 mixed two-label stars 102 pass");

/// The cells of a star that hold a label.
template <class Star>
constexpr int RegionOfLabel(const Star& star, int label)
{
  int region = 0;
  for (int c = 0; c < 8; ++c)
  {
    region |= (star[c] == label) << c;
  }
  return region;
}

/// Number of (label, axis) pairs with both normals: 0 for a star that passes.
template <class Star>
constexpr int CountViolations(const Star& star)
{
  int count = 0;
  int seen = 0;
  for (int c = 0; c < 8; ++c)
  {
    if (seen >> c & 1)
    {
      continue;
    }
    const int region = RegionOfLabel(star, star[c]);
    seen |= region;
    count += RegionNormalsTable[region].ViolatedAxes();
  }
  return count;
}

/// The distinct labels of a star, ascending.
struct StarLabels
{
  std::array<int, 8> Label{};
  int Count = 0;

  template <class Star>
  explicit StarLabels(const Star& star)
  {
    for (int c = 0; c < 8; ++c)
    {
      int at = 0;
      while (at < this->Count && this->Label[at] < star[c])
      {
        ++at;
      }
      if (at < this->Count && this->Label[at] == star[c])
      {
        continue;
      }
      for (int m = this->Count; m > at; --m)
      {
        this->Label[m] = this->Label[m - 1];
      }
      this->Label[at] = star[c];
      ++this->Count;
    }
  }
  const int* begin() const { return this->Label.data(); }
  const int* end() const { return this->Label.data() + this->Count; }
  int RankOf(int label) const
  {
    int rank = 0;
    while (this->Label[rank] != label)
    {
      ++rank;
    }
    return rank;
  }
};

} // namespace vfm
