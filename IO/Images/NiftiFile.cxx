#include "Base/ParseText.h"
#include "Base/Vector3.h"
#include "Images/CaretNames.h"
#include "Images/ImageFile.h"
#include "Images/StoredValues.h"
#include "OpenFile.h"
#include "SwapBytes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>
#include <zlib.h>

namespace vfm
{
namespace
{

constexpr int Length1 = 348, Length2 = 540; // bytes of the headers of NIfTI-1 and -2

/// Header of a NIfTI file. In NIfTI-2 most numbers are longer than in NIfTI-1 and at other places.
class NiftiHeader
{
public:
  explicit NiftiHeader(const std::string& path)
  {
    OpenFile(path);
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
    this->IsPacked = file && gzdirect(file.get()) == 0;
    const int read = file ? gzread(file.get(), this->Bytes.data(), Length2) : 0;
    for (bool isSwapped : { false, true })
    {
      this->IsSwapped = isSwapped;
      const int length = read >= Length1 ? this->Take<std::int32_t>(0) : 0;
      const char* magic = this->Bytes.data() + (length == Length1 ? 344 : 4);
      this->IsSecond = length == Length2;
      const bool isFirst = length == Length1 && magic[0] == 'n' && magic[2] == '1';
      if (isFirst || (length == Length2 && read == Length2 && magic[0] == 'n' && magic[2] == '2'))
      {
        if (magic[1] != '+')
        {
          throw InputError("it is only the header of an image. Pairs of .hdr and .img are not "
                           "supported; save the image as one file.");
        }
        return;
      }
    }
    throw InputError("it is not a NIfTI file.");
  }

  /// Returns a number: in NIfTI-1 of type Value1 at byte `first`, in NIfTI-2 of type Value2 at byte
  /// `second`, plus `index` numbers.
  template <class Value1, class Value2>
  double Number(int first, int second, int index = 0) const
  {
    return this->IsSecond
      ? static_cast<double>(this->Take<Value2>(second + index * int(sizeof(Value2))))
      : static_cast<double>(this->Take<Value1>(first + index * int(sizeof(Value1))));
  }
  double Real(int first, int second, int index = 0) const
  {
    return this->Number<float, double>(first, second, index);
  }
  double Dimension(int i) const { return this->Number<std::int16_t, std::int64_t>(40, 16, i); }
  /// Returns the number of bytes before the values. At least the header and the four bytes after it
  /// precede them.
  /// @throws InputError  if the number is invalid
  Index CountSkipped() const
  {
    const double skip = this->Number<float, std::int64_t>(108, 168);
    const int least = (this->IsSecond ? Length2 : Length1) + 4;
    if (!(skip >= least && skip < 0x1p53 && skip == std::floor(skip)))
    {
      throw InputError("its values begin at byte " + FormatNumber(skip) +
        " (vox_offset); the number must be an integer from " + std::to_string(least) + ".");
    }
    return static_cast<Index>(skip);
  }
  /// Returns entry i of pixdim; 1 if it is 0.
  double Width(int i) const
  {
    const double width = this->Real(76, 104, i);
    return width == 0.0 ? 1.0 : width;
  }
  bool HasForm(int first, int second) const
  {
    return this->Number<std::int16_t, std::int32_t>(first, second) > 0;
  }

  bool IsPacked = false, IsSwapped = false, IsSecond = false;

private:
  template <class Value>
  Value Take(int at) const
  {
    Value value;
    std::memcpy(&value, this->Bytes.data() + at, sizeof(Value));
    return this->IsSwapped ? SwapBytes(value) : value;
  }

