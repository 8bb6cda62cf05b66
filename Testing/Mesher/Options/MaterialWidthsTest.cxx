/// Widths of materials: their texts, names, ids and limits for small materials.
#include "Options/MaterialWidths.h"
#include "Options/SetOptions.h"
#include "Ranks/Errors.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vfm;

TEST(MaterialWidths, AreEntriesOrAutomatic)
{
  const MaterialWidths widths =
    ParseMaterialWidths("steel=0.5, a=b = 2 ,7=3,\"x, y=1\",small=100:0.25").value();
  using Entry = std::pair<std::string, double>;
  EXPECT_EQ(widths.Named,
    (std::vector<Entry>{ { "steel", 0.5 }, { "a=b", 2.0 }, { "7", 3.0 }, { "x, y", 1.0 } }));
  ASSERT_EQ(widths.OfSmall.size(), 1u);
  EXPECT_EQ(widths.OfSmall[0].Cells, 100);
  EXPECT_EQ(widths.OfSmall[0].Width, 0.25);
  EXPECT_FALSE(widths.IsAutomatic);
  EXPECT_TRUE(ParseMaterialWidths(" Auto ").value().IsAutomatic);
  EXPECT_FALSE(ParseMaterialWidths("").value().IsUsed());
  EXPECT_EQ(ParseMaterialWidths("small=2").value().Named[0].first, "small"); // a name
  for (const char* text : { "steel", "steel=", "steel=0", "steel=-1", "=1", "steel=x", "small=0:1",
         "small=9:0", "small=9:", "steel=1,,copper=1", "steel=inf", "steel=nan" })
  {
    EXPECT_FALSE(ParseMaterialWidths(text)) << text;
  }
}

TEST(MaterialWidths, AreOptions)
{
  MesherOptions options;
  EXPECT_FALSE(HasMaterialWidths(options));
  SetOption(options, "MaterialWidths", "steel=1");
  EXPECT_TRUE(HasMaterialWidths(options));
  EXPECT_THROW(SetOption(options, "MaterialWidths", "steel"), InputError);
  SetOption(options, "MaterialWidths", "None");
  EXPECT_FALSE(HasMaterialWidths(options));
}

TEST(MaterialWidths, SmallestOfAMaterialCounts)
{
  const NamesById names{ { 0, "Void" }, { 4, "steel" }, { 7, "copper" }, { 9, "4" } };
  const std::vector<int> ids{ 0, 4, 7, 9 };
  const std::vector<Index> cells{ 5, 200, 30, 40 };
  const auto find = [&](const std::string& text)
  { return FindWidths(*ParseMaterialWidths(text), names, ids, cells); };
  const double none = HUGE_VAL;
  EXPECT_EQ(find("steel=2,steel=3"), (std::vector<double>{ none, 2.0, none, none }));
  EXPECT_EQ(find("4=2,7=1"), (std::vector<double>{ none, none, 1.0, 2.0 })); // names before ids
  EXPECT_EQ(find("small=40:1,copper=3"), (std::vector<double>{ none, none, 1.0, none }));
  EXPECT_EQ(find("0=1,small=300:2"), (std::vector<double>{ 1.0, 2.0, 2.0, 2.0 }));
  try
  {
    find("lead=1");
    FAIL();
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find("'lead'"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("copper (7)"), std::string::npos) << error.what();
  }
}
