/**
 * ExactSum: a sum of doubles that does not depend on the order of the summands.
 */
#pragma once

#include "Ranks/Ranks.h"

#include <vector>

namespace vfm
{

/// Sum as a 128-bit integer in units of 2^-36. Each summand is truncated to this unit; the sum of
/// the truncated values is exact.
class ExactSum
{
public:
  void Add(double value) { this->Total += Rounded(value); }
  /// Adds a value `times` times.
  void Add(double value, std::int64_t times) { this->Total += Rounded(value) * times; }
  void Add(const ExactSum& other) { this->Total += other.Total; }
  void Subtract(const ExactSum& other) { this->Total -= other.Total; }
  double Value() const { return static_cast<double>(this->Total) / Unit; }

  /// High and Low return the sum as two integers of 64 bits. Their sums over fewer than 2^23 ranks
  /// are exact. Set converts them back.
  std::int64_t High() const { return static_cast<std::int64_t>(this->Total >> LowBits); }
  std::int64_t Low() const { return static_cast<std::int64_t>(this->Total & LowMask); }
  void Set(std::int64_t high, std::int64_t low)
  {
    this->Total = static_cast<Integer>(high) * (LowMask + 1) + low;
  }

private:
  __extension__ typedef __int128 Integer;
  static constexpr double Unit = 68719476736.0;
  static constexpr int LowBits = 40;
  static constexpr Integer LowMask = (static_cast<Integer>(1) << LowBits) - 1;
  static Integer Rounded(double value)
  {
    const double units = value * Unit;
    // Processors have an instruction that converts to 64 bits, none for 128 bits.
    const bool isShort = units > -0x1p62 && units < 0x1p62;
    return isShort ? static_cast<std::int64_t>(units) : static_cast<Integer>(units);
  }
  Integer Total = 0;
};

/// Returns the values of the sums over all ranks.
/// @pre Collective over `ranks`; the same number of sums on each rank.
inline std::vector<double> SumOverRanks(const std::vector<ExactSum>& sums, Ranks& ranks)
{
  std::vector<std::int64_t> parts;
  for (const ExactSum& sum : sums)
  {
    parts.push_back(sum.High());
    parts.push_back(sum.Low());
  }
  ranks.Sum(parts);
  std::vector<double> values;
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    ExactSum sum;
    sum.Set(parts[2 * i], parts[2 * i + 1]);
    values.push_back(sum.Value());
  }
  return values;
}

} // namespace vfm
