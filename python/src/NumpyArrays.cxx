#include "NumpyArrays.h"

#include <cstdint>

namespace vfm
{
namespace
{

namespace nb = nanobind;

/// Returns the ValueType of an array.
int TypeOf(const std::string& name, const NumpyArray& values)
{
  const std::pair<nb::dlpack::dtype, int> types[] = { { nb::dtype<double>(), ValueType::Double },
    { nb::dtype<float>(), ValueType::Float }, { nb::dtype<std::int8_t>(), ValueType::SignedChar },
    { nb::dtype<std::uint8_t>(), ValueType::UnsignedChar },
    { nb::dtype<std::int16_t>(), ValueType::Short },
    { nb::dtype<std::uint16_t>(), ValueType::UnsignedShort },
    { nb::dtype<std::int32_t>(), ValueType::Int },
    { nb::dtype<std::uint32_t>(), ValueType::UnsignedInt },
    { nb::dtype<std::int64_t>(), ValueType::LongLong },
    { nb::dtype<std::uint64_t>(), ValueType::UnsignedLongLong } };
  for (const auto& [type, number] : types)
  {
    if (type == values.dtype())
    {
      return number;
    }
  }
  throw InputError("The array '" + name +
    "' has an unsupported type. Supported types: integers of 8 to 64 bits, float32 and float64.");
}

} // namespace

NumpyView::NumpyView(const std::string& name, const NumpyArray& values) :
  Type(TypeOf(name, values)),
  Components(values.ndim() == 2 ? static_cast<int>(values.shape(1)) : 1),
  Rows(values.ndim() > 0 ? static_cast<Index>(values.shape(0)) : 0),
  Values(values.data())
{
  if (values.ndim() < 1 || values.ndim() > 2)
  {
    throw InputError("The array '" + name + "' has " + std::to_string(values.ndim()) +
      " dimensions: one value per cell, or one row of components per cell, is needed.");
  }
  if (reinterpret_cast<std::uintptr_t>(values.data()) % values.itemsize() != 0)
  {
    throw InputError("The array '" + name + "' is not aligned in memory: copy it.");
  }
}

std::shared_ptr<const BlockArrays> MakeBlockArrays(
  Index cells, const std::vector<std::pair<std::string, NumpyArray>>& arrays)
{
  auto block = std::make_shared<PlainArrays>(cells);
  for (const auto& [name, values] : arrays)
  {
    const NumpyView view(name, values);
    block->Add(name, view.Type, view.Rows, view.Components, view.Values);
  }
  return block;
}

} // namespace vfm
