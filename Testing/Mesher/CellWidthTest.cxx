/// Meshes of wider cells than those of the input: materials keep their volumes and the state its
/// sums, equal widths change nothing, and ranks do not matter.
#include "Levels/WideCells.h"
#include "Options/CellWidths.h"
#include "Phases/WidenCells.h"
#include "State/MeanContents.h"
#include "State/WideContents.h"
#include "WideCases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace vfm;
using namespace vfm::testing;

namespace
{

MesherOptions OptionsOf(const std::string& width)
{
  MesherOptions options;
  options.CellWidth = width;
  return options;
}

} // namespace

TEST(CellWidth, CellsAreDescribed)
{
  const Vector3 lengths{ { 48.0, 48.0, 48.0 } };
  const Index3 cells{ { 48, 48, 48 } };
  const auto describe = [&](const char* widths) { return DescribeCells(widths, lengths, cells); };
  EXPECT_EQ(describe("0"), "48 x 48 x 48 of width 1");
  EXPECT_EQ(describe(""), "48 x 48 x 48 of width 1");
  EXPECT_EQ(describe("2"), "24 x 24 x 24 of width 2");
  EXPECT_EQ(describe("2, 3, 0"), "24 x 16 x 48 of 2 x 3 x 1");
  EXPECT_EQ(describe("7"), "7 x 7 x 7 of width 6.857");
  EXPECT_EQ(describe("100"), "1 x 1 x 1 of width 48");
  EXPECT_EQ(describe("1,1,0.9"), "narrower than 48 x 48 x 48 of width 1");
  EXPECT_EQ(describe("wide"), "not a width");
  EXPECT_EQ(DescribeCells("2", lengths, {}), "24 x 24 x 24 of width 2");
  EXPECT_EQ(DescribeCells("2,0,2", lengths, {}), "");
}

TEST(CellWidth, IsOneWidthOrThree)
{
  EXPECT_EQ(ParseWidths("2.5").value(), (Vector3{ { 2.5, 2.5, 2.5 } }));
  EXPECT_EQ(ParseWidths("1, 2 ,0").value(), (Vector3{ { 1.0, 2.0, 0.0 } }));
  EXPECT_EQ(ParseWidths("1 2 3").value(), (Vector3{ { 1.0, 2.0, 3.0 } }));
  EXPECT_EQ(ParseWidths("").value(), Vector3{});
  for (const char* text : { "1,2", "-1", "x", "1,2,3,4", "1,,2", "nan" })
  {
    EXPECT_FALSE(ParseWidths(text)) << text;
  }
  EXPECT_FALSE(HasCellWidth(MesherOptions()));
  EXPECT_TRUE(HasCellWidth(OptionsOf("0,0,1")));
}

TEST(CellWidth, MaterialsKeepTheirVolumes)
{
  Runtime serial;
  const std::vector<int> labels = MakeGrains(GridSize);
  for (const char* width : { "0.1", "0.2", "0.25", "0.3,0.2,0" })
  {
    const MesherResult result =
      RunMesher(MakeGrainsInput(serial.Group()), OptionsOf(width), serial);
    for (int m = 1; m <= 3; ++m)
    {
      const double volume =
        0.001 * static_cast<double>(std::count(labels.begin(), labels.end(), m));
      EXPECT_NEAR(result.Report.TargetVolume[m] / volume, 1.0, 1e-13);
      EXPECT_NEAR(result.Report.MeshVolume[m] / volume, 1.0, 1e-3) << width;
    }
    const auto before = ValuesOf<std::vector<Index>>(result.MaterialFields, "InputCells");
    const auto after = ValuesOf<std::vector<Index>>(result.MaterialFields, "NewCells");
    ASSERT_EQ(before.size(), 3u);
    ASSERT_EQ(after.size(), 3u);
    EXPECT_EQ(before[1], std::count(labels.begin(), labels.end(), 2));
    EXPECT_TRUE(width == std::string("0.1") ? after == before : after[0] < before[0]);
  }
}

TEST(CellWidth, IsRoundedToFillTheDomain)
{
  Runtime serial;
  const MesherResult result =
    RunMesher(MakeGrainsInput(serial.Group()), OptionsOf("0.25,0,100"), serial);
  const auto widths = ValuesOf<std::vector<double>>(result.Fields, "CellWidths");
  ASSERT_EQ(widths.size(), 3u);
  EXPECT_DOUBLE_EQ(widths[0], 0.25); // 8 cells in 2
  EXPECT_DOUBLE_EQ(widths[1], 0.1);
  EXPECT_DOUBLE_EQ(widths[2], 2.4);
}

