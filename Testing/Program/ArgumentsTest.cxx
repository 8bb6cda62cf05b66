/// The command line of sculptor: settings made by arguments, and the message and exit
/// code of each rejected argument.
#include "Arguments.h"
#include "ArgumentOptions.h"
#include "Options/SetOptions.h"

#include <gtest/gtest.h>

#include <array>
#include <sstream>

namespace vfm
{
namespace
{

using Words = std::vector<std::string>;
using Values = std::vector<std::pair<std::string, std::string>>;

/// Returns the words separated by blanks.
Words Split(const std::string& line)
{
  std::istringstream stream(line);
  return { std::istream_iterator<std::string>(stream), {} };
}

Arguments Parse(const std::string& line)
{
  return ParseArguments(Split(line));
}

/// Parses arguments that mesh in.vti.
Arguments ParseMesh(const std::string& line)
{
  return Parse("in.vti out.vtu " + line);
}

/// Returns the error message, which ends the program with exit code 1;
/// empty if the words are valid.
std::string RefusalOf(const Words& words)
{
  try
  {
    ParseArguments(words);
  }
  catch (const InputError& error)
  {
    EXPECT_EQ(error.Code(), ErrorCode::WrongArguments) << error.what();
    return error.what();
  }
  return "";
}

void ExpectRefusals(const std::string& begin, const Values& cases)
{
  for (const auto& [line, text] : cases)
  {
    const std::string message = RefusalOf(Split(begin + line));
    EXPECT_NE(message.find(text), std::string::npos) << begin << line << ": " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

/// Expects that all options of the mesher have these values, and the others their defaults.
void ExpectOptions(const Arguments& arguments, const Values& values, const std::string& line)
{
  MesherOptions expected;
  expected.Elements = arguments.Mesher.Elements;
  for (const auto& [name, value] : values)
  {
    SetOption(expected, name, value);
  }
  for (const Option& option : GetOptionTable())
  {
    EXPECT_EQ(GetOption(arguments.Mesher, option), GetOption(expected, option))
      << line << ": " << option.Name;
  }
}

TEST(Arguments, FilesWithAndWithoutOptions)
{
  for (const char* line : { "in.vti out.vtu", "--input in.vti --output out.vtu",
         "--output out.vtu in.vti", "in.vti --quiet --output=out.vtu", "in.vti --iso .3 out.vtu" })
  {
    const Arguments arguments = Parse(line);
    EXPECT_EQ(arguments.Task, Command::Mesh) << line;
    EXPECT_EQ(arguments.Input, "in.vti") << line;
    EXPECT_EQ(arguments.Output, "out.vtu") << line;
  }
}

TEST(Arguments, Surfaces)
{
  for (const char* line :
    { "a.stl b.OBJ out.vtu", "a.stl b.OBJ --output out.vtu", "--output out.vtu a.stl b.OBJ",
      "--input a.stl --input b.OBJ out.vtu", "--input a.stl --quiet b.OBJ out.vtu" })
  {
    const Arguments arguments = Parse(line);
    EXPECT_EQ(arguments.SurfaceFiles, Words({ "a.stl", "b.OBJ" })) << line;
    EXPECT_EQ(arguments.Output, "out.vtu") << line;
    EXPECT_FALSE(arguments.Cells || arguments.GridWidths) << line;
  }
  EXPECT_EQ(Parse("a.stl --output b.stl").SurfaceFiles, Words({ "a.stl" }));
  EXPECT_TRUE(Parse("in.vti out.stl").SurfaceFiles.empty());
  EXPECT_EQ(Parse("--list a.stl b.stl --cells 9").SurfaceFiles.size(), 2u);
  const Arguments cells = Parse("a.stl out.vtu --cells 80 --cell-width 2");
  EXPECT_EQ(cells.Cells, 80);
  EXPECT_FALSE(cells.GridWidths);
  EXPECT_EQ(cells.Mesher.CellWidth, "2"); // of the mesh
  const Arguments width = Parse("a.stl out.vtu --cell-width .5");
  EXPECT_EQ(width.GridWidths, (std::array<double, 3>{ 0.5, 0.5, 0.5 }));
  EXPECT_EQ(width.Mesher.CellWidth, "0"); // the grid has it
  EXPECT_EQ(Parse("a.stl out.vtu --cell-width 2 --material-widths a=1").Mesher.CellWidth, "2");
}

TEST(Arguments, ValuesOfTheProgram)
{
  const Arguments none = ParseMesh("");
  EXPECT_FALSE(none.Dimensions || none.Origin || none.Spacing || none.AxisOrder || none.Step ||
    none.Time || none.Form.IsSingle || none.Quiet || none.RefinesCells);
  EXPECT_TRUE(none.Fractions.empty() && none.Labels.empty() && none.Materials.empty());
  const Arguments voxels = Parse("in.spn out.e --dimensions 2,3,4 --origin -.5,0,1e3 "
                                 "--spacing=.1,.2,3 --axis-order ZYX --single-file --quiet");
  EXPECT_EQ(voxels.Dimensions, (std::array<int, 3>{ 2, 3, 4 }));
  EXPECT_EQ(voxels.Origin, (std::array<double, 3>{ -0.5, 0.0, 1e3 }));
  EXPECT_EQ(voxels.Spacing, (std::array<double, 3>{ 0.1, 0.2, 3.0 }));
  EXPECT_EQ(voxels.AxisOrder, 5);
  EXPECT_TRUE(voxels.Form.IsSingle && voxels.Quiet);
  const Arguments gmsh = Parse("in.vti out.msh --msh-version 4.1 --binary");
  EXPECT_TRUE(gmsh.Form.Version == GmshVersion::V4_1 && gmsh.Form.IsBinary);
  EXPECT_TRUE(none.Form.Version == GmshVersion::Automatic && !none.Form.IsBinary);
  const Arguments steps =
    ParseMesh("--step 0 --labels id --fragments f.csv --geometry g.vtm --report r.html");
  EXPECT_EQ(steps.Step, 0);
  EXPECT_EQ(steps.Labels, "id");
  EXPECT_EQ(steps.Fragments, "f.csv");
  EXPECT_EQ(steps.Geometry, "g.vtm");
  EXPECT_EQ(steps.Report, "r.html");
  EXPECT_EQ(ParseMesh("--time -1.5e-3").Time, -1.5e-3);
  EXPECT_TRUE(Parse("in.vti out.inp --plane stress").Form.IsPlaneStress);
  EXPECT_FALSE(Parse("in.vti out.inp --plane strain").Form.IsPlaneStress);
  EXPECT_FALSE(none.SetsFlat);
  EXPECT_TRUE(ParseMesh("--flat").SetsFlat && ParseMesh("--set flat=off").SetsFlat);
}

TEST(Arguments, Lists)
{
  const Arguments quoted = ParseArguments({ "in.vti", "out.vtu", "--fractions", "\"a, 1\", b",
    "--state", "p, x", "--state", "q", "--density", "rho, 1", "--density", "rho, 2" });
  const Arguments ranges =
    ParseArguments({ "in.vti", "out.vtu", "--threshold", "1:2", "--threshold=-3:1;5" });
  EXPECT_EQ(quoted.Fractions, Words({ "a, 1", "b" }));
  EXPECT_EQ(quoted.State, Words({ "p, x", "q", "rho, 1", "rho, 2" }));
  EXPECT_EQ(quoted.Mesher.DensityArrays, Words({ "rho, 1", "rho, 2" }));
  EXPECT_EQ(ranges.Mesher.Threshold, "1:2;-3:1;5");
  const Arguments arguments = ParseArguments({ "in.vti", "out.vtu", "--fractions", "ball, plate ",
    "--material=1,plate", "--state", "p,rho", "--density", "rho,rho - 2" });
  EXPECT_EQ(arguments.Fractions, (Words{ "ball", "plate" }));
  EXPECT_EQ(arguments.Materials, (Words{ "1", "plate" }));
  EXPECT_EQ(arguments.State, (Words{ "p", "rho", "rho - 2" })); // readers need densities too
  EXPECT_EQ(arguments.Mesher.DensityArrays, (Words{ "rho", "rho - 2" }));
  EXPECT_TRUE(ParseMesh("--material ALL").Materials.empty());
  EXPECT_EQ(ParseMesh("--material all,1").Materials, (Words{ "all", "1" }));
}

TEST(Arguments, OptionsOfTheMesher)
{
  const Values named{ { "Refinement", "Automatic" }, { "ThinCells", "0" },
    { "FineInterfaces", "off" } };
  const auto and_ = [&named](const Values& more)
  {
    Values all = named;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const std::string box = "--refine-box -1,.5,2,0,1,4", boxes = "-1,.5,2,0,1,4;1,2,3,2,3,4,2";
  const std::pair<std::string, Values> cases[] = {
    { "", {} },
    { "--stairstep", { { "StairStep", "on" } } },
    { "--no-smooth", { { "Smoothing", "Off" } } },
    { "--smooth 2", { { "Smoothing", "GeometryBased" } } },
    { "--smooth=geometrybased", { { "Smoothing", "GeometryBased" } } },
    { "--refine 1", { { "Refinement", "Uniform" }, { "MaximumLevel", "1" } } },
    { "--refine 2 --set Refinement=Coarsen",
      { { "Refinement", "Coarsen" }, { "MaximumLevel", "2" } } },
    { "--iso 0.3 --void", { { "IsoValue", "0.3" }, { "MeshVoid", "on" } } },
    { "--set IsoValue=.4 --iso 0.3", { { "IsoValue", "0.4" } } },
    { "--set targetscaledjacobian=.3 ConserveVolume=off",
      { { "TargetScaledJacobian", "0.3" }, { "ConserveVolume", "off" } } },
    { "--set=ComputeQuality=no --set NumberOfThreads=2",
      { { "ComputeQuality", "off" }, { "NumberOfThreads", "2" } } },
    { "--tetmesh lattice", { { "Method", "Lattice" } } },
    { "--set Method=1 --tetmesh", { { "Method", "Cells" } } },
    { "--aspect 1.5", { { "MaximumAspectRatio", "1.5" } } },
    { "--sharp-edges on", { { "SharpEdges", "On" } } },
    { "--surface-targets off --edge-angle 30",
      { { "SurfaceTargets", "Off" }, { "EdgeAngle", "30" } } },
    { "--clip 0.01", { { "FractionTolerance", "0.01" } } },
    { "--label-smoothing 2", { { "LabelSmoothing", "2" } } },
    { "--minimum-region 2", { { "MinimumRegionCells", "2" } } },
    { "--label-names a.txt", { { "LabelNames", "a.txt" } } },
    { "--density a,b --velocity v --energy e --nodal-velocity --state-kinds s=volume "
      "--lost-kinetic-energy internalenergy --unmeshed drop --state-order 1 "
      "--state-transfer conserve --rotated v,s",
      { { "DensityArrays", "a,b" }, { "VelocityArray", "v" }, { "EnergyArray", "e" },
        { "NodalVelocity", "on" }, { "StateKinds", "s=volume" },
        { "LostKineticEnergy", "InternalEnergy" }, { "UnmeshedMaterial", "Drop" },
        { "StateOrder", "1" }, { "StateTransfer", "Conserve" }, { "RotatedArrays", "v,s" } } },
    { "--refine-cells wish", and_({ { "RefinementArray", "wish" } }) },
    { box, and_({ { "RefinementBoxes", "-1,.5,2,0,1,4" } }) },
    { box + " --refine-box=1,2,3,2,3,4,2", and_({ { "RefinementBoxes", boxes } }) },
    { "--set FineInterfaces=on MaximumLevel=1 ThinCells=2 " + box,
      { { "Refinement", "Automatic" }, { "ThinCells", "2" }, { "MaximumLevel", "1" },
        { "RefinementBoxes", "-1,.5,2,0,1,4" } } },
  };
  for (const auto& [line, values] : cases)
  {
    ExpectOptions(ParseMesh(line), values, line);
  }
  EXPECT_EQ(ParseArguments({ "in.vti", "out.e", "--set", " iso value = .3" }).Mesher.IsoValue, 0.3);
}

TEST(Arguments, EachOptionWithANameTakesIt)
{
  for (const Option& option : GetOptionTable())
  {
    const Words words = Split(option.Argument);
    if (words.size() == 2 && option.Kind != OptionKind::Kinds)
    {
      const std::string value = GetOption(MesherOptions(), option);
      EXPECT_EQ(RefusalOf({ "in.vti", "out.vtu", words[0], value }), "") << option.Name;
    }
  }
}

TEST(Arguments, Tasks)
{
  EXPECT_EQ(Parse("--help --wrong").Task, Command::Help);
  EXPECT_EQ(Parse("in.vti -h").Task, Command::Help);
  EXPECT_EQ(Parse("test --version").Task, Command::Version);
  EXPECT_EQ(Parse("--list in.vti --step 1").Task, Command::List);
  EXPECT_EQ(Parse("in.spn --list --dimensions 1,2,3 --spacing 1,1,1").Input, "in.spn");
  const Arguments test =
    Parse("test --tetmesh Cells --refine-cells --material 1 --quiet --output a.e");
  EXPECT_EQ(test.Task, Command::Test);
  EXPECT_EQ(test.Mesher.Elements, ElementKind::Tets);
  EXPECT_TRUE(test.RefinesCells && test.Quiet);
  EXPECT_EQ(test.Output, "a.e");
  ExpectOptions(test,
    { { "Method", "Cells" }, { "Refinement", "Automatic" }, { "ThinCells", "0" },
      { "FineInterfaces", "off" } },
    "test");
  ExpectOptions(Parse("test --stairstep --smooth 2 --refine 2"),
    { { "StairStep", "on" }, { "Smoothing", "2" }, { "Refinement", "Uniform" },
      { "MaximumLevel", "2" } },
    "test");
}

TEST(Arguments, RejectedWords)
{
  ExpectRefusals("",
    { { "", "--input FILE is missing. See sculptor --help." },
      { "in.vti", "--output FILE is missing, as in sculptor in.vti mesh.vtu." },
      { "in.vti out.vtu c.vtu",
        "'c.vtu' is one file too many: the input and the output are already given." },
      { "in.vti out.vtu --output b.vtu",
        "'out.vtu' is one file too many: the input and the output are already given." },
      { "--input in.vti --input b.vti --output out.vtu", "--input is given twice." },
      { "part.stl in.vti out.vtu",
        "Surfaces can only be meshed with surfaces, but of the inputs part.stl is a surface and "
        "in.vti is not." },
      { "in.vti part.stl out.vtu", "part.stl is a surface and in.vti is not." },
      { "part.stl other.stl",
        "--output FILE is missing, as in sculptor part.stl other.stl mesh.vtu." },
      { "in.vti out.vtu --cells 9", "--cells is for surfaces: .stl" },
      { "part.stl out.vtu --cells 4", "--cells takes an integer from 5, not '4'." },
      { "part.stl out.vtu --cell-width 0,1,1",
        "--cell-width of surfaces takes widths above 0, not '0,1,1'." },
      { "part.stl out.vtu --spacing 1,1,1", "--spacing is for .nii" },
      { "tset", "The input tset is of an unknown format. Supported formats: .vti" },
      { "in.xyz out.vtu", "The input in.xyz is of an unknown format. Supported formats: .vti" },
      { "in.vti no.xyz", "The output no.xyz is of an unknown format. Supported formats: .vtu" },
      { "in.vti no.xyz", ".inp" },
      { "in.vti out.vtu --binary",
        "The output out.vtu has no binary form. Formats that have it: .msh" },
      { "in.vti out.msh --msh-version 3", "--msh-version takes 2.2 or 4.1, not '3'." },
      { "in.vti out.pvtu --single-file", "The output out.pvtu always consists of several files." },
      { "in.vti out.vtu --geometry g.vtu",
        "The geometry g.vtu is of an unknown format. Supported format: .vtm." },
      { "in.vti out.vtu --report r.pdf",
        "The report r.pdf is of an unknown format. Supported formats: .html, .htm." } });
  ExpectRefusals("in.vti out.vtu ",
    { { "--wrong", "'--wrong' is not an option. See sculptor --help." },
      { "--wrong=1", "'--wrong' is not an option." }, { "-q", "'-q' is not an option." },
      { "--", "'--' is not an option." },
      { "--void=on", "--void takes no value, but 'on' is given." },
      { "--quiet=", "--quiet takes no value, but '' is given." },
      { "--iso 0.3 --iso 0.4", "--iso is given twice." },
      { "--void --void", "--void is given twice." },
      { "--refine-cells", "--refine-cells needs a value." },
      { "--iso --void", "--iso needs a value." }, { "--iso= --void", "--iso needs a value." },
      { "--geometry", "--geometry needs a value." }, { "--set", "--set needs a value." },
      { "--fractions a --labels b", "--fractions and --labels exclude each other." },
      { "--step 1 --time 1", "--step and --time exclude each other." },
      { "--smooth 1 --no-smooth", "--smooth and --no-smooth exclude each other." },
      { "--refine 1 --refine-cells plate", "--refine and --refine-cells exclude each other." },
      { "--refine 1 --refine-box 0,0,0,1,1,1", "--refine and --refine-box exclude each other." } });
  EXPECT_EQ(RefusalOf({ "" }), "'' is not an option. See sculptor --help.");
  EXPECT_EQ(RefusalOf({ "in.vti", "out.vtu", "--labels", "" }),
    "--labels needs a value. See sculptor --help.");
}

TEST(Arguments, FolderOfSurfaces)
{
  for (const auto& [given, folder, surfaces] :
    std::vector<std::array<std::string, 3>>{ { "parts", "parts", "parts/{}.stl" },
      { "a.b/parts/", "a.b/parts", "a.b/parts/{}.stl" }, { "..", "..", "../{}.stl" },
      { "parts.obj", "", "parts.obj" }, { "a/{}.stl", "", "a/{}.stl" } })
  {
    const Arguments found = ParseMesh("--surfaces " + given);
    EXPECT_EQ(found.SurfaceFolder, folder) << given;
    EXPECT_EQ(found.Surfaces, surfaces) << given;
  }
}

TEST(Arguments, Bins)
{
  const Arguments plain = ParseMesh("--bins grey,20 --state heat");
  ASSERT_TRUE(plain.Bins);
  EXPECT_EQ(plain.Bins->Array, "grey");
  EXPECT_EQ(plain.Bins->Count, 20);
  EXPECT_FALSE(plain.Bins->Law);
  EXPECT_EQ(plain.State, (std::vector<std::string>{ "heat", "grey" }));
  const Arguments law = ParseMesh("--bins grey,5,6850,1.49");
  ASSERT_TRUE(law.Bins && law.Bins->Law);
  EXPECT_EQ(law.Bins->Law->Factor, 6850.0);
  EXPECT_EQ(law.Bins->Law->Exponent, 1.49);
  EXPECT_EQ(law.Bins->Law->Poisson, 0.3);
  EXPECT_EQ(law.Bins->Law->Slope, 1.0);
  const Arguments all = ParseMesh("--bins grey,5,2,-1,0.25,0.1,1e-3");
  ASSERT_TRUE(all.Bins && all.Bins->Law);
  EXPECT_EQ(all.Bins->Law->Exponent, -1.0);
  EXPECT_EQ(all.Bins->Law->Poisson, 0.25);
  EXPECT_EQ(all.Bins->Law->Offset, 0.1);
  EXPECT_EQ(all.Bins->Law->Slope, 1e-3);
}

TEST(Arguments, RejectedValues)
{
  for (const char* wrong : { "grey", "grey,0", "grey,2.5", "grey,10001", "grey,5,1", "grey,5,1,inf",
         "grey,5,1,2,0.3,4", "grey,5,1,2,0.3,4,5,6", ",5" })
  {
    ExpectRefusals(
      "in.vti out.inp --bins ", { { wrong, "--bins takes ARRAY,COUNT, or with A,B" } });
  }
  ExpectRefusals("in.vti out.vtu ",
    { { "--fractions a,,b", "--fractions contains an empty name." },
      { "--fractions a,a", "--fractions contains 'a' twice." },
      { "--fractions a --fractions a", "--fractions contains 'a' twice." },
      { "--threshold 1 --fractions a", "--threshold and --fractions exclude each other." },
      { "--threshold 1 --material 2", "--threshold and --material exclude each other." },
      { "--threshold 2:1", "The option Threshold cannot be '2:1'" },
      { "--zero-label grain", "The option ZeroLabel cannot be 'grain'" },
      { "--state a,", "--state contains an empty name." },
      { "--material 1,2,1", "--material contains '1' twice." },
      { "--time 2s", "--time takes a number, not '2s'." },
      { "--time nan", "--time takes a number, not 'nan'." },
      { "--plane bent", "--plane takes strain or stress, not 'bent'." },
      { "--plane stress",
        "The output out.vtu has no choice of plane stress. Formats that have it: .inp, .k, .key, "
        ".bdf, .nas." },
      { "--step -1", "--step takes an integer from 0, not '-1'." },
      { "--step 1.5", "--step takes an integer from 0, not '1.5'." },
      { "--refine -1", "--refine takes an integer from 0 to 10, not '-1'." },
      { "--refine 11", "--refine takes an integer from 0 to 10, not '11'." },
      { "--surfaces s.vtp",
        "The surfaces s.vtp are of an unknown format. Supported formats: .stl, .obj. A name "
        "without "
        "a dot is a folder." },
      { "--surfaces {}/s_{}.stl", "has {} for the name of a material in its folder or twice." },
      { "--set IsoValue", "--set takes Option=Value, not 'IsoValue'." },
      { "--set IsoValue=.3 x.vti", "--set takes Option=Value, not 'x.vti'." } });
  ExpectRefusals("in.spn out.vtu ",
    { { "", "The input in.spn does not contain its size: --dimensions NX,NY,NZ is missing." },
      { "--dimensions 9,11",
        "--dimensions takes three numbers of cells separated by commas, not '9,11'." },
      { "--dimensions 9,11,0", "takes three numbers of cells separated by commas" },
      { "--dimensions 9,11,1.5", "takes three numbers of cells separated by commas" },
      { "--dimensions 9,11,2147483647", "takes three numbers of cells separated by commas" },
      { "--dimensions 9,11,1,1", "takes three numbers of cells separated by commas" },
      { "--origin 1,2,x", "--origin takes three numbers separated by commas, not '1,2,x'." },
      { "--origin 1,2,inf", "--origin takes three numbers separated by commas" },
      { "--spacing 1,0,1",
        "--spacing takes three numbers above 0 separated by commas, not '1,0,1'." },
      { "--axis-order xxz",
        "--axis-order takes xyz, xzy, yxz, yzx, zxy or zyx, or its number from 0, not 'xxz'." } });
  ExpectRefusals("",
    { { "in.npy a.vtu --dimensions 1,2,3", "--dimensions is for .spn files." },
      { "in.vti a.vtu --origin 0,0,0", "--origin and --axis-order are for .spn and .npy files." },
      { "in.nii a.vtu --axis-order xyz", "--origin and --axis-order are for .spn and .npy files." },
      { "in.vti a.vtu --spacing 1,1,1", "--spacing is for .nii, .nii.gz, .mgz" },
      { "in.vti a.vtu --volume 1", "--volume is for .nii, .nii.gz, .mgz" },
      { "in.nii a.vtu --volume -1", "--volume takes an integer from 0, not '-1'." } });
}

TEST(Arguments, RejectedOptionsOfTheMesher)
{
  ExpectRefusals("in.vti out.vtu ",
    { { "--iso 0,5", "The option IsoValue cannot be '0,5': it takes" },
      { "--smooth 3", "QuadricSurface" },
      { "--sharp-edges round", "The option SharpEdges cannot be 'round'" },
      { "--edge-angle 180", "The option EdgeAngle cannot be '180'" },
      { "--surface-targets maybe", "The option SurfaceTargets cannot be 'maybe'" },
      { "--clip 0.2", "The option FractionTolerance cannot be '0.2'" },
      { "--label-smoothing 11", "The option LabelSmoothing cannot be '11'" },
      { "--minimum-region -1", "The option MinimumRegionCells cannot be '-1'" },
      { "--aspect 1.05",
        "MaximumAspectRatio cannot be '1.05': it takes 0 (off) or a number, 1.1 or more" },
      { "--refine-box 0,0,0,1,1", "The option RefinementBoxes cannot be '0,0,0,1,1'" },
      { "--refine-box 0,0,0,1,1,1,11", "The option RefinementBoxes cannot be '0,0,0,1,1,1,11'" },
      { "--set Wrong=1", "There is no option 'Wrong'" },
      { "--set Method=Cells", "applies to tetrahedra only, and the mesh has hexahedra." },
      { "--tetmesh Wrong", "The option Method cannot be 'Wrong'" },
      { "--tetmesh=", "--tetmesh needs a value." },
      { "--state-transfer keep", "The option StateTransfer cannot be 'keep'" },
      { "--state-kinds velocity", "The option StateKinds cannot be 'velocity'" },
      { "--state-order 3", "The option StateOrder cannot be '3'" },
      { "--set Refinement=Coarse", "The option Refinement cannot be 'Coarse'" },
      { "--set MaximumLevel=many", "The option MaximumLevel cannot be 'many'" },
      { "--set FineLayers=1.5", "The option FineLayers cannot be '1.5'" },
      { "--set FineInterfaces=perhaps", "The option FineInterfaces cannot be 'perhaps'" },
      { "--set RefineFlippedCells=perhaps", "The option RefineFlippedCells cannot be 'perhaps'" },
      { "--set ThinCells=x", "The option ThinCells cannot be 'x'" },
      { "--velocity v", "--velocity and --energy require conserved state" },
      { "--density rho --energy e --state-transfer copy", "--state-transfer Conserve" } });
}

TEST(Arguments, RejectedTestsAndLists)
{
  ExpectRefusals("test ",
    { { "--input in.vti", "sculptor test takes --tetmesh, --stairstep, " },
      { "in.vti", "not --input." }, { "--set IsoValue=0.4", "not --set." },
      { "--refine-box 0,0,0,1,1,1", "not --refine-box." },
      { "--geometry g.vtm", "not --geometry." },
      { "--refine 1 --refine-cells", "--refine and --refine-cells exclude each other." },
      { "--refine-cells=a", "--refine-cells takes no value, but 'a' is given." },
      { "--refine -1", "--refine takes an integer from 0 to 10, not '-1'." },
      { "--output no.xyz", "The output no.xyz is of an unknown format." } });
  ExpectRefusals("--list ",
    { { "", "--input FILE is missing." }, { "in.xyz", "The input in.xyz is of an unknown format." },
      { "in.spn", "--dimensions NX,NY,NZ is missing." },
      { "in.vti out.vtu", "--list takes --input, --cells, " },
      { "in.vti out.vtu", "not --output." }, { "in.vti --void", "not --void." },
      { "in.vti --step 1 --time 2", "--step and --time exclude each other." } });
}

TEST(Arguments, HelpNamesAllOptionsAndFormats)
{
  const std::string help = GetHelp();
  for (const ArgumentOption& option : GetArgumentOptions())
  {
    EXPECT_NE(help.find(option.Name), std::string::npos) << option.Name;
  }
  for (const Option& option : GetOptionTable())
  {
    EXPECT_NE(help.find("\n  " + option.Name), std::string::npos) << option.Name;
  }
  for (const char* word : { "usage:", ".pvti", ".inp", "Exit codes" })
  {
    EXPECT_NE(help.find(word), std::string::npos) << word;
  }
}

} // namespace
} // namespace vfm
