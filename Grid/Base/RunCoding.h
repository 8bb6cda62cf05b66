/**
 * Run-length coding of sequences of integers. A code is a list of counts and numbers: a count n > 0
 * is followed by a number that is repeated n times, a count n < 0 by -n numbers.
 */
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vfm
{

/// Writes a code.
/// @tparam T  signed integer
template <class T>
class RunCoder
{
public:
  /// Adds the same number `count` times.
  void AddRun(T value, std::int64_t count)
  {
    while (count > 0)
    {
      const bool extends = !this->Items.empty() && this->Items[this->Last] > 0 &&
        this->Items[this->Last + 1] == value && this->Items[this->Last] < LongestRun;
      if (!extends)
      {
        this->Begin();
        this->Items.push_back(value);
      }
      const T part =
        static_cast<T>(std::min<std::int64_t>(count, LongestRun - this->Items[this->Last]));
      this->Items[this->Last] += part;
      count -= part;
    }
  }
  void Add(T value)
  {
    if (this->Items.empty() || this->Items[this->Last] > 0 ||
      this->Items[this->Last] <= -LongestRun)
    {
      this->Begin();
    }
    --this->Items[this->Last];
    this->Items.push_back(value);
  }
  const std::vector<T>& Coded() const { return this->Items; }

private:
  static constexpr T LongestRun = T(1) << 30;
  void Begin()
  {
    this->Last = this->Items.size();
    this->Items.push_back(0);
  }

  std::vector<T> Items;
  std::size_t Last = 0; // position of the last count
};

/// Reads a code.
template <class T>
class RunReader
{
public:
  explicit RunReader(std::vector<T> coded) : Items(std::move(coded)) {}

  /// Reads the next `count` numbers. Calls same(n, value) for runs and each(n, values) for other
  /// numbers in the order of the sequence.
  template <class Same, class Each>
  void Read(std::int64_t count, const Same& same, const Each& each)
  {
    while (count > 0)
    {
      T& left = this->Items[this->At];
      const T* values = this->Items.data() + this->At + 1;
      if (left > 0)
      {
        const T n = static_cast<T>(std::min<std::int64_t>(left, count));
        same(n, values[0]);
        left -= n;
        count -= n;
        this->At += left == 0 ? 2 : 0;
        continue;
      }
      const T n = static_cast<T>(std::min<std::int64_t>(-left, count));
      each(n, values);
      // The count of the remaining numbers replaces the last number that was read.
      const T rest = left + n;
      this->At += n;
      this->Items[this->At] = rest;
      count -= n;
      this->At += rest == 0 ? 1 : 0;
    }
  }

private:
  std::vector<T> Items;
  std::size_t At = 0; // position of the count that is being read
};

} // namespace vfm
