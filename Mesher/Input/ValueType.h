/**
 * ValueType: the numeric types of input arrays, with the numbers of VTK.
 */
#pragma once

#include "Ranks/Errors.h"

#include <cstdint>
#include <cstring>

namespace vfm
{

namespace ValueType
{
constexpr int Bit = 1, Char = 2, UnsignedChar = 3, Short = 4, UnsignedShort = 5, Int = 6,
              UnsignedInt = 7, Long = 8, UnsignedLong = 9, Float = 10, Double = 11, Id = 12,
              SignedChar = 15, LongLong = 16, UnsignedLongLong = 17;
}

inline bool IsRealType(int type)
{
  return type == ValueType::Float || type == ValueType::Double;
}

/// Passes a C++ type as an argument.
template <class T>
struct TypeTag
{
  using Type = T;
};

/// Calls visit(TypeTag<T>) with the C++ type of the numbers of a type.
/// @throws InputError if the type is Bit or not numeric
template <class Visit>
auto VisitType(int type, const Visit& visit)
{
  switch (type)
  {
    case ValueType::Char:
      return visit(TypeTag<char>());
    case ValueType::UnsignedChar:
      return visit(TypeTag<unsigned char>());
    case ValueType::Short:
      return visit(TypeTag<short>());
    case ValueType::UnsignedShort:
      return visit(TypeTag<unsigned short>());
    case ValueType::Int:
      return visit(TypeTag<int>());
    case ValueType::UnsignedInt:
      return visit(TypeTag<unsigned int>());
    case ValueType::Long:
      return visit(TypeTag<long>());
    case ValueType::UnsignedLong:
      return visit(TypeTag<unsigned long>());
    case ValueType::Float:
      return visit(TypeTag<float>());
    case ValueType::Double:
      return visit(TypeTag<double>());
    case ValueType::Id:
      return visit(TypeTag<std::int64_t>());
    case ValueType::SignedChar:
      return visit(TypeTag<signed char>());
    case ValueType::LongLong:
      return visit(TypeTag<long long>());
    case ValueType::UnsignedLongLong:
      return visit(TypeTag<unsigned long long>());
    default:
      throw InputError("The type of a state array is not numeric.");
  }
}

/// Returns the size of a number in bytes.
inline std::int64_t WidthOfType(int type)
{
  return VisitType(
    type, [](auto tag) { return static_cast<std::int64_t>(sizeof(typename decltype(tag)::Type)); });
}

/// Returns the name of a type for messages.
inline const char* NameOfType(int type)
{
  const char* const names[] = { "void", "bit", "char", "unsigned char", "short", "unsigned short",
    "int", "unsigned int", "long", "unsigned long", "float", "double", "idtype", "string", "opaque",
    "signed char", "long long", "unsigned long long" };
  const bool isKnown = type >= 0 && type < static_cast<int>(sizeof(names) / sizeof(names[0]));
  return isKnown ? names[type] : "unknown";
}

} // namespace vfm
