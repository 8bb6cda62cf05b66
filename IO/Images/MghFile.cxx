#include "Base/Vector3.h"
#include "Images/ImageFile.h"
#include "Images/StoredValues.h"
#include "OpenFile.h"
#include "SwapBytes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <zlib.h>

namespace vfm
{
namespace
{

constexpr int HeaderLength = 284, UsedLength = 90; // bytes

/// Header of an MGH file; all numbers are big-endian.
class MghHeader
{
public:
  explicit MghHeader(const std::string& path)
  {
    OpenFile(path);
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
    this->IsPacked = file && gzdirect(file.get()) == 0;
    const int count = file ? gzread(file.get(), this->Bytes.data(), UsedLength) : 0;
    if (count != UsedLength || this->Take<std::int32_t>(0) != 1)
    {
      throw InputError("it is not an MGH file of version 1.");
    }
  }

  template <class Value>
  Value Take(int at) const
  {
    Value value;
    std::memcpy(&value, this->Bytes.data() + at, sizeof(Value));
    return IsLittleEndian() ? SwapBytes(value) : value;
  }
  /// Returns three numbers.
  Vector3 TakeVector(int at) const
  {
    return { { this->Take<float>(at), this->Take<float>(at + 4), this->Take<float>(at + 8) } };
  }

  bool IsPacked = false;

private:
  std::array<char, UsedLength> Bytes{};
};

int FindType(const MghHeader& header)
{
  const int type = header.Take<std::int32_t>(20);
  switch (type)
  {
    case 0:
      return ValueType::UnsignedChar;
    case 1:
      return ValueType::Int;
    case 3:
      return ValueType::Float;
    case 4:
      return ValueType::Short;
    default:
      throw InputError("its values are of type " + std::to_string(type) +
        " of MGH. Supported types: 0 (uchar), 1 (int), 3 (float), 4 (short).");
  }
}

/// Sets spacing, axes and origin. The header contains the position of the middle of the image.
void SetPlace(const MghHeader& header, ImagePlace& place)
{
  std::array<Vector3, 3> axes{ { { { -1.0, 0.0, 0.0 } }, { { 0.0, 0.0, -1.0 } },
    { { 0.0, 1.0, 0.0 } } } };
  Vector3 middle{};
  if (header.Take<std::int16_t>(28) > 0)
  {
    place.Spacing = header.TakeVector(30);
    CheckPlace(place);
    axes = { header.TakeVector(42), header.TakeVector(54), header.TakeVector(66) };
    middle = header.TakeVector(78);
  }
  std::array<Vector3, 3> steps{};
  for (int a = 0; a < 3; ++a)
  {
    steps[a] = place.Spacing[a] * axes[a];
  }
  if (!AreAtRightAngles(steps))
  {
    throw InputError("its axes are not at right angles. Resample the image onto a grid of right "
                     "angles.");
  }
  const Vector3 spacing = place.Spacing;
  SetSteps(steps, place);
  place.Spacing = spacing; // lengths of axes in single precision differ from 1
  place.Origin = middle;
  for (int a = 0; a < 3; ++a)
  {
    const double half = 0.5 * static_cast<double>(place.Size[a]);
    place.Origin = place.Origin - half * place.Spacing[a] * place.Axes[a];
  }
  CheckPlace(place);
}

} // namespace

ImageFile OpenMgh(const std::string& path, const ImageRequest& request)
{
  const MghHeader header(path);
  const auto size = [&header](int at)
  { return ToSize(static_cast<double>(header.Take<std::int32_t>(at))); };
  ImageFile image;
  image.Place.Size = { size(4), size(8), size(12) };
  CheckPlace(image.Place);
  SetPlace(header, image.Place);
  StoredValues stored{ { path }, FindType(header) };
  stored.AreCompressed = header.IsPacked;
  stored.AreSwapped = IsLittleEndian();
  image.Volumes = std::max<Index>(size(16), 1);
  const Index volume = SelectVolume(request, image.Volumes, "frames");
  CheckFiles(stored, image.Place.Size);
  stored.Skip = HeaderLength + stored.CountBytes(image.Place.Size, volume);
  CheckFiles(stored, image.Place.Size);
  image.Read = [stored, size3 = image.Place.Size](const IndexBox& box)
  { return ReadStored(stored, size3, box); };
  return image;
}

} // namespace vfm
