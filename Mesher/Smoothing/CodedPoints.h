/**
 * CodedPoints: points in six bytes each. Points at which a mesh starts are at few different places
 * along each axis: at nodes of the grid and a fixed distance beside them.
 */
#pragma once

#include "Base/IndexBox.h"

#include <cstdint>
#include <vector>

namespace vfm
{

/// Points as numbers of the distinct values of their coordinates. Thread safe once made.
class CodedPoints
{
public:
  /// Largest number of distinct values along an axis.
  static constexpr std::size_t MaximumValues = 65536;

  /// Holds no points.
  CodedPoints() = default;
  /// Holds points if their coordinates have few enough values; otherwise it is empty.
  /// @param points  coordinates, three per point
  /// @param list  numbers of the points to be held, in their order here
  CodedPoints(const double* points, const std::vector<int>& list);

  bool IsEmpty() const { return this->Codes.empty(); }
  std::size_t Count() const { return this->Codes.size(); }

  /// Returns a point as it was given, to the last bit.
  Vector3 At(std::size_t point) const { return this->Select(this->Values, point); }
  /// Returns a point with the coordinates of Convert.
  Vector3 ConvertedAt(std::size_t point) const { return this->Select(this->Converted, point); }
  /// Begins to load a point.
  void Prefetch(std::size_t point) const { __builtin_prefetch(this->Codes.data() + point); }
  /// Converts the coordinates x along each axis by convert(axis, x).
  template <class Function>
  void Convert(const Function& convert)
  {
    this->Converted = this->Values;
    for (int a = 0; a < 3; ++a)
    {
      for (double& x : this->Converted[a])
      {
        x = convert(a, x);
      }
    }
  }

private:
  using Code = std::array<std::uint16_t, 3>;
  using Table = std::array<std::vector<double>, 3>;

  Vector3 Select(const Table& values, std::size_t point) const
  {
    const Code& code = this->Codes[point];
    return { { values[0][code[0]], values[1][code[1]], values[2][code[2]] } };
  }

  std::vector<Code> Codes;
  Table Values, Converted;
};

} // namespace vfm
