/// Arrays in little memory compared with plain vectors.
#include "Base/RunCoding.h"
#include "Fractions/FractionField.h"
#include "Labels/Labels.h"
#include "MeshChecks.h"

#include <gtest/gtest.h>

#include <random>
#include <thread>

using namespace vfm;
using namespace vfm::testing;

namespace
{

template <class T>
std::vector<T> ValuesOf(const PagedArray<T>& array, const CartesianGrid& grid)
{
  std::vector<T> values;
  for (Index n = 0; n < grid.NumberOfEntries(); ++n)
  {
    values.push_back(array[n]);
  }
  return values;
}

/// Returns the same values, read by Visit row by row.
template <class T>
std::vector<T> VisitAll(const PagedArray<T>& array, const CartesianGrid& grid)
{
  std::vector<T> values;
  for (Index row = 0; row < grid.NumberOfEntries(); row += grid.Stride(1))
  {
    array.Visit(
      row, row + grid.Stride(1),
      [&](Index begin, Index end, T value)
      {
        EXPECT_EQ(begin, static_cast<Index>(values.size()));
        values.insert(values.end(), end - begin, value);
      },
      [&](Index begin, Index end, const T* own)
      {
        EXPECT_EQ(begin, static_cast<Index>(values.size()));
        values.insert(values.end(), own, own + (end - begin));
      });
  }
  return values;
}

/// Applies the same random changes to an array and to a vector.
template <class T>
void CompareWithVector(const CartesianGrid& grid, unsigned seed)
{
  std::mt19937 engine(seed);
  PagedArray<T> array(grid, 3);
  std::vector<T> plain(grid.NumberOfEntries(), 3);
  const Index length = grid.Stride(1), rows = grid.NumberOfEntries() / length;
  for (int change = 0; change < 400; ++change)
  {
    const Index row = engine() % rows * length;
    Index first = row + engine() % length, last = row + engine() % (length + 1);
    std::tie(first, last) = std::make_pair(std::min(first, last), std::max(first, last));
    const T value = static_cast<T>(engine() % 3);
    switch (engine() % 5)
    {
      case 0:
        array.Set(first, value);
        plain[first] = value;
        break;
      case 1:
        array.Fill(first, last, value);
        std::fill(plain.begin() + first, plain.begin() + last, value);
        break;
      case 2:
        array.Fill(row, row + length, value);
        std::fill_n(plain.begin() + row, length, value);
        break;
      case 3:
      {
        std::vector<T> values(last - first);
        std::generate(
          values.begin(), values.end(), [&] { return static_cast<T>(engine() % 7 / 5); });
        array.Write(first, last, values.data());
        std::copy(values.begin(), values.end(), plain.begin() + first);
        break;
      }
      default:
      {
        const Index from = engine() % rows * length;
        array.CopyRow(from + length / 2, first);
        const std::vector<T> copied(plain.begin() + from, plain.begin() + from + length);
        std::copy(copied.begin(), copied.end(), plain.begin() + row);
      }
    }
    ASSERT_EQ(ValuesOf(array, grid), plain) << "change " << change << ", seed " << seed;
  }
  EXPECT_EQ(VisitAll(array, grid), plain);
  const PagedArray<T> copy = array;
  for (Index n = 0; n < grid.NumberOfEntries(); ++n)
  {
    array.Set(n, 9);
  }
  EXPECT_EQ(ValuesOf(copy, grid), plain);
  EXPECT_EQ(ValuesOf(array, grid), std::vector<T>(plain.size(), 9));
  const PagedArray<T> moved = std::move(array);
  EXPECT_EQ(VisitAll(moved, grid), std::vector<T>(plain.size(), 9));
}

} // namespace

TEST(PagedArray, HoldsWhatAVectorHolds)
{
  unsigned seed = 0;
  for (Index nx : { 1, 29, 30, 31, 62, 63, 100 })
  {
    const CartesianGrid grid = MakeUnitGrid(nx, 2, 3);
    CompareWithVector<int>(grid, ++seed);
    CompareWithVector<Index>(grid, ++seed);
    CompareWithVector<unsigned char>(grid, ++seed);
  }
}

TEST(PagedArray, StoresEqualValuesOnce)
{
  const CartesianGrid grid = MakeUnitGrid(254, 40, 40);
  const std::size_t dense = grid.NumberOfEntries() * sizeof(int);
  PagedArray<int> array(grid, 0);
  EXPECT_LT(array.MemoryInBytes(), dense / 50);
  const Index length = grid.Stride(1);
  const auto isUniform = [&](Index row) { return array.Row(row * length).IsUniform(); };
  EXPECT_TRUE(isUniform(5));
  array.Set(5 * length + 70, 1);
  EXPECT_FALSE(isUniform(5));
  EXPECT_TRUE(isUniform(4) && isUniform(6));
  EXPECT_TRUE(array.Row(5 * length).IsUniform(1) && array.Row(5 * length).IsUniform(3));
  EXPECT_FALSE(array.Row(5 * length).IsUniform(2));
  array.Fill(5 * length + 64, 5 * length + 90, 0); // overwrites the last entry of another value
  EXPECT_TRUE(isUniform(5));
  // in parts, as data arrive in blocks
  for (Index row = 0; row < grid.NumberOfEntries() / length; ++row)
  {
    for (Index i = 0; i < length; i += 16)
    {
      const std::vector<int> values(16, 4);
      array.Write(row * length + i, row * length + i + 16, values.data());
    }
    ASSERT_TRUE(isUniform(row));
  }
  EXPECT_LT(array.MemoryInBytes(), dense / 50);
  // one by one
  for (Index n = 0; n < grid.NumberOfEntries(); ++n)
  {
    array.Set(n, 6);
  }
  EXPECT_TRUE(isUniform(0) && isUniform(100));
  EXPECT_LT(array.MemoryInBytes(), dense / 50);
}

