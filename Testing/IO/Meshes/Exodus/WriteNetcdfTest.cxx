/// NetCDF files, byte by byte.
#include "Meshes/Exodus/WriteNetcdf.h"
#include "FileCases.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <numeric>
#include <type_traits>
#include <utility>

using namespace vfm;

namespace
{

NetcdfLayout MakeLayout()
{
  NetcdfLayout layout;
  const std::size_t time = layout.AddDimension("t", 0), three = layout.AddDimension("three", 3);
  layout.Attributes = { { "a", std::string("hello") }, { "i", 7 }, { "f", 0.5f } };
  layout.Variables = { { "v", NetcdfKind::Real, { time, three },
                         [] {
                           return std::vector<double>{ 1.0, -2.0, 0.25 };
                         },
                         {} },
    { "n", NetcdfKind::Int, { three },
      [] {
        return std::vector<Index>{ 1, -1, 258 };
      },
      { { "u", "m" } } },
    { "c", NetcdfKind::Text, { three }, [] { return std::string("abc"); }, {} } };
  return layout;
}

/// Returns a layout with numbers that are put at once or in three parts.
NetcdfLayout MakeLayout(bool inParts)
{
  NetcdfLayout layout;
  const std::size_t time = layout.AddDimension("t", 0), rows = layout.AddDimension("rows", 1000),
                    four = layout.AddDimension("four", 4);
  std::vector<double> reals(1000);
  std::vector<Index> integers(4000);
  std::iota(reals.begin(), reals.end(), 0.5);
  std::iota(integers.begin(), integers.end(), -7);
  layout.Variables = { { "v", NetcdfKind::Real, { time, rows }, [reals] { return reals; }, {} },
    { "n", NetcdfKind::Int, { rows, four }, [integers] { return integers; }, {} },
    { "x", NetcdfKind::Real, { rows }, [reals] { return reals; }, {} } };
  for (NetcdfVariable& variable : layout.Variables)
  {
    if (inParts)
    {
      variable.Parts = [values = std::exchange(variable.Values, nullptr)](const PutValues& put)
      {
        std::visit(
          [&put](const auto& list)
          {
            using List = std::decay_t<decltype(list)>;
            if constexpr (!std::is_same_v<List, std::string>)
            {
              const auto first = list.begin() + 400, second = list.begin() + 404;
              put(List(list.begin(), first));
              put(List(first, second));
              put(List(second, list.end()));
            }
          },
          values());
      };
    }
  }
  return layout;
}

std::string Write(const NetcdfLayout& layout, NetcdfFormat format)
{
  const vfm::testing::Folder folder;
  const std::string path = folder / "case.nc";
  OutputSet files(path);
  WriteNetcdf(layout, path, format, files);
  files.Rename();
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

std::string Write(NetcdfFormat format)
{
  return Write(MakeLayout(), format);
}

/// Returns the bytes given as pairs of hexadecimal digits.
std::string FromHex(const std::string& digits)
{
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
  {
    bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  }
  return bytes;
}

} // namespace

/// The expected bytes are the output of ncgen of netCDF 4.9.0 (ncgen -k "64-bit offset").
TEST(WriteNetcdf, ClassicFilesHaveTheBytesOfTheLibrary)
{
  EXPECT_EQ(Write(NetcdfFormat::Classic),
    FromHex("43444602000000010000000a000000020000000174000000000000000000000574687265"
            "65000000000000030000000c000000030000000161000000000000020000000568656c6c"
            "6f0000000000000169000000000000040000000100000007000000016600000000000005"
            "000000013f0000000000000b000000030000000176000000000000020000000000000001"
            "00000000000000000000000600000018000000000000011c000000016e00000000000001"
            "000000010000000c00000001000000017500000000000002000000016d00000000000004"
            "0000000c000000000000010c000000016300000000000001000000010000000000000000"
            "0000000200000004000000000000011800000001ffffffff00000102616263003ff00000"
            "00000000c0000000000000003fd0000000000000"));
}

TEST(WriteNetcdf, WideFilesAreNetcdf4)
{
  EXPECT_EQ(Write(NetcdfFormat::Wide).substr(0, 4), "\x89HDF");
}

TEST(WriteNetcdf, PartsOfValuesMakeTheSameFile)
{
  for (const NetcdfFormat format : { NetcdfFormat::Classic, NetcdfFormat::Wide })
  {
    EXPECT_EQ(Write(MakeLayout(true), format), Write(MakeLayout(false), format));
  }
}
