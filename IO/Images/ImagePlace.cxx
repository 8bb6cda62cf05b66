#include "Images/ImagePlace.h"

#include "Base/Vector3.h"
#include "Ranks/Errors.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <sstream>

namespace vfm
{
namespace
{

constexpr double LargestCosine = 1e-4;  // an error of 0.03 cells over an image of 300 cells
constexpr double LargestRatio = 5000.0; // compression ratio; LZW of TIFF can reach half of it

/// Returns the length of a vector; exact for vectors along axes.
double Length(const Vector3& a)
{
  return std::hypot(a[0], a[1], a[2]);
}

Vector3 Direction(const Vector3& a)
{
  const double length = Length(a);
  // Adding 0.0 turns -0.0 into 0.0.
  return { { a[0] / length + 0.0, a[1] / length + 0.0, a[2] / length + 0.0 } };
}

} // namespace

bool AreAtRightAngles(const std::array<Vector3, 3>& steps)
{
  for (int a = 0; a < 3; ++a)
  {
    const Vector3 &one = steps[a], &other = steps[(a + 1) % 3];
    // The negated comparison is also true for numbers that are not finite.
    if (!(std::abs(Dot(one, other)) <= LargestCosine * Length(one) * Length(other)) ||
      !(Length(one) > 0.0))
    {
      return false;
    }
  }
  return true;
}

void SetSteps(const std::array<Vector3, 3>& steps, ImagePlace& place)
{
  for (int a = 0; a < 3; ++a)
  {
    place.Spacing[a] = Length(steps[a]);
    Vector3 axis = Direction(steps[a]);
    for (int b = 0; b < a; ++b)
    {
      axis = Direction(axis - Dot(axis, place.Axes[b]) * place.Axes[b]);
    }
    place.Axes[a] = axis;
  }
}

Index ToSize(double value)
{
  constexpr double most = std::numeric_limits<int>::max();
  return value >= 0.0 && value < most ? static_cast<Index>(value) : 0;
}

void CheckPlace(const ImagePlace& place)
{
  for (int a = 0; a < 3; ++a)
  {
    if (place.Size[a] < 1 || place.Size[a] > std::numeric_limits<int>::max() - 1)
    {
      throw InputError("its size is " + std::to_string(place.Size[0]) + " x " +
        std::to_string(place.Size[1]) + " x " + std::to_string(place.Size[2]) + " values.");
    }
    if (!(place.Spacing[a] > 0.0) || !std::isfinite(place.Spacing[a]))
    {
      throw InputError("its spacing along axis " + std::to_string(a + 1) + " is " +
        std::to_string(place.Spacing[a]) + "; it must be above 0.");
    }
    if (!std::isfinite(place.Origin[a]))
    {
      throw InputError("its origin is not finite.");
    }
  }
}

void CheckLength(const std::string& path, double offset, double bytes, bool areCompressed)
{
  std::error_code error;
  const double there = static_cast<double>(std::filesystem::file_size(path, error)) - offset;
  if (!error && bytes > (areCompressed ? LargestRatio : 1.0) * there)
  {
    std::ostringstream text;
    text << std::fixed << std::setprecision(0) << "its values are truncated: they have " << bytes
         << " bytes" << (areCompressed ? " uncompressed" : "") << ", but there are " << there
         << ".";
    throw InputError(text.str());
  }
}

} // namespace vfm
