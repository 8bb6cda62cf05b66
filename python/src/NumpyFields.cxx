#include "NumpyFields.h"

#include <algorithm>
#include <type_traits>

namespace vfm
{
namespace
{

namespace nb = nanobind;

/// A type that numpy supports.
template <class T>
using PlainType = std::conditional_t<std::is_same<T, char>::value, signed char, T>;

nb::object ToPython(const std::vector<std::string>& texts, int)
{
  nb::list list;
  for (const std::string& text : texts)
  {
    list.append(nb::str(text.c_str(), text.size()));
  }
  return list;
}

template <class T>
nb::object ToPython(const std::vector<T>& values, int components)
{
  Buffer<T> copy(values.size());
  std::copy(values.begin(), values.end(), copy.begin());
  return ToNumpy(copy, components > 1 ? components : 0);
}

} // namespace

nb::object ToNumpy(TransferredArray& array)
{
  const int columns = array.Components == 1 ? 0 : array.Components;
  return VisitType(array.Type,
    [&](auto tag)
    {
      using Value = PlainType<typename decltype(tag)::Type>;
      const std::size_t size = array.Values.size() / sizeof(Value);
      auto values = Buffer<Value>::From(reinterpret_cast<Value*>(array.Values.release()), size);
      return ToNumpy(values, columns);
    });
}

nb::dict ToDict(const FieldArrays& fields)
{
  nb::dict dict;
  for (const FieldArray& field : fields)
  {
    dict[field.Name.c_str()] = std::visit(
      [&field](const auto& values) { return ToPython(values, field.Components); }, field.Values);
  }
  return dict;
}

} // namespace vfm
