/// Groups of elements by values: volumes and moduli against exact numbers, the same from any number
/// of ranks, and messages.
#include "Report/Sets/MaterialBins.h"

#include "Ranks/WorkTogether.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Boxes in a row; box i has the width i + 1, the value i, and the material 3 or, from 5 on, 8.
class Row
{
public:
  /// Makes the boxes whose number has this remainder.
  Row(int count, int remainder, int divisor)
  {
    for (int box = remainder; box < count; box += divisor)
    {
      for (int corner : { 0, 1, 3, 2, 4, 5, 7, 6 })
      {
        this->Elements.push_back(static_cast<Index>(this->Points.size() / 3));
        this->Points.insert(this->Points.end(),
          { (corner & 1) * (box + 1.0), (corner >> 1 & 1) * 1.0, (corner >> 2) * 1.0 });
      }
      this->Material.push_back(box < 5 ? 3 : 8);
      this->Values.push_back(box);
    }
    MeshData& data = this->Data;
    data.Corners = 8;
    data.NumberOfPoints = static_cast<Index>(this->Points.size() / 3);
    data.NumberOfElements = static_cast<Index>(this->Material.size());
    data.Points = this->Points.data();
    data.Elements = this->Elements.data();
    data.Material = this->Material.data();
    data.ElementArrays = { { "grey", ValueType::Double, 1, {}, this->Values.data() } };
    data.Fields = { { "MaterialNames", std::vector<std::string>{ "bone", "steel" } },
      { "MaterialIds", std::vector<int>{ 3, 8 } } };
  }

  std::vector<double> Points, Values;
  std::vector<Index> Elements;
  std::vector<int> Material;
  MeshData Data;
};

BinRule RuleOf(int count)
{
  return { "grey", count, {}, ElasticLaw{ 2.0, 2.0, 0.25, 1.0, 0.5 } };
}

std::string MessageOf(const MeshData& mesh, const BinRule& rule)
{
  try
  {
    Ranks alone;
    BinElements(mesh, rule, alone);
    return "";
  }
  catch (const InputError& error)
  {
    return error.what();
  }
}

TEST(MaterialBins, VolumesAndModuli)
{
  const Row row(8, 0, 1);
  Ranks alone;
  const BinnedElements found = BinElements(row.Data, RuleOf(4), alone);
  // Edges 0, 1.75, 3.5, 5.25, 7; ids follow that of a void, 9.
  EXPECT_EQ(found.Ids, (std::vector<int>{ 10, 10, 11, 11, 12, 13, 14, 14 }));
  const std::vector<const char*> names{ "bone_bin_01", "bone_bin_02", "bone_bin_03", "steel_bin_03",
    "steel_bin_04" };
  const std::vector<double> lower{ 0, 1.75, 3.5, 3.5, 5.25 }, volumes{ 3, 7, 5, 6, 15 },
    means{ 2.0 / 3, 18.0 / 7, 4, 5, 98.0 / 15 };
  const std::vector<int> materials{ 3, 3, 3, 8, 8 }, numbers{ 1, 2, 3, 3, 4 },
    elements{ 2, 2, 1, 1, 2 };
  ASSERT_EQ(found.Bins.size(), 5u);
  for (std::size_t b = 0; b < 5; ++b)
  {
    const MaterialBin& bin = found.Bins[b];
    EXPECT_EQ(bin.Id, static_cast<int>(10 + b));
    EXPECT_EQ(bin.Name, names[b]);
    EXPECT_EQ(bin.Material, materials[b]);
    EXPECT_EQ(bin.Number, numbers[b]);
    EXPECT_EQ(bin.Lower, lower[b]);
    EXPECT_EQ(bin.Upper, lower[b] + 1.75);
    EXPECT_EQ(bin.Elements, elements[b]);
    EXPECT_EQ(bin.Volume, volumes[b]);
    EXPECT_NEAR(bin.Mean, means[b], 1e-15 * means[b]);
    ASSERT_TRUE(bin.Elastic);
    const double density = 1.0 + 0.5 * means[b];
    EXPECT_NEAR(bin.Elastic->Density, density, 1e-15 * density);
    EXPECT_NEAR(bin.Elastic->Modulus, 2.0 * density * density, 1e-14 * density * density);
    EXPECT_EQ(bin.Elastic->Poisson, 0.25);
  }
}

TEST(MaterialBins, SameOnRanks)
{
  Ranks alone;
  const Row whole(23, 0, 1);
  const BinnedElements expected = BinElements(whole.Data, RuleOf(7), alone);
  for (int count : { 2, 3, 5 })
  {
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        const Row part(23, ranks.Rank(), count);
        const BinnedElements found = BinElements(part.Data, RuleOf(7), ranks);
        ASSERT_EQ(found.Fields.size(), expected.Fields.size());
        for (std::size_t f = 0; f < found.Fields.size(); ++f)
        {
          EXPECT_EQ(found.Fields[f].Values, expected.Fields[f].Values) << found.Fields[f].Name;
        }
        for (std::size_t e = 0; e < found.Ids.size(); ++e)
        {
          EXPECT_EQ(found.Ids[e], expected.Ids[ranks.Rank() + count * e]);
        }
      });
  }
}

