/**
 * WideSum: a sum of doubles of any magnitude that does not depend on the order of the summands.
 */
#pragma once

#include "Ranks/Ranks.h"

#include <array>
#include <cmath>

namespace vfm
{

/// Exact sum. It stores all bits that doubles can have in digits of 32 bits. Each summand is added
/// to three digits. Only Value rounds.
class WideSum
{
public:
  void Add(double value)
  {
    if (!std::isfinite(value))
    {
      ++this->NotFinite;
      return;
    }
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    const std::uint64_t exponent = bits >> 52 & 0x7ff;
    const std::uint64_t mantissa =
      (bits & 0xfffffffffffffULL) | static_cast<std::uint64_t>(exponent > 0) << 52;
    // Position of the last bit, whose value is 2^(place - 1074).
    const std::uint64_t place = exponent - (exponent > 0);
    const std::uint64_t low = (mantissa & Mask) << place % 32,
                        high = (mantissa >> 32) << place % 32;
    const std::int64_t sign = bits >> 63 ? -1 : 1;
    std::int64_t* digit = this->Digits.data() + place / 32;
    digit[0] += sign * static_cast<std::int64_t>(low & Mask);
    digit[1] += sign * static_cast<std::int64_t>((low >> 32) + (high & Mask));
    digit[2] += sign * static_cast<std::int64_t>(high >> 32);
    if (++this->Count == MaximumAtOnce)
    {
      this->Carry();
    }
  }

  /// Returns the sum, or NaN if a summand was infinite or NaN.
  double Value() const
  {
    WideSum sum = *this;
    sum.Carry();
    const bool isNegative = sum.Digits.back() < 0;
    for (std::int64_t& digit : sum.Digits)
    {
      digit = isNegative ? -digit : digit;
    }
    sum.Carry();
    double value = this->NotFinite > 0 ? std::nan("") : 0.0;
    for (int d = 0; d < Length; ++d)
    {
      value += std::ldexp(static_cast<double>(sum.Digits[d]), 32 * d - 1074);
    }
    return isNegative ? -value : value;
  }

  /// Replaces each sum by its sum over all ranks.
  /// @pre Collective over `ranks`; the same number of sums on each rank.
  static void SumOverRanks(std::vector<WideSum>& sums, Ranks& ranks)
  {
    std::vector<std::int64_t> parts;
    for (WideSum& sum : sums)
    {
      sum.Carry();
      parts.insert(parts.end(), sum.Digits.begin(), sum.Digits.end());
      parts.push_back(sum.NotFinite);
    }
    ranks.Sum(parts);
    const std::int64_t* part = parts.data();
    for (WideSum& sum : sums)
    {
      std::copy_n(part, Length, sum.Digits.begin());
      sum.NotFinite = part[Length];
      part += Length + 1;
    }
  }

private:
  static constexpr int Length = 68;
  static constexpr std::uint64_t Mask = 0xffffffffULL;
  static constexpr int MaximumAtOnce = 1 << 28; // limit at which digits still fit in 63 bits

  /// Reduces each digit to 32 bits by carrying into the next; the last digit keeps the sign.
  void Carry()
  {
    for (int d = 0; d + 1 < Length; ++d)
    {
      const std::int64_t over = this->Digits[d] >> 32;
      this->Digits[d] -= over * (std::int64_t(1) << 32);
      this->Digits[d + 1] += over;
    }
    this->Count = 0;
  }

  std::array<std::int64_t, Length> Digits{};
  std::int64_t NotFinite = 0;
  int Count = 0;
};

} // namespace vfm
