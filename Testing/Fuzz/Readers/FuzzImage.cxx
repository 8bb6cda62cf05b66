/**
 * Reads an image file with the suffix VFM_FUZZ_SUFFIX: the whole image, and one value.
 */
#include "Harness.h"

#include "Images/ImageFile.h"
#include "Ranks/Errors.h"

namespace vfm
{
namespace testing
{
namespace
{

constexpr double Small = 4e6;     // values that a run may read
constexpr double Overflow = 9e18; // a number of values that no reader may accept

} // namespace

void ReadBytes(const std::string& bytes)
{
  ImageRequest request;
  request.Array = "FeatureIds";
  const ImageFile file =
    OpenImageFile(WriteInput(std::string("a") + VFM_FUZZ_SUFFIX, bytes), request);
  const Index3& size = file.Place.Size;
  double count = 1.0;
  for (Index length : size)
  {
    count *= static_cast<double>(length);
  }
  const IndexBox whole{ { { 0, 0, 0 } }, size };
  if (count < Small || count > Overflow)
  {
    file.Read(whole);
  }
  if (file.ReadsParts)
  {
    file.Read({ { { size[0] - 1, size[1] - 1, size[2] - 1 } }, size });
  }
}

} // namespace testing
} // namespace vfm
