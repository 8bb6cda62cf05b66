/// Meshes with widths of materials: given and automatic, on ranks, periodic, and with state.
#include "Levels/NewCells.h"
#include "MeshChecks.h"
#include "Octree/RefinedGrid.h"
#include "Phases/MeshOfCells.h"
#include "WideCases.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vfm;
using namespace vfm::testing;

namespace
{

MesherOptions OptionsOf(const std::string& widths, const std::string& width = "0")
{
  MesherOptions options;
  options.MaterialWidths = widths;
  options.CellWidth = width;
  return options;
}

std::string ErrorOf(const MesherOptions& options)
{
  Runtime serial;
  try
  {
    RunMesher(MakeGrainsInput(serial.Group()), options, serial);
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}

void ExpectVolumes(const MesherResult& result)
{
  const std::vector<int> labels = MakeGrains(GridSize);
  for (int m = 1; m <= 3; ++m)
  {
    const double volume = 0.001 * static_cast<double>(std::count(labels.begin(), labels.end(), m));
    EXPECT_NEAR(result.Report.TargetVolume[m] / volume, 1.0, 1e-13);
    EXPECT_NEAR(result.Report.MeshVolume[m] / volume, 1.0, 1e-3);
  }
}

} // namespace

TEST(MaterialWidthsOfMeshes, EachMaterialGetsItsWidth)
{
  Runtime serial;
  const MesherResult result =
    RunMesher(MakeGrainsInput(serial.Group()), OptionsOf("2=0.1", "0.2"), serial);
  ExpectVolumes(result);
  const auto widths = ValuesOf<std::vector<double>>(result.MaterialFields, "MaterialWidths");
  ASSERT_EQ(widths.size(), 3u);
  EXPECT_NEAR(widths[0], 0.2, 1e-12);
  EXPECT_NEAR(widths[1], 0.1, 1e-12);
  const auto levels = ValuesOf<std::vector<Index>>(result.Fields, "LevelCells");
  ASSERT_EQ(levels.size(), 2u);
  EXPECT_GT(levels[0], 50);
  EXPECT_GT(levels[1], 50);
  const auto count = [&](const MesherOptions& options)
  { return RunMesher(MakeGrainsInput(serial.Group()), options, serial).TheMesh.ElementIds.size(); };
  const std::size_t elements = result.TheMesh.ElementIds.size();
  EXPECT_LT(elements, count(MesherOptions()));
  EXPECT_GT(elements, count(OptionsOf("", "0.2")));
}

/// Their interfaces cross levels, except those of TetGen.
TEST(MaterialWidthsOfMeshes, TetsHaveWidthsToo)
{
  Runtime serial;
  MesherOptions options = OptionsOf("2=0.1", "0.2");
  options.Elements = ElementKind::Tets;
  const auto count = [&](const MesherOptions& given)
  { return RunMesher(MakeGrainsInput(serial.Group()), given, serial).TheMesh.ElementIds.size(); };
  const MesherResult result = RunMesher(MakeGrainsInput(serial.Group()), options, serial);
  ExpectVolumes(result);
  EXPECT_EQ(FindTopologyProblem(result.TheMesh), "");
  EXPECT_GT(SmallestCornerDeterminant(result.TheMesh), 0.0);
  EXPECT_GT(result.Report.MinimumDihedralAngle, 28.0);
  const std::size_t elements = result.TheMesh.ElementIds.size();
  MesherOptions wide = OptionsOf("", "0.2"), narrow = OptionsOf("", "0.1");
  wide.Elements = narrow.Elements = ElementKind::Tets;
  EXPECT_GT(elements, count(wide));
  EXPECT_LT(elements, count(narrow));
  if (HasTetGen())
  {
    options.Method = TetMethod::TetGen;
    const MesherResult filled = RunMesher(MakeGrainsInput(serial.Group()), options, serial);
    EXPECT_TRUE(filled.TheMesh.Levels == nullptr || filled.TheMesh.Levels->HasFineInterfaces());
  }
}

TEST(MaterialWidthsOfMeshes, OneWidthForAllIsCellWidth)
{
  const MeshById all = MeshOnRanks(2, OptionsOf("1=0.2,2=0.2,3=0.2"), MakeGrainsInput);
  const MeshById uniform = MeshOnRanks(2, OptionsOf("", "0.2"), MakeGrainsInput);
  EXPECT_TRUE(all.Points == uniform.Points);
  EXPECT_TRUE(all.Elements == uniform.Elements);
}

TEST(MaterialWidthsOfMeshes, RanksGiveTheSameMesh)
{
  ExpectSameOnRanks(OptionsOf("2=0.1", "0.2"), MakeGrainsInput);
  ExpectSameOnRanks(OptionsOf("small=1500:0.1", "0.2"), MakeGrainsInput);
  ExpectSameOnRanks(OptionsOf("2=0.15", "0.3"), MakeLevels);
  MesherOptions tets = OptionsOf("2=0.1", "0.2");
  tets.Elements = ElementKind::Tets;
  ExpectSameOnRanks(tets, MakeGrainsInput);
  MesherOptions periodic = OptionsOf("2=0.1", "0.2");
  periodic.Periodic = 5;
  ExpectSameOnRanks(periodic, MakeGrainsInput);
}

TEST(MaterialWidthsOfMeshes, AutomaticWidthsFollowTheError)
{
  Runtime serial;
  const auto run = [&](double allowed)
  {
    MesherOptions options = OptionsOf("auto");
    options.AllowedError = allowed;
    return RunMesher(MakeGrainsInput(serial.Group()), options, serial);
  };
  const MesherResult wide = run(0.5), narrow = run(0.1);
  ExpectVolumes(wide);
  ExpectVolumes(narrow);
  EXPECT_LT(2 * wide.TheMesh.ElementIds.size(), narrow.TheMesh.ElementIds.size());
  const MeshById none = MeshOnRanks(1, OptionsOf("auto", "0.1"), MakeGrainsInput);
  EXPECT_TRUE(none.Points == MeshOnRanks(1, OptionsOf("", "0.1"), MakeGrainsInput).Points);
  ExpectSameOnRanks(OptionsOf("auto"), MakeGrainsInput);
  MesherOptions tets = OptionsOf("auto");
  tets.Elements = ElementKind::Tets;
  ExpectSameOnRanks(tets, MakeGrainsInput);
}

TEST(MaterialWidthsOfMeshes, StateIsConserved)
{
  const auto make = [](Ranks& ranks) { return WithState(true, MakeGrainsInput(ranks)); };
  ExpectConserved(OptionsOf("2=0.125", "0.25"), make);
  ExpectSameOnRanks(OptionsOf("2=0.125", "0.25"), make);
}

TEST(MaterialWidthsOfMeshes, WrongInputIsAnError)
{
  EXPECT_NE(ErrorOf(OptionsOf("lead=0.2")).find("'lead'"), std::string::npos);
  EXPECT_NE(ErrorOf(OptionsOf("2=0.05")).find("Refinement"), std::string::npos);
  for (const RefinementMode mode :
    { RefinementMode::Automatic, RefinementMode::Coarsen, RefinementMode::Uniform })
  {
    MesherOptions options = OptionsOf("2=0.2");
    options.Refinement = mode;
    EXPECT_NE(ErrorOf(options).find("levels of the mesh itself"), std::string::npos);
  }
  EXPECT_TRUE(ReplacesCells(OptionsOf("auto")));
  EXPECT_FALSE(ReplacesCells(MesherOptions()));
}
