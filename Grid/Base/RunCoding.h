/**
 * A sequence of numbers in another one, shorter where many in a row are alike: a count n > 0 and a number that comes n times,
 * or a count n < 0 and -n numbers.
 */
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vfm
{

/// T: a signed integer.
template <class T>
class RunCoder
{
public:
  /// Adds the same number several times.
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
  std::size_t Last = 0; // place of the last count
};

template <class T>
class RunReader
{
public:
  explicit RunReader(std::vector<T> coded) : Items(std::move(coded)) {}

  /// The next `count` numbers: calls same(n, value) and each(n, values) in their order.
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
      // what is left moves to its count
      const T rest = left + n;
      this->At += n;
      this->Items[this->At] = rest;
      count -= n;
      this->At += rest == 0 ? 1 : 0;
    }
  }

private:
  std::vector<T> Items;
  std::size_t At = 0; // of the count that is being read
};

} // namespace vfm
