#include "Smoothing/CodedPoints.h"

#include <cstring>

namespace vfm
{
namespace
{

/// Numbers the distinct values along an axis, by their bits.
class ValueNumbers
{
public:
  explicit ValueNumbers(std::vector<double>& values) : Values(values) {}

  /// Returns the number of a value, or MaximumValues if there are too many values.
  std::size_t Of(double value)
  {
    if (2 * this->Values.size() >= this->Slots.size())
    {
      this->Grow();
    }
    const std::size_t slot = this->Find(value);
    if (this->Slots[slot] == Free)
    {
      if (this->Values.size() == CodedPoints::MaximumValues)
      {
        return CodedPoints::MaximumValues;
      }
      this->Slots[slot] = static_cast<std::uint32_t>(this->Values.size());
      this->Values.push_back(value);
    }
    return this->Slots[slot];
  }

private:
  static constexpr std::uint32_t Free = 0xffffffff;
  static constexpr unsigned LeastBits = 8;

  static std::uint64_t BitsOf(double value)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    return bits;
  }

  /// Returns the slot of a value, or where it is to be stored.
  std::size_t Find(double value) const
  {
    const std::uint64_t bits = BitsOf(value);
    std::size_t slot = (bits * 0x9e3779b97f4a7c15u) >> (64 - this->Bits);
    while (this->Slots[slot] != Free && BitsOf(this->Values[this->Slots[slot]]) != bits)
    {
      slot = (slot + 1) & (this->Slots.size() - 1);
    }
    return slot;
  }

  void Grow()
  {
    this->Bits = this->Slots.empty() ? LeastBits : this->Bits + 1;
    this->Slots.assign(std::size_t(1) << this->Bits, Free);
    for (std::size_t v = 0; v < this->Values.size(); ++v)
    {
      this->Slots[this->Find(this->Values[v])] = static_cast<std::uint32_t>(v);
    }
  }

  std::vector<double>& Values;
  std::vector<std::uint32_t> Slots; // hash table: numbers of values, at most half of them used
  unsigned Bits = 0;                // logarithm of the number of slots
};

} // namespace

CodedPoints::CodedPoints(const double* points, const std::vector<int>& list)
{
  std::array<ValueNumbers, 3> numbers{ ValueNumbers(this->Values[0]), ValueNumbers(this->Values[1]),
    ValueNumbers(this->Values[2]) };
  this->Codes.reserve(list.size());
  for (int point : list)
  {
    Code code;
    for (int a = 0; a < 3; ++a)
    {
      const std::size_t number = numbers[a].Of(points[3 * static_cast<Index>(point) + a]);
      if (number == MaximumValues)
      {
        std::vector<Code>().swap(this->Codes);
        return;
      }
      code[a] = static_cast<std::uint16_t>(number);
    }
    this->Codes.push_back(code);
  }
}

} // namespace vfm
