#include "Elements/Hex/VisibleDirection.h"

#include "Base/Vector3.h"

namespace vfm
{
namespace
{

constexpr int Iterations = 400;
constexpr double Converged = 1e-10; // accuracy of the squared length
// Length below which the hull contains 0.
constexpr double Nowhere = 1e-8;

/// Returns the normal with the smallest component along a direction.
const Vector3& FindLeast(const std::vector<Vector3>& normals, const Vector3& direction)
{
  return *std::min_element(normals.begin(), normals.end(),
    [&](const Vector3& a, const Vector3& b) { return Dot(a, direction) < Dot(b, direction); });
}

} // namespace

VisibleDirection FindVisibleDirection(const std::vector<Vector3>& normals)
{
  Vector3 nearest{ { 0.0, 0.0, 0.0 } };
  for (const Vector3& n : normals)
  {
    nearest = nearest + (1.0 / static_cast<double>(normals.size())) * n;
  }
  for (int i = 0; i < Iterations; ++i)
  {
    const Vector3& least = FindLeast(normals, nearest);
    const Vector3 step = least - nearest;
    const double gap = -Dot(step, nearest), length = Dot(step, step);
    if (gap <= Converged || length <= 0.0)
    {
      break;
    }
    nearest = nearest + std::min(gap / length, 1.0) * step;
  }
  const double length = Norm(nearest);
  if (length < Nowhere)
  {
    return { { { 1.0, 0.0, 0.0 } }, -1.0 };
  }
  const Vector3 direction = (1.0 / length) * nearest;
  return { direction, Dot(FindLeast(normals, direction), direction) };
}

} // namespace vfm
