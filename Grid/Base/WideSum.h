/**
 * WideSum: a sum of doubles of any size that does not depend on their order, exact until its value is taken.
 */
#pragma once

#include "Ranks/Ranks.h"

#include <array>
#include <cmath>

namespace vfm
{

/// All bits that doubles have, in digits of 32: each number is added to three of them.
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
    const std::uint64_t place = exponent - (exponent > 0); // of the last bit, above 2^-1074
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

  /// Not a number when one of the summands was none or infinite.
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

  /// Makes each the sum over all ranks. Collective.
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
  static constexpr int MaximumAtOnce = 1 << 28; // so that no digit leaves 63 bits

  /// Leaves 32 bits in each digit, the sign in the last.
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
