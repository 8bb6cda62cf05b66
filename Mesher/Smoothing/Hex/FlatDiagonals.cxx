#include "Smoothing/Hex/FlatDiagonals.h"

namespace vfm
{
namespace
{

constexpr double ClearlyLarger = 1.01; // factor of sines

} // namespace

std::vector<int> FlatDiagonals::Turn(const ActiveMesh& mesh)
{
  this->AreTurned.resize(mesh.Elements.size() / 8, 0);
  std::vector<int> corners;
  for (std::size_t hex = 0; hex < this->AreTurned.size(); ++hex)
  {
    const std::array<double, 2> sines = SinesOfDiagonals(LowerQuad(mesh, this->Plane, hex));
    unsigned char& isTurned = this->AreTurned[hex];
    if (sines[!isTurned] > std::max(0.0, ClearlyLarger * sines[isTurned]))
    {
      isTurned = !isTurned;
      const std::array<int, 4> points = LowerCorners(mesh, this->Plane, hex);
      corners.insert(corners.end(), points.begin(), points.end());
    }
  }
  return corners;
}

} // namespace vfm
