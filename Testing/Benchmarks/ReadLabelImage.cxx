#include "ReadLabelImage.h"

#include "Images/ImageFile.h"
#include "MeshChecks.h"

#include <set>

namespace vfm
{
namespace testing
{
namespace
{

std::vector<int> ConvertToLabels(const TypedValues& values)
{
  return VisitType(values.Type,
    [&](auto tag)
    {
      using T = typename decltype(tag)::Type;
      const T* first = reinterpret_cast<const T*>(values.Bytes.data());
      std::vector<int> labels;
      std::transform(first, first + values.Bytes.size() / sizeof(T), std::back_inserter(labels),
        [](T value) { return std::max(0, static_cast<int>(value)); });
      return labels;
    });
}

IndexBox CutMiddle(const IndexBox& box, Index cells)
{
  IndexBox cut = box;
  for (int a = 0; a < 3; ++a)
  {
    const Index size = cells > 0 ? std::min(cells, box.Upper[a]) : box.Upper[a];
    cut.Lower[a] = (box.Upper[a] - size) / 2;
    cut.Upper[a] = cut.Lower[a] + size;
  }
  return cut;
}

} // namespace

LabelImage ReadLabelImage(const std::string& path, Index cells)
{
  const ImageFile file = OpenImageFile(path);
  const IndexBox whole{ { { 0, 0, 0 } }, file.Place.Size }, box = CutMiddle(whole, cells);
  const bool readsBox = file.ReadsParts;
  const std::vector<int> values = ConvertToLabels(file.Read(readsBox ? box : whole));
  const std::set<int> all(values.begin(), values.end());
  std::vector<int> names{ 0 };
  std::copy(all.upper_bound(0), all.end(), std::back_inserter(names));
  CartesianGrid grid = MakeUnitGrid(
    box.Upper[0] - box.Lower[0], box.Upper[1] - box.Lower[1], box.Upper[2] - box.Lower[2]);
  const IndexBox& stored = readsBox ? box : whole;
  const auto labelAt = [&](const Index3& p)
  {
    const Index3 at{ { p[0] + box.Lower[0], p[1] + box.Lower[1], p[2] + box.Lower[2] } };
    const auto name = std::lower_bound(names.begin(), names.end(), values[IndexInBox(stored, at)]);
    return static_cast<int>(name - names.begin());
  };
  FractionField labels = MakeLabels(grid, static_cast<int>(names.size()) - 1, labelAt);
  return { std::move(grid), std::move(labels), std::move(names) };
}

} // namespace testing
} // namespace vfm
