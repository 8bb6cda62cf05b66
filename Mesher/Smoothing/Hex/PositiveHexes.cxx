#include "Smoothing/Hex/PositiveHexes.h"

#include "Elements/Hex/EdgeProducts.h"

#include <atomic>

namespace vfm
{
namespace
{

// Smallest coefficients, in cell volumes, of all hexes and of those of which only some points went
// back.
constexpr double LeastCoefficient = 1e-6, LeastOfMixed = 0.01;

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

/// Appends the hexes with a small coefficient.
VFM_CLONES
void FindSmallHexes(const ActiveMesh& mesh, const std::vector<unsigned char>& returned, Index first,
  Index last, std::vector<Index>& found)
{
  for (Index hex = first; hex < last; ++hex)
  {
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
  const std::vector<unsigned char>& returned, std::vector<unsigned char>& points)
{
  std::atomic<bool> isFound(false);
  runtime.For(0, static_cast<Index>(mesh.Elements.size() / 8),
    [&](Index first, Index last)
    {
      std::vector<Index> found;
      FindSmallHexes(mesh, returned, first, last, found);
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
