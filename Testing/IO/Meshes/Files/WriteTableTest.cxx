/// Tables in parts of several ranks are written as one file.
#include "Meshes/Files/WriteTable.h"
#include "FileCases.h"
#include "FragmentDrops.h"
#include "Report/Fragments/FragmentTable.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr int Rows = 11;

/// Returns rows first to last - 1 of a table with texts that need quotes.
std::vector<FieldArray> RowsFrom(int first, int last)
{
  std::vector<int> ids;
  std::vector<double> volumes;
  std::vector<std::string> names;
  for (int row = first; row < last; ++row)
  {
    ids.push_back(row + 1);
    volumes.push_back(1.0 / (row + 1));
    names.push_back(row % 2 ? "a \"quoted\", name" : "plain");
  }
  return { { "Id", ids }, { "Volume, in cells", volumes }, { "Name", names } };
}

} // namespace

TEST(WriteTable, IsTheSameFileFromPartsOfRanks)
{
  const Folder folder;
  const std::string path = folder / "table.csv";
  Ranks alone;
  WriteTable(RowsFrom(0, Rows), path, alone);
  const std::string expected = ReadBytes(path);
  EXPECT_EQ(std::count(expected.begin(), expected.end(), '\n'), Rows + 1);
  EXPECT_EQ(expected.substr(0, expected.find('\n')), "Id,\"Volume, in cells\",Name");
  EXPECT_NE(expected.find("\n3,0.3333333333333333,plain\n"), std::string::npos);
  for (int count : { 2, 3, 8, 27 })
  {
    const std::string own = folder / ("table" + std::to_string(count) + ".csv");
    RunOnRanks(count,
      [&](ThreadRanks& ranks)
      {
        // Some ranks have no rows.
        const int first = Rows * ranks.Rank() / count, last = Rows * (ranks.Rank() + 1) / count;
        WriteTable(RowsFrom(first, last), own, ranks);
      });
    EXPECT_EQ(ReadBytes(own), expected) << count;
  }
}

TEST(WriteTable, HasTheBytesOfOneRankForFragmentsOfMany)
{
  const Folder folder;
  std::string expected;
  for (int count : { 1, 2, 3, 5, 8, 27 })
  {
    const std::string path = folder / ("fragments" + std::to_string(count) + ".csv");
    RunOnRanks(count,
      [&](ThreadRanks& ranks)
      {
        const Drops drops = MakeDrops(100, ranks.Rank(), count);
        WriteTable(MakeFragmentTable(ViewDrops(drops), { "density" }, ranks), path, ranks);
      });
    const std::string written = ReadBytes(path);
    expected = count == 1 ? written : expected;
    EXPECT_EQ(written, expected) << count;
  }
  EXPECT_EQ(std::count(expected.begin(), expected.end(), '\n'), 101);
}

TEST(WriteTable, FailsOnAllRanks)
{
  const Folder folder;
  RunOnRanks(3,
    [&](ThreadRanks& ranks)
    {
      EXPECT_THROW(WriteTable(RowsFrom(0, 1), folder / "none/table.csv", ranks), InputError);
      EXPECT_TRUE(ranks.Any(ranks.Rank() == 2)); // the ranks can be used again
    });
}
