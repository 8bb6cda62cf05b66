/**
 * ExactSum: a sum of doubles that does not depend on the order of the summands.
 */
#pragma once

#include "Ranks/Ranks.h"

#include <array>
#include <cmath>
#include <vector>

namespace vfm
{

/// Sum as a 128-bit integer in units of 2^-70. Each summand is rounded to this unit; the sum of the
/// rounded values is exact. Its magnitude must be below 2^57.
class ExactSum
{
public:
  static constexpr int NumberOfParts = 3;
  using PartArray = std::array<std::int64_t, NumberOfParts>;

  void Add(double value) { this->Total += Rounded(value); }
  /// Adds a value `times` times.
  void Add(double value, std::int64_t times) { this->Total += Rounded(value) * times; }
  void Add(const ExactSum& other) { this->Total += other.Total; }
  void Subtract(const ExactSum& other) { this->Total -= other.Total; }
  double Value() const { return static_cast<double>(this->Total) / (Coarse * FineUnits); }

  /// Returns the sum as integers, highest bits first. Their sums over fewer than 2^23 ranks are
  /// exact. Set converts them back.
  PartArray Parts() const
  {
    return { { static_cast<std::int64_t>(this->Total >> 2 * PartBits),
      static_cast<std::int64_t>(this->Total >> PartBits & PartMask),
      static_cast<std::int64_t>(this->Total & PartMask) } };
  }
  void Set(const std::int64_t* parts)
  {
    this->Total = 0;
    for (int i = 0; i < NumberOfParts; ++i)
    {
      this->Total = this->Total * (PartMask + 1) + parts[i];
    }
  }

private:
  __extension__ typedef __int128 Integer;
  static constexpr double Coarse = 0x1p20;                         // coarse units of 1
  static constexpr std::int64_t FineUnits = std::int64_t(1) << 50; // units of a coarse unit
  static constexpr int PartBits = 40;
  static constexpr Integer PartMask = (static_cast<Integer>(1) << PartBits) - 1;
  static Integer Rounded(double value)
  {
    const double coarse = value * Coarse;
    if (std::fabs(coarse) >= 0x1p62)
    {
      return static_cast<Integer>(coarse) * FineUnits; // has no fraction
    }
    // Processors have an instruction that converts to 64 bits, none for 128 bits.
    const auto high = static_cast<std::int64_t>(coarse);
    const double fine = (coarse - static_cast<double>(high)) * FineUnits;
    const auto low = static_cast<std::int64_t>(fine + std::copysign(0.5, fine));
    return static_cast<Integer>(high) * FineUnits + low;
  }
  Integer Total = 0;
};

/// Returns the values of sums.
inline std::vector<double> ValuesOf(const std::vector<ExactSum>& sums)
{
  std::vector<double> values;
  values.reserve(sums.size());
  for (const ExactSum& sum : sums)
  {
    values.push_back(sum.Value());
  }
  return values;
}

/// Returns the values of the sums over all ranks.
/// @pre Collective over `ranks`; the same number of sums on each rank.
inline std::vector<double> SumOverRanks(const std::vector<ExactSum>& sums, Ranks& ranks)
{
  std::vector<std::int64_t> parts;
  for (const ExactSum& sum : sums)
  {
    const ExactSum::PartArray mine = sum.Parts();
    parts.insert(parts.end(), mine.begin(), mine.end());
  }
  ranks.Sum(parts);
  std::vector<double> values;
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    ExactSum sum;
    sum.Set(parts.data() + ExactSum::NumberOfParts * i);
    values.push_back(sum.Value());
  }
  return values;
}

} // namespace vfm
