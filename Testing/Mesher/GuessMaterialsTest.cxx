/// Arrays that are selected as materials by name, type and range.
#include "Input/GuessMaterials.h"

#include <gtest/gtest.h>

using namespace vfm;

namespace
{

using Names = std::vector<std::string>;
constexpr double Tolerance = 1e-6;

ArrayInfo Make(const std::string& name, int type, double least, double most, int components = 1)
{
  return { name, type, components, least, most };
}

Names Guess(const std::vector<ArrayInfo>& arrays, const Names& others = {})
{
  return GuessMaterials(arrays, others, Tolerance).Fractions;
}

const ArrayInfo Ball = Make("ball", ValueType::Double, 0.0, 1.0);
const ArrayInfo Heat = Make("heat", ValueType::Float, 0.0, 300.0);

} // namespace

TEST(GuessMaterials, TakesRealsInUnitRangeAndBytes)
{
  const ArrayInfo bytes = Make("bytes", ValueType::UnsignedChar, 0.0, 200.0);
  const ArrayInfo whole = Make("whole", ValueType::Int, 0.0, 1.0);
  const ArrayInfo vector = Make("vector", ValueType::Double, 0.0, 1.0, 3);
  EXPECT_EQ(Guess({ Ball, Heat, bytes, whole, vector }), Names({ "ball", "bytes" }));
  EXPECT_EQ(Guess({ Ball, bytes }, { "ball" }), Names({ "bytes" }));
  EXPECT_TRUE(Guess({ Heat, whole }).empty());
}

TEST(GuessMaterials, ToleratesRounding)
{
  EXPECT_EQ(Guess({ Make("a", ValueType::Float, -1e-7, 1.0 + 1e-7) }), Names({ "a" }));
  EXPECT_TRUE(Guess({ Make("a", ValueType::Float, -1e-5, 1.0) }).empty());
}

TEST(GuessMaterials, PrefersNamesOfSpyPlotInTheOrderOfTheirNumbers)
{
  const std::string name = "Material volume fraction - ";
  const ArrayInfo ten = Make(name + "10", ValueType::Float, 0.0, 2.0);
  const ArrayInfo two = Make("Volume Fraction - 2", ValueType::Float, 0.0, 1.0);
  const GuessedMaterials found = GuessMaterials({ ten, Ball, two }, {}, Tolerance);
  EXPECT_TRUE(found.AreNumbered);
  EXPECT_EQ(found.Fractions, Names({ "Volume Fraction - 2", name + "10" }));
  EXPECT_FALSE(IsSpyPlotFraction(name + "x"));
}

TEST(GuessMaterials, TakesMaterialIdWhereThereAreNoFractions)
{
  const ArrayInfo labels = Make(LabelsName, ValueType::UnsignedChar, 0.0, 5.0);
  EXPECT_EQ(GuessMaterials({ labels, Heat }, {}, Tolerance).Labels, LabelsName);
  const GuessedMaterials both = GuessMaterials({ labels, Ball }, {}, Tolerance);
  EXPECT_EQ(both.Fractions, Names({ "ball" }));
  EXPECT_TRUE(both.Labels.empty());
}