/// Fractions in equal cells are the input, bit by bit.
TEST(CellWidth, ThatOfTheInputChangesNothing)
{
  for (const ElementKind kind : { ElementKind::Hexes, ElementKind::Tets })
  {
    MesherOptions options;
    options.Elements = kind;
    options.ThinParts = false; // labels have none
    options.Method = TetMethod::Lattice;
    const auto read = MeshOnRanks(2, options, MakeGrainsInput);
    options.CellWidth = "0.1";
    const auto same = MeshOnRanks(2, options, MakeGrainsInput);
    EXPECT_TRUE(read.Points == same.Points);
    EXPECT_TRUE(read.Elements == same.Elements);
  }
}

TEST(CellWidth, NarrowerThanTheInputIsAnError)
{
  Runtime serial;
  try
  {
    RunMesher(MakeGrainsInput(serial.Group()), OptionsOf("0.08"), serial);
    FAIL();
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find("Refinement"), std::string::npos) << error.what();
  }
}

TEST(CellWidth, RanksGiveTheSameMesh)
{
  ExpectSameOnRanks(OptionsOf("0.25"), MakeGrainsInput);
  MesherOptions smooth = OptionsOf("0.2");
  smooth.LabelSmoothing = 2;
  smooth.Elements = ElementKind::Tets;
  smooth.Method = TetMethod::Lattice;
  ExpectSameOnRanks(smooth, MakeGrainsInput);
  MesherOptions coarse = OptionsOf("0.125,0.1125,0.15");
  coarse.Refinement = RefinementMode::Coarsen;
  ExpectSameOnRanks(coarse, MakeGrainsInput);
}

TEST(CellWidth, PeriodsStay)
{
  MesherOptions options = OptionsOf("0.25");
  options.Periodic = 7;
  ExpectSameOnRanks(options, MakeGrainsInput);
  Runtime serial;
  const MesherResult result = RunMesher(MakeGrainsInput(serial.Group()), options, serial);
  const auto lengths = ValuesOf<std::vector<double>>(result.Fields, "PeriodLengths");
  ASSERT_EQ(lengths.size(), 3u);
  MesherOptions read;
  read.Periodic = 7;
  const MesherResult before = RunMesher(MakeGrainsInput(serial.Group()), read, serial);
  EXPECT_EQ(lengths, ValuesOf<std::vector<double>>(before.Fields, "PeriodLengths"));
}

/// Refined input is resampled from its finest data.
TEST(CellWidth, ReplacesTheCellsOfLevels)
{
  Runtime serial;
  MesherOptions read;
  read.Refinement = RefinementMode::InputLevels;
  const MesherResult before = RunMesher(MakeLevels(serial.Group()), read, serial);
  const MesherResult after = RunMesher(MakeLevels(serial.Group()), OptionsOf("0.23"), serial);
  for (int m = 1; m <= 2; ++m)
  {
    EXPECT_NEAR(after.Report.TargetVolume[m] / before.Report.TargetVolume[m], 1.0, 1e-13);
  }
  ExpectSameOnRanks(OptionsOf("0.23"), MakeLevels);
}

TEST(CellWidth, RequestsRefineTheNewCells)
{
  MesherOptions options = OptionsOf("0.3");
  options.Refinement = RefinementMode::Automatic;
  options.ThinCells = 0.0;
  options.RefinementBoxes = { { { { -0.3, -0.3, -0.3 } }, { { 0.3, 0.3, 0.3 } }, 1.0 } };
  Runtime serial;
  const MesherResult result = RunMesher(MakeGrainsInput(serial.Group()), options, serial);
  EXPECT_GT(result.TheMesh.ElementIds.size(),
    RunMesher(MakeGrainsInput(serial.Group()), OptionsOf("0.3"), serial).TheMesh.ElementIds.size());
  ExpectSameOnRanks(options, MakeGrainsInput);
}

TEST(CellWidth, StateIsConserved)
{
  const auto make = [](Ranks& ranks) { return WithState(true, MakeGrainsInput(ranks)); };
  const auto sumHeat = [](const MesherResult& result)
  {
    const double* values =
      reinterpret_cast<const double*>(result.State.Arrays.back().Values.data());
    return std::accumulate(values, values + result.TheMesh.ElementIds.size(), 0.0);
  };
  Runtime serial;
  const double heat = sumHeat(RunMesher(make(serial.Group()), MesherOptions(), serial));
  for (const char* width : { "0.25", "0.2" })
  {
    ExpectConserved(OptionsOf(width), make);
    const MesherResult wide = RunMesher(make(serial.Group()), OptionsOf(width), serial);
    EXPECT_NEAR(sumHeat(wide) / heat, 1.0, 1e-12);
  }
  ExpectSameOnRanks(OptionsOf("0.25"), make);
}

TEST(CellWidth, StateOfLevelsIsConserved)
{
  const auto make = [](Ranks& ranks) { return WithState(true, MakeLevels(ranks)); };
  ExpectConserved(OptionsOf("0.23"), make);
  ExpectSameOnRanks(OptionsOf("0.23"), make);
}