TEST(MaterialBins, EveryValueIsBetweenItsEdges)
{
  Row row(200, 0, 1);
  for (std::size_t e = 0; e < row.Values.size(); ++e)
  {
    row.Values[e] = 0.1 * (1.0 + static_cast<double>(e % 41)); // many are near edges
  }
  Ranks alone;
  const BinnedElements found = BinElements(row.Data, { "grey", 40, { 3, 8 }, {} }, alone);
  EXPECT_FALSE(found.Bins.front().Elastic);
  double volume = 0.0;
  for (std::size_t e = 0; e < row.Values.size(); ++e)
  {
    const MaterialBin& bin = found.Bins[found.Ids[e] - found.Bins.front().Id];
    EXPECT_EQ(bin.Material, row.Material[e]);
    EXPECT_LE(bin.Lower, row.Values[e]);
    EXPECT_TRUE(row.Values[e] < bin.Upper || (bin.Number == 40 && row.Values[e] == bin.Upper));
  }
  for (const MaterialBin& bin : found.Bins)
  {
    volume += bin.Volume;
    EXPECT_GT(bin.Elements, 0);
    EXPECT_LE(bin.Lower, bin.Mean);
    EXPECT_LE(bin.Mean, bin.Upper);
  }
  EXPECT_EQ(volume, 200 * 201 / 2);
}

TEST(MaterialBins, SmallVolumesKeepTheirDigits)
{
  Row row(8, 0, 1);
  for (double& x : row.Points)
  {
    x *= 1e-9;
  }
  Ranks alone;
  const BinnedElements found = BinElements(row.Data, RuleOf(4), alone);
  EXPECT_NEAR(found.Bins[4].Volume, 15e-27, 1e-14 * 15e-27);
  EXPECT_NEAR(found.Bins[4].Mean, 98.0 / 15, 1e-14);
}

TEST(MaterialBins, FieldsAreRead)
{
  Row row(8, 0, 1);
  Ranks alone;
  const BinnedElements found = BinElements(row.Data, RuleOf(4), alone);
  ReplaceBins(found.Fields, row.Data.Fields);
  EXPECT_TRUE(ReadBins(row.Data).empty()); // without the array
  EXPECT_EQ(FindLastBinId(row.Data), 14);
  row.Data.ElementArrays.push_back({ BinIdName, ValueType::Int, 1, {}, found.Ids.data() });
  const std::vector<MaterialBin> read = ReadBins(row.Data);
  const std::vector<FieldArray> again = ListBins(read);
  ASSERT_EQ(again.size(), 12u);
  for (std::size_t f = 0; f < again.size(); ++f)
  {
    EXPECT_EQ(again[f].Values, found.Fields[f].Values) << again[f].Name;
  }
  // Earlier bins have no effect, and a table without a law replaces one with a law.
  const BinnedElements plain = BinElements(row.Data, { "grey", 2, { 8 }, {} }, alone);
  EXPECT_EQ(plain.Ids, (std::vector<int>{ 0, 0, 0, 0, 0, 10, 11, 11 }));
  ReplaceBins(plain.Fields, row.Data.Fields);
  EXPECT_EQ(row.Data.Fields.size(), 2u + 9u);
  EXPECT_FALSE(ReadBins(row.Data).front().Elastic);
  row.Data.Fields.pop_back();
  EXPECT_THROW(ReadBins(row.Data), InputError);
}

TEST(MaterialBins, Messages)
{
  Row row(8, 0, 1);
  const auto expect = [&row](BinRule rule, const std::string& text)
  {
    EXPECT_NE(MessageOf(row.Data, rule).find(text), std::string::npos) << MessageOf(row.Data, rule);
  };
  const double inf = std::numeric_limits<double>::infinity();
  expect({ "gray", 4, {}, {} }, "The mesh has no array 'gray' of elements for bins. It has grey.");
  expect({ "grey", 0, {}, {} }, "The number of bins is 0: it must be 1 to 10000.");
  expect({ "grey", 10001, {}, {} }, "The number of bins is 10001");
  expect({ "grey", 4, { 5 }, {} }, "No element has the material 5");
  BinRule rule = RuleOf(4);
  rule.Law->Exponent = std::nan("");
  expect(rule, "The exponent b of the law of bins is not finite.");
  rule = RuleOf(4);
  rule.Law->Slope = inf;
  expect(rule, "The slope c1 of the law of bins is not finite.");
  rule = RuleOf(4);
  rule.Law->Factor = 0.0;
  expect(rule, "The factor a of the law of bins is 0: it must be above 0.");
  rule = RuleOf(4);
  rule.Law->Poisson = 0.5;
  expect(rule, "Poisson's ratio of bins is 0.5");
  rule = RuleOf(4);
  rule.Law->Offset = -1.0;
  expect(rule, "The density of bone_bin_01 is -0.666667, from the mean value 0.666667");
  rule = RuleOf(4);
  rule.Law->Exponent = 20000.0;
  expect(rule, "The modulus of bone_bin_01 is inf");
  row.Values[2] = inf;
  row.Values[3] = std::nan("");
  expect(RuleOf(4), "The array 'grey' has 2 values that are not finite");
  row.Values.assign(8, 2.5);
  row.Data.ElementArrays[0].Values = row.Values.data();
  expect(RuleOf(4), "All values of the array 'grey' are 2.5");
  EXPECT_EQ(MessageOf(row.Data, RuleOf(1)), "");
  row.Data.ElementArrays[0].Components = 3;
  expect(RuleOf(4), "The array 'grey' has 3 components: bins need one.");
}

TEST(MaterialBins, OneMessageOnAllRanks)
{
  RunOnRanks(3,
    [](Ranks& ranks)
    {
      Row part(12, ranks.Rank(), 3);
      part.Values[0] = ranks.Rank() == 1 ? std::nan("") : part.Values[0];
      try
      {
        BinElements(part.Data, RuleOf(4), ranks);
        ADD_FAILURE();
      }
      catch (const InputError& error)
      {
        EXPECT_STREQ(error.what(),
          "The array 'grey' has 1 values that are not finite, so its range cannot be divided into "
          "bins.");
      }
    });
}

} // namespace