  std::array<char, Length2> Bytes{};
};

int FindType(const NiftiHeader& header)
{
  const std::pair<int, int> types[] = { { 2, ValueType::UnsignedChar },
    { 256, ValueType::SignedChar }, { 512, ValueType::UnsignedShort }, { 4, ValueType::Short },
    { 768, ValueType::UnsignedInt }, { 8, ValueType::Int }, { 1280, ValueType::UnsignedLongLong },
    { 1024, ValueType::LongLong }, { 16, ValueType::Float }, { 64, ValueType::Double } };
  const int told = static_cast<int>(header.Number<std::int16_t, std::int16_t>(70, 12));
  for (const auto& [number, type] : types)
  {
    if (number == told)
    {
      const Index bits = static_cast<Index>(header.Number<std::int16_t, std::int16_t>(72, 14));
      if (bits != 0 && bits != 8 * WidthOfType(type))
      {
        throw InputError("its values of type " + std::to_string(told) + " of NIfTI have " +
          std::to_string(bits) + " bits (bitpix), where " + std::to_string(8 * WidthOfType(type)) +
          " are required.");
      }
      return type;
    }
  }
  throw InputError("its values are of type " + std::to_string(told) +
    " of NIfTI. Supported types: integers of 1 to 8 bytes, floating point of 4 or 8 bytes.");
}

Index3 FindSize(const NiftiHeader& header)
{
  const double dimensions = header.Dimension(0);
  if (!(dimensions >= 0.0 && dimensions <= 7.0))
  {
    throw InputError(
      "its image has " + FormatNumber(dimensions) + " dimensions; three are required.");
  }
  const auto size = [&](int i) { return i <= dimensions ? ToSize(header.Dimension(i)) : 1; };
  const auto some = [&](int i) { return std::max<Index>(size(i), 1); };
  const Index values = CountCells({ { some(5), some(6), some(7) } });
  if (values > 1)
  {
    throw InputError("it has " + std::to_string(values) +
      " values per point (a vector or a colour); one is required, a label or a volume fraction.");
  }
  return { size(1), size(2), size(3) };
}

/// Returns the number of images.
Index CountVolumes(const NiftiHeader& header)
{
  return header.Dimension(0) >= 4.0 ? std::max<Index>(ToSize(header.Dimension(4)), 1) : 1;
}

/// Axes of an image and the position of its first value.
struct Form
{
  std::array<Vector3, 3> Axes; ///< times the widths they are the steps from value to value
  Vector3 Origin;
};

/// Reads the qform.
Form ReadQuaternion(const NiftiHeader& header)
{
  const double b = header.Real(256, 352), c = header.Real(260, 360), d = header.Real(264, 368);
  const double a = std::sqrt(std::max(0.0, 1.0 - b * b - c * c - d * d));
  const double all = a * a + b * b + c * c + d * d;
  double rows[3][3] = { { a * a + b * b - c * c - d * d, 2.0 * (b * c - a * d),
                          2.0 * (b * d + a * c) },
    { 2.0 * (b * c + a * d), a * a + c * c - b * b - d * d, 2.0 * (c * d - a * b) },
    { 2.0 * (b * d - a * c), 2.0 * (c * d + a * b), a * a + d * d - b * b - c * c } };
  Form form;
  for (int i = 0; i < 3; ++i)
  {
    Vector3 row;
    for (int j = 0; j < 3; ++j)
    {
      constexpr double rounding = 0x1p-22; // rounding error of single precision
      row[j] = std::abs(rows[i][j] / all) < rounding ? 0.0 : rows[i][j] / all;
    }
    const double length = std::sqrt(Dot(row, row));
    for (int j = 0; j < 3; ++j)
    {
      form.Axes[j][i] = row[j] / length;
    }
    form.Origin[i] = header.Real(268 + 4 * i, 376 + 8 * i);
  }
  return form;
}

/// Reads the sform.
Form ReadMatrix(const NiftiHeader& header)
{
  Form form;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      form.Axes[j][i] = header.Real(280 + 16 * i, 400 + 32 * i, j) / header.Width(j + 1);
    }
    form.Origin[i] = header.Real(280 + 16 * i, 400 + 32 * i, 3);
  }
  return form;
}