TEST(CellWidth, StateIsCopiedFromCellsOfTheInput)
{
  const auto make = [](Ranks& ranks) { return WithState(false, MakeGrainsInput(ranks)); };
  Runtime serial;
  const MesherInput input = make(serial.Group());
  const auto energy = input.Levels.Levels[0].Blocks[0].Arrays->Find("energy");
  std::vector<double> values;
  for (Index i = 0; i < energy->Tuples; ++i)
  {
    values.push_back(energy->Get(i, 0));
  }
  std::sort(values.begin(), values.end());
  const MesherResult result = RunMesher(input, OptionsOf("0.25"), serial);
  const double* copied = reinterpret_cast<const double*>(result.State.Arrays[4].Values.data());
  for (std::size_t e = 0; e < result.TheMesh.ElementIds.size(); ++e)
  {
    EXPECT_TRUE(std::binary_search(values.begin(), values.end(), copied[e]));
  }
  ExpectSameOnRanks(OptionsOf("0.25"), make);
  MesherOptions periodic = OptionsOf("0.25");
  periodic.Periodic = 3;
  ExpectSameOnRanks(periodic, make);
}

TEST(CellWidth, OneWarningNamesWhatIsLost)
{
  std::vector<int> labels(GridSize[0] * GridSize[1] * GridSize[2], 1);
  const IndexBox box{ {}, GridSize };
  labels[IndexInBox(box, { { 10, 9, 12 } })] = 2; // a single cell
  Runtime serial;
  MesherInput input = MakeLabelInput(TheGrid, labels, serial.Group());
  std::vector<std::string> warnings;
  input.Warn = [&](const std::string& text) { warnings.push_back(text); };
  MesherOptions options = OptionsOf("0.3");
  options.ZeroLabel = ZeroLabelMeaning::Material; // no warning of label 0
  RunMesher(input, options, serial);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("(id 2) by -1e+02 %"), std::string::npos) << warnings[0];
  EXPECT_NE(warnings[0].find("CellWidth"), std::string::npos) << warnings[0];
}

TEST(CellWidth, WarningNamesAWidthThatKeepsWhatIsLost)
{
  const IndexBox cube{ { { 6, 6, 6 } }, { { 10, 10, 10 } } };
  std::vector<int> labels;
  ForCells(
    { {}, GridSize }, [&](const Index3& cell) { labels.push_back(cube.Contains(cell) ? 2 : 1); });
  Runtime serial;
  MesherInput input = MakeLabelInput(TheGrid, labels, serial.Group());
  std::string warnings;
  input.Warn = [&](const std::string& text) { warnings += text; };
  MesherOptions options = OptionsOf("0.8");
  options.ZeroLabel = ZeroLabelMeaning::Material; // no warning of label 0
  RunMesher(input, options, serial);
  const std::string before = "1 material misses its volume by more than 1 %",
                    word = "CellWidth of ";
  EXPECT_NE(warnings.find(before), std::string::npos) << warnings;
  const std::size_t at = warnings.find(word);
  ASSERT_NE(at, std::string::npos) << warnings;
  const double width = std::stod(warnings.substr(at + word.size()));
  EXPECT_GT(width, 0.11);
  EXPECT_LT(width, 0.8);
  warnings.clear();
  options.CellWidth = std::to_string(width);
  RunMesher(input, options, serial);
  EXPECT_EQ(warnings.find("misses its volume"), std::string::npos) << warnings;
}

/// A sheet that no new cell keeps becomes a part of the body near it, so the volume is exact.
TEST(CellWidth, WarnsOfWhatIsInAnotherPlace)
{
  std::vector<int> labels;
  ForCells({ {}, GridSize },
    [&](const Index3& cell) { labels.push_back(cell[0] < 8 || cell[0] == 16 ? 2 : 1); });
  MesherOptions options = OptionsOf("0.4");
  options.ZeroLabel = ZeroLabelMeaning::Material; // no warning of label 0
  options.ThinParts = false;
  std::vector<double> shares;
  for (int count : { 1, 2, 3 })
  {
    RunOnRanks(count,
      [&](ThreadRanks& ranks)
      {
        RankRuntime runtime(ranks);
        MesherInput input = MakeLabelInput(TheGrid, labels, ranks);
        std::vector<std::string> warnings;
        input.Warn = [&](const std::string& text) { warnings.push_back(text); };
        const MesherResult result = RunMesher(input, options, runtime);
        if (ranks.Rank() == 0)
        {
          ASSERT_EQ(warnings.size(), 1u);
          EXPECT_NE(warnings[0].find("another place than in the input: 'Material 2' (id 2) 11 %"),
            std::string::npos)
            << warnings[0];
          EXPECT_NE(warnings[0].find("smaller CellWidth"), std::string::npos) << warnings[0];
          shares.push_back(result.Report.DisplacedVolume[2]);
        }
      });
  }
  for (double share : shares)
  {
    EXPECT_EQ(share, shares[0]);
    EXPECT_NEAR(share, 1.0 / 9.0, 0.01);
  }
}
