#include "Images/ImagePlace.h"

#include "Base/ParseText.h"
#include "Base/Vector3.h"
#include "CellCount.h"
#include "InputTrust.h"
#include "OpenFile.h"

#include <cmath>
#include <cstdlib>
#include <limits>

namespace vfm
{
namespace
{

constexpr double LargestCosine = 1e-4; // an error of 0.03 cells over an image of 300 cells
constexpr Index LargestRatio = 5000;   // compression ratio; LZW of TIFF can reach half of it

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
  const bool isSize = value >= 0.0 && value < most && value == std::floor(value);
  return isSize ? static_cast<Index>(value) : 0;
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
        FormatNumber(place.Spacing[a]) + "; it must be above 0.");
    }
    if (!std::isfinite(place.Origin[a]))
    {
      throw InputError("its origin is not finite.");
    }
  }
  CountCells(place.Size);
}

void CheckLength(const std::string& path, Index offset, Index bytes, bool areCompressed)
{
  const Index length = GetFileLength(path), there = length - offset;
  if (there < 0)
  {
    throw InputError("its values are truncated: they begin at byte " + std::to_string(offset) +
      ", and the file has " + std::to_string(length) + " bytes.");
  }
  const bool isUnlimited = areCompressed && InputTrust::IsGiven() && there > 0;
  if (!isUnlimited && (there <= 0 || bytes / (areCompressed ? LargestRatio : 1) > there))
  {
    throw InputError("its values are truncated: they have " + std::to_string(bytes) + " bytes" +
      (areCompressed ? " uncompressed" : "") + ", but there are " + std::to_string(there) + "." +
      (areCompressed && there > 0 ? std::string(" ") + InputTrust::Advice : ""));
  }
}

} // namespace vfm
