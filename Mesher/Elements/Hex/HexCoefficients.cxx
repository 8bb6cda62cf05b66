#include "Elements/Hex/HexCoefficients.h"

#include "Elements/Hex/EdgeProducts.h"

namespace vfm
{
namespace
{

VFM_CLONES
double FindSmallest(const HexCorners& corners)
{
  return SmallestOf(MakeProducts(MakeEdges(corners)));
}

} // namespace

double SmallestCoefficient(const std::array<Vector3, 8>& corners)
{
  HexCorners pointers;
  for (int c = 0; c < 8; ++c)
  {
    pointers[c] = corners[c].data();
  }
  return FindSmallest(pointers);
}

} // namespace vfm