TEST(PagedArray, CostsLittleMoreThanAPlainArrayAtWorst)
{
  const CartesianGrid grid = MakeUnitGrid(254, 60, 60);
  PagedArray<int> array(grid, 0);
  for (Index n = 0; n < grid.NumberOfEntries(); ++n)
  {
    array.Set(n, static_cast<int>(n));
  }
  // The array adds one pointer per page, one per row, and at most one unused block.
  const std::size_t dense = grid.NumberOfEntries() * sizeof(int);
  EXPECT_LT(array.MemoryInBytes(), dense + dense / 8 + (std::size_t(1) << 22));
}

TEST(PagedArray, TakesRowsFromSeveralThreads)
{
  const CartesianGrid grid = MakeUnitGrid(40, 30, 30);
  PagedArray<int> array(grid, 0);
  const Index length = grid.Stride(1), rows = grid.NumberOfEntries() / length;
  const auto value = [&](Index n) { return static_cast<int>(n % 7 * (n / length % 3)); };
  std::vector<std::thread> threads;
  for (Index t = 0; t < 4; ++t)
  {
    threads.emplace_back(
      [&, t]
      {
        for (Index row = t; row < rows; row += 4)
        {
          array.Fill(row * length, row * length + 20, 5);
          for (Index n = row * length; n < (row + 1) * length; ++n)
          {
            array.Set(n, value(n));
          }
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (Index n = 0; n < grid.NumberOfEntries(); ++n)
  {
    ASSERT_EQ(array[n], value(n));
  }
}

TEST(RunCoding, GivesBackWhatCameIn)
{
  std::mt19937 engine(1);
  for (int round = 0; round < 200; ++round)
  {
    RunCoder<int> coder;
    std::vector<int> plain;
    while (plain.size() < 300)
    {
      const int value = static_cast<int>(engine() % 4) - 2;
      const std::int64_t count = engine() % 3 ? 1 : engine() % 40;
      count == 1 ? coder.Add(value) : coder.AddRun(value, count);
      plain.insert(plain.end(), count, value);
    }
    RunReader<int> reader(coder.Coded());
    std::vector<int> read;
    while (read.size() < plain.size())
    {
      const std::size_t count = std::min<std::size_t>(engine() % 30, plain.size() - read.size());
      const std::size_t before = read.size();
      reader.Read(
        static_cast<std::int64_t>(count),
        [&](int n, int value) { read.insert(read.end(), n, value); },
        [&](int n, const int* values) { read.insert(read.end(), values, values + n); });
      ASSERT_EQ(read.size(), before + count);
    }
    ASSERT_EQ(read, plain);
  }
  RunCoder<int> runs;
  runs.AddRun(7, 1000);
  runs.AddRun(7, std::int64_t(1) << 32);
  EXPECT_LT(runs.Coded().size(), 20u);
}

TEST(Labels, MirrorTheRimOfTheBox)
{
  for (Index nx : { 1, 30, 31, 33, 70 })
  {
    const CartesianGrid grid = MakeUnitGrid(nx, 5, 4);
    const LabelArray labels = AssignMaterials(grid, MakeRandomLabels(grid, 3, 0, 5), 0.5);
    const IndexBox& box = grid.Local();
    for (Index k = -1; k <= 4; ++k)
    {
      for (Index j = -1; j <= 5; ++j)
      {
        for (Index i = -1; i <= nx; ++i)
        {
          Index3 inside{ { i, j, k } };
          for (int a = 0; a < 3; ++a)
          {
            inside[a] = std::min(std::max<Index>(inside[a], 0), box.Upper[a] - 1);
          }
          ASSERT_EQ(labels[grid.Linear({ { i, j, k } })], labels[grid.Linear(inside)]);
        }
      }
    }
  }
}

TEST(Labels, FindsMixedNodes)
{
  for (Index nx : { 1, 30, 31, 33, 70 })
  {
    const CartesianGrid grid = MakeUnitGrid(nx, 6, 5);
    std::mt19937 engine(static_cast<unsigned>(nx));
    // blocks of one label contain some uniform pages
    const LabelArray labels = AssignMaterials(grid,
      MakeLabels(grid, 2,
        [&](const Index3& p) { return p[1] < 3 ? (p[0] > 32) + (p[2] > 1) : engine() % 40 == 0; }),
      0.5);
    std::vector<Index> expected;
    for (Index n = 0; n < grid.NumberOfEntries(); ++n)
    {
      const Index3 p = grid.Position(n);
      if (p[0] >= 0 && p[1] >= 0 && p[2] >= 0)
      {
        const std::array<int, 8> star = StarOfNode(grid, labels, n);
        if (std::any_of(star.begin(), star.end(), [&](int label) { return label != star[0]; }))
        {
          expected.push_back(n);
        }
      }
    }
    EXPECT_EQ(FindMixedNodes(grid, labels), expected);
    EXPECT_FALSE(expected.empty());
  }
}
