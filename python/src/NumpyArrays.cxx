#include "NumpyArrays.h"

#include <cstdint>
#include <cstring>

namespace vfm
{
namespace
{

namespace nb = nanobind;

/// All in memory, so that nothing is asked for a value.
class PlainArray : public BlockArray
{
public:
  double Get(Index tuple, int component) const override
  {
    return VisitType(this->Type,
      [&](auto tag)
      {
        using Value = typename decltype(tag)::Type;
        const Index place = tuple * this->Components + component;
        return static_cast<double>(static_cast<const Value*>(this->Memory)[place]);
      });
  }
  void Copy(Index first, Index count, void* to) const override
  {
    VisitType(this->Type,
      [&](auto tag)
      {
        using Value = typename decltype(tag)::Type;
        std::memcpy(to, static_cast<const Value*>(this->Memory) + first * this->Components,
          count * this->Components * sizeof(Value));
      });
  }
};

/// Of ValueType.
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
    "' is of a type without numbers that can be read: whole numbers of 8 to 64 bits, float32 and "
    "float64 "
    "can.");
}

std::shared_ptr<const BlockArray> Describe(const std::string& name, const NumpyArray& values)
{
  auto array = std::make_shared<PlainArray>();
  array->Type = TypeOf(name, values);
  if (values.ndim() < 1 || values.ndim() > 2)
  {
    throw InputError("The array '" + name + "' has " + std::to_string(values.ndim()) +
      " dimensions: one value a cell, or a row of components, is needed.");
  }
  if (reinterpret_cast<std::uintptr_t>(values.data()) % values.itemsize() != 0)
  {
    throw InputError("The array '" + name + "' is not aligned in memory: copy it.");
  }
  array->Tuples = static_cast<Index>(values.shape(0));
  array->Components = values.ndim() == 2 ? static_cast<int>(values.shape(1)) : 1;
  array->Memory = values.data();
  return array;
}

} // namespace

NumpyArrays::NumpyArrays(
  Index cells, const std::vector<std::pair<std::string, NumpyArray>>& arrays) :
  Cells(cells)
{
  for (const auto& [name, values] : arrays)
  {
    this->Arrays.emplace_back(name, Describe(name, values));
  }
}

std::shared_ptr<const BlockArray> NumpyArrays::Find(const std::string& name) const
{
  for (const auto& [own, array] : this->Arrays)
  {
    if (own == name)
    {
      return array;
    }
  }
  return nullptr;
}

std::vector<std::string> NumpyArrays::Names() const
{
  std::vector<std::string> names;
  for (const auto& array : this->Arrays)
  {
    names.push_back(array.first);
  }
  return names;
}

} // namespace vfm
