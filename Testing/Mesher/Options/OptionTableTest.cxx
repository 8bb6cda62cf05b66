/// Rows of the table of options.
#include "Options/OptionTable.h"

#include <gtest/gtest.h>

#include <set>

using namespace vfm;

TEST(OptionTable, NumbersAreKeptAndDefaultsAllowed)
{
  std::set<std::string> names;
  const MesherOptions defaults;
  for (const Option& option : GetOptionTable())
  {
    SCOPED_TRACE(option.Name);
    EXPECT_TRUE(names.insert(option.Name).second);
    EXPECT_FALSE(option.Meaning.empty());
    EXPECT_EQ(!option.Words.empty(), option.Kind == OptionKind::Choice);
    EXPECT_EQ(option.GetNumber != nullptr, option.SetNumber != nullptr);
    if (!option.GetNumber)
    {
      continue;
    }
    const double number = option.GetNumber(defaults);
    if (option.Kind == OptionKind::Integer || option.Kind == OptionKind::Real)
    {
      EXPECT_TRUE(option.Range.Holds(number)) << number;
    }
    MesherOptions options;
    for (std::size_t word = 0; word < option.Words.size(); ++word)
    {
      option.SetNumber(options, static_cast<double>(word));
      EXPECT_EQ(option.GetNumber(options), static_cast<double>(word));
    }
    for (double value : { 0.0, 1.0 })
    {
      option.SetNumber(options, value);
      EXPECT_EQ(option.GetNumber(options), value);
    }
  }
}

TEST(OptionTable, LimitsAreOpenOrClosed)
{
  OptionRange range{ .Least = 0.0, .Most = 1.0 };
  EXPECT_TRUE(range.Holds(0.0) && range.Holds(1.0));
  EXPECT_FALSE(range.Holds(-0.1) || range.Holds(1.1));
  range.IsMinimumOpen = range.IsMaximumOpen = true;
  EXPECT_TRUE(range.Holds(0.5));
  EXPECT_FALSE(range.Holds(0.0) || range.Holds(1.0));
  range.Special = -1.0;
  EXPECT_TRUE(range.Holds(-1.0));
}
