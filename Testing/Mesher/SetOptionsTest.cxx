/// Options set, read, checked and described by name; and a row added to the table.
#include "Options/SetOptions.h"
#include "Base/ParseText.h"
#include "Base/Runtime.h"
#include "Options/ValueRanges.h"

#include <gtest/gtest.h>

namespace vfm
{
namespace
{

/// Returns the error message of SetOption, or an empty string.
std::string Refusal(MesherOptions& options, const std::string& name, const std::string& value)
{
  try
  {
    SetOption(options, name, value);
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}

std::string Refusal(const std::string& name, const std::string& value)
{
  MesherOptions options;
  options.Elements = ElementKind::Tets;
  return Refusal(options, name, value);
}

TEST(SetOptions, NamesAndWordsInAnyCaseWithOrWithoutSpaces)
{
  MesherOptions options;
  SetOption(options, "iso VALUE", "0.25");
  SetOption(options, "Smoothing", "geometry based");
  SetOption(options, "SharpEdges", "0");
  SetOption(options, "meshvoid", "YES");
  SetOption(options, "StateKinds", "p=volume, t=mass*c,p=volume");
  SetOption(options, "RefinementBoxes", "0,0,0,1,2,3;-1,-1,-1,1,1,1e-3,2");
  EXPECT_EQ(options.IsoValue, 0.25);
  EXPECT_EQ(options.Smoothing, SmoothingMethod::GeometryBased);
  EXPECT_EQ(options.SharpEdges, SharpEdgeMode::Off);
  EXPECT_TRUE(options.MeshVoid);
  EXPECT_EQ(options.StateKinds, (std::vector<std::string>{ "p=volume", "t=mass*c" }));
  ASSERT_EQ(options.RefinementBoxes.size(), 2u);
  EXPECT_EQ(options.RefinementBoxes[0].Halvings, 1.0);
  EXPECT_EQ(options.RefinementBoxes[1].Upper, (Vector3{ { 1.0, 1.0, 1e-3 } }));
  SetOption(options, "StateKinds", "None");
  SetOption(options, "RefinementBoxes", "");
  EXPECT_TRUE(options.StateKinds.empty() && options.RefinementBoxes.empty());
}

TEST(SetOptions, RefusalsNameOptionValueAndWhatIsAllowed)
{
  const std::pair<std::string, std::string> texts[] = {
    { "IsoValue=1", "it takes a number above 0 and below 1." },
    { "TargetScaledJacobian=1", "it takes a number from 0 (automatic) to below 1." },
    { "FractionTolerance=0.2", "it takes a number from 1e-6 to 0.1." },
    { "MaximumLevel=11", "it takes an integer from -1 (automatic) to 10." },
    { "MaximumAspectRatio=1.05", "it takes 0 (off) or a number, 1.1 or more." },
    { "CurvaturePerCell=-1", "it takes a number, 0 (off) or more." },
    { "MinimumRegionCells=4294967296", "it takes an integer, 0 or more." },
    { "RelativeSize=1e7", "it takes a number from 0.1 to 1e6." },
    { "RadiusEdgeRatio=101", "it takes a number from 1 to 100." },
    { "IsoValue=0.5x", "it takes" },
    { "IsoValue=nan", "it takes" },
    { "MeshVoid=2", "on or off" },
    { "Method=3", "it takes TetGen, Cells, Lattice (or 0 to 2)." },
    { "StateKinds=p", "it takes name=kind with commas between them" },
    { "RefinementBoxes=0,0,0,1,1", "it takes x0,y0,z0,x1,y1,z1" },
    { "RefinementBoxes=0,0,0,1,1,1,11", "it takes x0,y0,z0,x1,y1,z1" },
  };
  for (const auto& [setting, text] : texts)
  {
    const std::string name = setting.substr(0, setting.find('='));
    const std::string value = setting.substr(name.size() + 1);
    const std::string refusal = Refusal(name, value);
    EXPECT_EQ(refusal.find("The option " + name + " cannot be '" + value + "': "), 0u) << refusal;
    EXPECT_NE(refusal.find(text), std::string::npos) << refusal;
  }
  EXPECT_EQ(Refusal("Wrong", "1")
              .find("There is no option 'Wrong' (given '1'). The options are: "
                    "LabelNames, "),
    0u);
}

TEST(SetOptions, OptionsOfTetrahedraAreRejectedByHexahedra)
{
  MesherOptions options;
  const std::string refusal = Refusal(options, "Method", "Cells");
  EXPECT_EQ(
    refusal.find("The option Method (given 'Cells') applies to tetrahedra only, and the mesh has "
                 "hexahedra. Options for hexahedra: "),
    0u);
  EXPECT_EQ(refusal.find("RelativeSize"), std::string::npos);
  options.Elements = ElementKind::Tets;
  EXPECT_EQ(Refusal(options, "Method", "Cells"), "");
  EXPECT_EQ(options.Method, TetMethod::Cells);
}

TEST(SetOptions, EveryValueIsSetByItsOwnText)
{
  MesherOptions options, other;
  options.Elements = other.Elements = ElementKind::Tets;
  for (const Option& option : GetOptionTable())
  {
    const std::string text = GetOption(options, option);
    EXPECT_EQ(Refusal(other, option.Name, text), "") << option.Name;
    EXPECT_EQ(GetOption(other, option), text) << option.Name;
  }
  SetOption(options, "RefinementBoxes", "0,0,0,1,1,1,2;0,0,0,0.1,1,1");
  EXPECT_EQ(GetOption(options, *FindOption("RefinementBoxes")), "0,0,0,1,1,1,2;0,0,0,0.1,1,1,1");
  EXPECT_NO_THROW(CheckOptions(other));
}

TEST(SetOptions, NumbersOutOfRangeAreFoundBeforeARun)
{
  MesherOptions options;
  options.RadiusEdgeRatio = 0.5; // an option for tetrahedra only
  EXPECT_NO_THROW(CheckOptions(options));
  options.Elements = ElementKind::Tets;
  EXPECT_THROW(CheckOptions(options), InputError);
  options = MesherOptions();
  options.MaximumAspectRatio = 1.05;
  EXPECT_THROW(CheckOptions(options), InputError);
}

TEST(SetOptions, HelpHasTwoLinesAnOption)
{
  const std::vector<std::string> hexes = DescribeOptions(ElementKind::Hexes);
  const std::vector<std::string> tets = DescribeOptions(ElementKind::Tets);
  EXPECT_EQ(tets.size(), GetOptionTable().size());
  EXPECT_EQ(tets.size(), hexes.size() + 6);
  EXPECT_NE(std::find(tets.begin(), tets.end(),
              "Method: TetGen, Cells, Lattice (or 0 to 2); default Lattice; tetrahedra only\n"
              "      How the tetrahedra are made."),
    tets.end());
}

TEST(SetOptions, AnAddedRowIsAnOption)
{
  OptionTable table = GetOptionTable();
  Option row = *FindOption("IsoValue");
  row.Name = "NewOption";
  table.push_back(row);
  MesherOptions options;
  SetOption(options, "new option", "0.75", table);
  EXPECT_EQ(GetOption(options, *FindOption("NewOption", table)), "0.75");
  EXPECT_EQ(DescribeOptions(ElementKind::Hexes, table).back(),
    "NewOption, --iso V: a number above 0 and below 1; default 0.5\n"
    "      A cell is void if its materials together fill less than this fraction of it.");
}

TEST(ParseText, PartsInQuotesMayContainCommas)
{
  using Names = std::vector<std::string>;
  EXPECT_EQ(SplitText("\"a, 1\" , b,\"c\""), Names({ "a, 1", "b", "c" }));
  EXPECT_EQ(SplitText("a \"b,c\","), Names({ "a \"b", "c\"", "" }));
  EXPECT_EQ(SplitText("\"a,b"), Names({ "\"a", "b" }));
  const Names names{ "a, 1", " b", "c \"d\"" };
  EXPECT_EQ(
    SplitText(QuoteName(names[0]) + "," + QuoteName(names[1]) + "," + QuoteName(names[2])), names);
  MesherOptions options;
  SetOption(options, "DensityArrays", "\"rho, 1\",rho");
  EXPECT_EQ(options.DensityArrays, Names({ "rho, 1", "rho" }));
  EXPECT_EQ(GetOption(options, *FindOption("DensityArrays")), "\"rho, 1\", rho");
}

TEST(ValueRanges, AreAboveTheLowerAndUpToTheUpperLimit)
{
  const auto ranges = ParseRanges("128; -5:0.5, 1e3:2e3").value_or(std::vector<ValueRange>());
  EXPECT_FALSE(ParseRanges("128;1e3:2e3"));
  EXPECT_TRUE(ranges.empty()); // the first has no upper limit, so the last overlaps it
  const auto found = ParseRanges("128: ;-5:0.5,:-6").value();
  ASSERT_EQ(found.size(), 3u);
  EXPECT_TRUE(found[0].Holds(128.5) && found[0].Holds(1e300) && !found[0].Holds(128.0));
  EXPECT_TRUE(found[1].Holds(0.5) && found[1].Holds(-4.9) && !found[1].Holds(-5.0));
  EXPECT_TRUE(found[2].Holds(-6.0) && found[2].Holds(-1e300) && !found[2].Holds(-5.5));
  EXPECT_FALSE(found[0].Holds(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_TRUE(ParseRanges("").value().empty());
  EXPECT_EQ(ParseRanges("0:1,1:2").value().size(), 2u); // neighbours do not overlap
  for (const char* text : { ":", "1:1", "2:1", "x", "1:2:3", "0:2,1:3", "nan", "1,", "1:inf" })
  {
    EXPECT_FALSE(ParseRanges(text)) << text;
  }
  // Accessors of filters do not throw; runs do.
  MesherOptions options;
  EXPECT_TRUE(SetText(options, "Threshold", "2:1"));
  EXPECT_THROW(CheckOptions(options), InputError);
  EXPECT_TRUE(SetText(options, "Threshold", "None"));
  EXPECT_EQ(options.Threshold, "");
}

TEST(ParseText, NumbersAreFormattedAsShortAsTheyCanBe)
{
  for (const char* text :
    { "0", "0.5", "-3", "1e-6", "1e6", "0.1", "1e300", "12345.678", "-2.5e-7" })
  {
    EXPECT_EQ(FormatNumber(*ParseNumber(text, -1e308, 1e308)), text);
  }
  EXPECT_EQ(FormatNumber(0.1F), "0.1"); // the digits of single precision
  EXPECT_EQ(FormatNumber(1e-6F), "1e-6");
  EXPECT_EQ(SnakeCase("RefineFlippedCells"), "refine_flipped_cells");
  EXPECT_EQ(TrimText("\t a b \r\n"), "a b");
}

} // namespace
} // namespace vfm
