/**
 * NetcdfLayout: the contents of a netCDF file, described before the file is written.
 */
#pragma once

#include "Base/IndexBox.h"

#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace vfm
{

enum class NetcdfKind
{
  Text,
  Int,     ///< 32 bits
  WideInt, ///< 64 bits
  Real     ///< 64 bits
};

/// Characters of Text, numbers of Int and WideInt, numbers of Real; the last dimension varies fastest.
using NetcdfValues = std::variant<std::string, std::vector<Index>, std::vector<double>>;

struct NetcdfDimension
{
  std::string Name;
  Index Length; ///< 0: the unlimited dimension, of length 1
};

struct NetcdfText
{
  std::string Name, Value;
};

struct NetcdfVariable
{
  std::string Name;
  NetcdfKind Kind;
  std::vector<std::size_t> Dimensions;  ///< places in the layout; only the first may be unlimited
  std::function<NetcdfValues()> Values; ///< called once, when the values are written
  std::vector<NetcdfText> Attributes;
};

struct NetcdfLayout
{
  /// @return its place.
  std::size_t AddDimension(std::string name, Index length)
  {
    this->Dimensions.push_back({ std::move(name), length });
    return this->Dimensions.size() - 1;
  }

  std::vector<NetcdfDimension> Dimensions;
  std::vector<NetcdfVariable> Variables;
  std::vector<std::pair<std::string, std::variant<std::string, int, float>>> Attributes;
};

} // namespace vfm
