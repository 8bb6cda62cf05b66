/**
 * NetcdfLayout: describes the contents of a netCDF file.
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

/// Values of a variable: characters of Text, integers of Int and WideInt, or numbers of Real. The
/// last dimension varies fastest.
using NetcdfValues = std::variant<std::string, std::vector<Index>, std::vector<double>>;

/// Receives consecutive values of a variable.
using PutValues = std::function<void(NetcdfValues values)>;
/// Puts all numbers of a variable, part by part.
using NetcdfParts = std::function<void(const PutValues& put)>;

struct NetcdfDimension
{
  std::string Name;
  Index Length; ///< length; 0 for the unlimited dimension, which has length 1
};

/// Attribute of a variable.
struct NetcdfText
{
  std::string Name, Value;
};

struct NetcdfVariable
{
  std::string Name;
  NetcdfKind Kind;
  std::vector<std::size_t> Dimensions;  ///< indices in the layout; only the first may be unlimited
  std::function<NetcdfValues()> Values; ///< function that is called once, to write the values
  std::vector<NetcdfText> Attributes;
  NetcdfParts Parts{}; ///< used instead of Values if set; parts end at ends of the last dimension

  void Put(const PutValues& put) const { this->Parts ? this->Parts(put) : put(this->Values()); }
};

/// Dimensions, variables and attributes of a file, in the order of the file.
struct NetcdfLayout
{
  /// Appends a dimension and returns its index.
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
