/**
 * LabelCondition: the condition on 2x2x2 stars of labels that makes interfaces manifold and the
 * initial mesh valid.
 *
 * A star is the eight cells around a grid node, numbered by bits (x first). The region of a label
 * in it is a mask of eight bits. The region violates an axis if it has face normals in both
 * directions along it. A region that violates no axis is unate. A star passes if the region of
 * every label in it, void included, is unate. Unate regions and their complements are face
 * connected, so passing stars are manifold for every label.
 *
 * Validity. In a passing star, put the surface node S on the grid node v, and the inner node I of
 * each label at v + d. Along an axis with a face normal of its region, d = +-delta against the
 * outward normal; along others, d = 0. Let delta be 1/8 of the smaller of the two widths at the
 * node along the axis. Then all hexes are positive throughout, for any widths. In units of the
 * width of each cell, delta <= 1/8:
 * - Core hex: each of its twelve edges is at least 1 - 2 delta along its axis and at most 2 delta
 *   along the two others. Any three edges, one per axis, are therefore diagonally dominant and
 *   have a positive determinant (delta < 1/6). The Bernstein coefficients of the Jacobian are
 *   means of such determinants.
 * - Buffer hex: the edges across it are delta along that axis and 0 along the others. For these
 *   others, the same argument holds with two edges.
 * The star is mirrored at the domain boundary.
 *
 * Flat seams of periodic grids have one more condition, CountSeamViolations.
 */
#pragma once

#include <array>

namespace vfm
{

/// Outward face normals of a region of a star.
struct RegionNormals
{
  unsigned char Plus = 0;  ///< bit a is set if a face of the region has the normal +a
  unsigned char Minus = 0; ///< bit a is set if a face of the region has the normal -a
  /// Returns the number of axes that the region violates.
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

/// Outward face normals of every region, by its mask.
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
static_assert(CountUnateRegions() == 102, "102 of the 254 mixed two-label stars pass");

/// Returns the mask of the cells of a star that have a label.
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

/// Returns the number of (label, axis) pairs with both normals; 0 for a star that passes.
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

/// Returns whether a cell of a star breaks the condition of a flat seam across an axis: its label
/// is on both sides of the seam, but not in the cell on the other side.
constexpr bool BreaksSeam(const std::array<int, 8>& star, int cell, int axis)
{
  const int bit = 1 << axis;
  bool isBeyond = false; // whether the label is also on the other side
  for (int d = 0; d < 8; ++d)
  {
    isBeyond = isBeyond || ((d & bit) != (cell & bit) && star[d] == star[cell]);
  }
  return star[cell ^ bit] != star[cell] && isBeyond;
}

/// Returns the number of cells of a star at which a label breaks the condition of a flat seam.
/// A label on both sides of the seam has one inner point there, a corner of hexes on both sides. So
/// that it can lie in the plane, no face of this label may be on the seam at this node.
/// @param axes  bit a is set if the node is on a flat seam across axis a
constexpr int CountSeamViolations(const std::array<int, 8>& star, int axes)
{
  int count = 0;
  for (int a = 0; a < 3; ++a)
  {
    for (int c = 0; (axes >> a & 1) != 0 && c < 8; ++c)
    {
      count += BreaksSeam(star, c, a);
    }
  }
  return count;
}

/// Distinct labels of a star, ascending.
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
  /// Returns the position of a label of the star.
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