/// Sets the place of an image. If the axes of the file are left-handed, the place is that of the
/// image with its slices in reverse order. Returns whether they are left-handed.
bool SetPlace(const NiftiHeader& header, ImagePlace& place)
{
  constexpr int sform = 0, qform = 1;
  std::optional<Form> forms[2];
  const double last = static_cast<double>(place.Size[2] - 1);
  bool isTurned = false;
  if (header.HasForm(252, 344))
  {
    Form& form = forms[qform].emplace(ReadQuaternion(header));
    isTurned = header.Width(0) < 0.0;
    form.Origin = isTurned ? form.Origin - header.Width(3) * last * form.Axes[2] : form.Origin;
  }
  if (header.HasForm(254, 348))
  {
    Form& form = forms[sform].emplace(ReadMatrix(header));
    const auto& axes = form.Axes;
    isTurned = forms[qform] ? isTurned : Dot(Cross(axes[0], axes[1]), axes[2]) < 0.0;
    if (isTurned)
    {
      form.Origin = form.Origin + header.Width(3) * last * form.Axes[2];
      form.Axes[2] = -1.0 * form.Axes[2];
    }
  }
  for (const std::optional<Form>& form : forms)
  {
    std::array<Vector3, 3> steps{};
    for (int a = 0; form && a < 3; ++a)
    {
      steps[a] = place.Spacing[a] * form->Axes[a];
    }
    if (form && AreAtRightAngles(steps))
    {
      SetSteps(steps, place);
      place.Origin = form->Origin;
      return isTurned;
    }
  }
  if (forms[sform] || forms[qform])
  {
    throw InputError("its sform is sheared: the axes of the image are not at right angles, and "
                     "there is no qform. Resample the image onto a grid of right angles.");
  }
  return isTurned;
}

/// Reverses the order of the slices.
void TurnSlices(TypedValues& values, Index slices)
{
  const Index slice = static_cast<Index>(values.Bytes.size()) / slices;
  char* bytes = values.Bytes.data();
  for (Index k = 0; k < slices / 2; ++k)
  {
    std::swap_ranges(bytes + k * slice, bytes + (k + 1) * slice, bytes + (slices - 1 - k) * slice);
  }
}

TypedValues Rescale(const TypedValues& stored, double slope, double intercept)
{
  const Index count = static_cast<Index>(stored.Bytes.size()) / WidthOfType(stored.Type);
  TypedValues values = MakeValues("", ValueType::Double, count);
  VisitType(stored.Type,
    [&](auto tag)
    {
      const auto* from = reinterpret_cast<const typename decltype(tag)::Type*>(stored.Bytes.data());
      double* to = reinterpret_cast<double*>(values.Bytes.data());
      for (Index i = 0; i < count; ++i)
      {
        to[i] = slope * static_cast<double>(from[i]) + intercept;
      }
    });
  return values;
}

} // namespace

ImageFile OpenNifti(const std::string& path, const ImageRequest& request)
{
  const NiftiHeader header(path);
  ImageFile image;
  image.Place.Size = FindSize(header);
  image.Place.Spacing = { header.Width(1), header.Width(2), header.Width(3) };
  StoredValues stored{ { path }, FindType(header) };
  stored.AreCompressed = header.IsPacked;
  stored.AreSwapped = header.IsSwapped;
  stored.Skip = header.CountSkipped();
  CheckPlace(image.Place);
  CheckFiles(stored, image.Place.Size);
  image.Volumes = CountVolumes(header);
  const Index volume = SelectVolume(request, image.Volumes, "times, or maps of several regions");
  const Index first = stored.Skip;
  stored.Skip += stored.CountBytes(image.Place.Size, volume);
  CheckFiles(stored, image.Place.Size);
  image.Names = ReadCaretNames(
    path, header.IsSecond ? Length2 : Length1, first, header.IsSwapped, volume, image.Warning);
  const bool isTurned = SetPlace(header, image.Place);
  double slope = header.Real(112, 176), intercept = header.Real(116, 184);
  if (slope == 0.0 || !std::isfinite(slope) || !std::isfinite(intercept)) // no scaling
  {
    slope = 1.0;
    intercept = 0.0;
  }
  image.Read = [=, size = image.Place.Size](const IndexBox& box)
  {
    IndexBox there = box;
    if (isTurned)
    {
      there.Lower[2] = size[2] - box.Upper[2];
      there.Upper[2] = size[2] - box.Lower[2];
    }
    TypedValues values = ReadStored(stored, size, there);
    if (isTurned)
    {
      TurnSlices(values, box.Size(2));
    }
    return slope == 1.0 && intercept == 0.0 ? std::move(values) : Rescale(values, slope, intercept);
  };
  return image;
}

} // namespace vfm
