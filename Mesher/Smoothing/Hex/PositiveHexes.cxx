#include "Smoothing/Hex/PositiveHexes.h"

#include "Elements/Hex/EdgeProducts.h"
#include "Smoothing/ForFlagged.h"

#include <atomic>

namespace vfm
{
namespace
{

// Smallest coefficients, in cell volumes, of all hexes and of those of which only some points went
// back.
constexpr double LeastCoefficient = 1e-6, LeastOfMixed = 0.01;
// If fewer than this part of the points are given, only the hexes at them are checked. Finding the
// hexes of more points takes the time that this saves.
constexpr double FewPoints = 1.0 / 4.0;

VFM_INLINE HexCorners CornersOf(const ActiveMesh& mesh, Index firstPosition)
{
  HexCorners corners;
  for (int c = 0; c < 8; ++c)
  {
    corners[c] = mesh.X[mesh.Elements[firstPosition + c]].data();
  }
  return corners;
}

VFM_INLINE double VolumeAt(const ActiveMesh& mesh, Index position)
{
  const Vector3& widths = mesh.WidthsAt(position);
  return widths[0] * widths[1] * widths[2];
}

/// Returns the value that the coefficients of the hex at a position must exceed.
VFM_INLINE double LeastAt(const ActiveMesh& mesh, Index position)
{
  return LeastCoefficient * VolumeAt(mesh, position);
}

/// Returns whether some active points of a hex went back, but not all.
bool IsMixed(const ActiveMesh& mesh, const std::vector<unsigned char>& returned, Index hex)
{
  bool isAny = false, areAll = true;
  for (int c = 0; c < 8; ++c)
  {
    const int point = mesh.Elements[8 * hex + c];
    isAny |= returned[point] != 0;
    areAll &= returned[point] || !mesh.IsActive[point];
  }
  return isAny && !areAll;
}

/// Returns whether each hex is at a flagged active point; an empty list if there are many of them.
std::vector<unsigned char> FindHexesAt(
  const ActiveMesh& mesh, Runtime& runtime, const std::vector<unsigned char>& points)
{
  const auto count = static_cast<double>(std::count(points.begin(), points.end(), 1));
  if (count >= FewPoints * static_cast<double>(points.size()))
  {
    return {};
  }
  std::vector<unsigned char> hexes(mesh.Elements.size() / 8, 0);
  ForFlagged(runtime, points,
    [&](Index point)
    {
      for (CornerPosition at = mesh.CornerOffset[point]; at < mesh.CornerOffset[point + 1]; ++at)
      {
        __atomic_store_n(&hexes[mesh.CornerList[at] / 8], 1, __ATOMIC_RELAXED);
      }
    });
  return hexes;
}

/// Appends the hexes with a small coefficient.
/// @param isChecked  which hexes are checked; empty: all
VFM_CLONES
void FindSmallHexes(const ActiveMesh& mesh, const std::vector<unsigned char>& returned,
  const std::vector<unsigned char>& isChecked, Index first, Index last, std::vector<Index>& found)
{
  const bool areAllChecked = isChecked.empty();
  for (Index hex = first; hex < last; ++hex)
  {
    if (!areAllChecked && !isChecked[hex])
    {
      continue;
    }
    const Index position = 8 * hex;
    const double least = !returned.empty() && IsMixed(mesh, returned, hex)
      ? LeastOfMixed * VolumeAt(mesh, position)
      : LeastAt(mesh, position);
    if (!Exceeds(MakeProducts(MakeEdges(CornersOf(mesh, position))), least))
    {
      found.push_back(hex);
    }
  }
}

/// Returns the smallest coefficient of the hex at a position of the corner list.
VFM_INLINE double SmallestAt(const ActiveMesh& mesh, Index position)
{
  return SmallestOf(MakeProducts(MakeEdges(CornersOf(mesh, position & ~7))));
}

VFM_CLONES
bool MayStandAt(const ActiveMesh& mesh, int point, const Vector3& x)
{
  for (CornerPosition at = mesh.CornerOffset[point]; at < mesh.CornerOffset[point + 1]; ++at)
  {
    const Index position = mesh.CornerList[at];
    HexCorners corners = CornersOf(mesh, position & ~7);
    corners[position & 7] = x.data();
    const EdgeProducts then = MakeProducts(MakeEdges(corners));
    if (!Exceeds(then, LeastAt(mesh, position)) &&
      !(SmallestOf(then) >= SmallestAt(mesh, position)))
    {
      return false;
    }
  }
  return true;
}

} // namespace

bool MarkSmallCoefficients(const ActiveMesh& mesh, Runtime& runtime,
  const std::vector<unsigned char>& returned, const std::vector<unsigned char>& where,
  std::vector<unsigned char>& points)
{
  const std::vector<unsigned char> isChecked = FindHexesAt(mesh, runtime, where);
  std::atomic<bool> isFound(false);
  runtime.For(0, static_cast<Index>(mesh.Elements.size() / 8),
    [&](Index first, Index last)
    {
      std::vector<Index> found;
      FindSmallHexes(mesh, returned, isChecked, first, last, found);
      for (Index hex : found)
      {
        for (int c = 0; c < 8; ++c)
        {
          __atomic_store_n(&points[mesh.Elements[8 * hex + c]], 1, __ATOMIC_RELAXED);
        }
        isFound = true;
      }
    });
  return isFound;
}

bool KeepPositiveCoefficients(const ActiveMesh& mesh, int point, const Vector3& x)
{
  return MayStandAt(mesh, point, x);
}

} // namespace vfm
