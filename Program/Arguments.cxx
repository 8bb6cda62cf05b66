#include "Arguments.h"

#include "ArgumentOptions.h"
#include "ArgumentWords.h"
#include "Base/ParseText.h"
#include "FileSuffix.h"
#include "ImageInput.h"
#include "Images/ImageFile.h"
#include "Meshes/Surfaces/MaterialSkins.h"
#include "Meshes/Vtk/WriteGeometry.h"
#include "Options/CellWidths.h"
#include "Options/MaterialWidths.h"
#include "Options/SetOptions.h"
#include "ReadInput.h"
#include "Report/WriteReport.h"
#include "Shapes/PlaceGrid.h"
#include "State/ArrayStems.h"
#include "State/StateChoice.h"
#include "Surfaces/ReadSurface.h"

#include <algorithm>
#include <limits>
#include <set>

namespace vfm
{
namespace
{

constexpr double LargestNumber = std::numeric_limits<double>::max();
constexpr int LargestCount = std::numeric_limits<int>::max();

std::vector<std::string> ValuesOf(const GivenArguments& given, const std::string& name)
{
  const auto found = given.find(name);
  return found == given.end() ? std::vector<std::string>() : found->second;
}

/// Returns the value of an option, several values joined by semicolons; empty if it is not given.
std::string TextOf(const GivenArguments& given, const std::string& name)
{
  return JoinTexts(ValuesOf(given, name), ";");
}

/// Returns the parsed value of an option; nothing if it is not given.
/// @param takes  description of valid values
template <class Parse>
auto ReadValue(
  const GivenArguments& given, const std::string& name, const std::string& takes, Parse parse)
{
  const std::string text = TextOf(given, name);
  const auto value = text.empty() ? std::nullopt : parse(text);
  if (!text.empty() && !value)
  {
    RejectArguments(name + " takes " + takes + ", not '" + text + "'.");
  }
  return value;
}

/// Returns three values that are separated by commas.
template <class Value>
std::optional<std::array<Value, 3>> ReadThree(const GivenArguments& given, const std::string& name,
  const std::string& what, std::optional<Value> parse(const std::string&, Value, Value),
  Value least, Value most)
{
  const auto parseAll = [=](const std::string& text) -> std::optional<std::array<Value, 3>>
  {
    const std::vector<std::string> parts = SplitText(text);
    std::array<Value, 3> values{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto value = parts.size() == 3 ? parse(parts[i], least, most) : std::nullopt;
      if (!value)
      {
        return std::nullopt;
      }
      values[i] = *value;
    }
    return values;
  };
  return ReadValue(given, name, "three " + what + " separated by commas", parseAll);
}

std::optional<int> ReadCount(
  const GivenArguments& given, const std::string& name, const std::string& range, int most)
{
  return ReadValue(given, name, "an integer from 0" + range,
    [=](const std::string& text) { return ParseCount(text, 0, most); });
}

/// Returns names that are separated by commas, or the value of each occurrence of an option that is
/// given several times. The names must differ.
std::vector<std::string> ReadList(const GivenArguments& given, const std::string& name)
{
  if (given.count(name) == 0)
  {
    return {};
  }
  const std::vector<std::string> values = ValuesOf(given, name);
  std::vector<std::string> list = values.size() > 1 ? values : SplitText(values[0]);
  if (std::find(list.begin(), list.end(), "") != list.end())
  {
    RejectArguments(name + " contains an empty name.");
  }
  std::set<std::string> seen;
  const auto twice = std::find_if(list.begin(), list.end(),
    [&seen](const std::string& item) { return !seen.insert(item).second; });
  if (twice != list.end())
  {
    RejectArguments(name + " contains '" + *twice + "' twice.");
  }
  return list;
}

using Settings = std::vector<std::pair<std::string, std::string>>;

/// Returns the value of an option of the mesher as one text. Names of arrays that are given one by
/// one are quoted, because they may contain commas.
std::string TextOfOption(const GivenArguments& given, const ArgumentOption& option)
{
  std::vector<std::string> values = ValuesOf(given, option.Name);
  const Option* ofMesher = FindOption(option.MesherOption);
  if (values.size() < 2 || !ofMesher || ofMesher->Kind != OptionKind::Arrays)
  {
    return TextOf(given, option.Name);
  }
  std::transform(values.begin(), values.end(), values.begin(), QuoteName);
  return JoinTexts(values);
}

/// Returns the settings implied by options of refinement. If cells or boxes are given, only these
/// cells are refined.
Settings ListRefinement(const GivenArguments& given)
{
  const std::optional<int> halvings =
    ReadCount(given, "--refine", " to " + std::to_string(MaximumHalvings), MaximumHalvings);
  if (halvings)
  {
    return { { "Refinement", "Uniform" }, { "MaximumLevel", std::to_string(*halvings) } };
  }
  if (given.count("--refine-cells") + given.count("--refine-box") > 0)
  {
    return { { "Refinement", "Automatic" }, { "ThinCells", "0" }, { "FineInterfaces", "off" } };
  }
  return {};
}

/// Returns options of the mesher and their values. Values of --set are last and replace others.
Settings ListSettings(const GivenArguments& given)
{
  Settings settings = ListRefinement(given);
  if (given.count("--no-smooth") > 0)
  {
    settings.emplace_back("Smoothing", "Off");
  }
  for (const ArgumentOption& option : GetArgumentOptions())
  {
    const std::string value = option.Value.empty() ? "on" : TextOfOption(given, option);
    if (given.count(option.Name) > 0 && !option.MesherOption.empty() && !value.empty())
    {
      settings.emplace_back(option.MesherOption, value);
    }
  }
  for (const std::string& word : ValuesOf(given, "--set"))
  {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos)
    {
      RejectArguments("--set takes Option=Value, not '" + word + "'.");
    }
    settings.emplace_back(TrimText(word.substr(0, equals)), TrimText(word.substr(equals + 1)));
  }
  return settings;
}

/// Returns whether a setting is one of the option Flat.
bool IsOfFlat(const std::pair<std::string, std::string>& setting)
{
  const Option* option = FindOption(setting.first);
  return option && option->Name == "Flat";
}

MesherOptions ReadOptions(const GivenArguments& given)
{
  MesherOptions options;
  options.Elements = given.count("--tetmesh") > 0 ? ElementKind::Tets : ElementKind::Hexes;
  ClassifyErrors(ErrorCode::WrongArguments,
    [&]
    {
      for (const auto& [name, value] : ListSettings(given))
      {
        SetOption(options, name, value);
      }
    });
  return options;
}

OutputForm ReadForm(const GivenArguments& given)
{
  OutputForm form;
  form.IsSingle = given.count("--single-file") > 0;
  form.Version = ReadValue(given, "--msh-version", "2.2 or 4.1", ParseGmshVersion)
                   .value_or(GmshVersion::Automatic);
  form.IsBinary = given.count("--binary") > 0;
  form.HasInterfaces = given.count("--no-interfaces") == 0;
  form.IsReduced = given.count("--reduced") > 0;
  form.IsPlaneStress =
    ReadValue(given, "--plane", "strain or stress", ParsePlaneStress).value_or(false);
  form.IsDual = given.count("--polyhedra") > 0;
  return form;
}

/// Reads the array and the number of bins, and the numbers of the law.
std::optional<BinRule> ParseBins(const std::string& text)
{
  const std::vector<std::string> parts = SplitText(text);
  const std::optional<int> count =
    parts.size() > 1 ? ParseCount(parts[1], 1, LargestBinCount) : std::nullopt;
  const std::set<std::size_t> lengths{ 2, 4, 5, 7 };
  if (!count || parts[0].empty() || lengths.count(parts.size()) == 0)
  {
    return std::nullopt;
  }
  BinRule rule{ parts[0], *count, {}, std::nullopt };
  ElasticLaw law;
  double* const numbers[] = { &law.Factor, &law.Exponent, &law.Poisson, &law.Offset, &law.Slope };
  for (std::size_t p = 2; p < parts.size(); ++p)
  {
    const std::optional<double> number = ParseNumber(parts[p], -LargestNumber, LargestNumber);
    if (!number)
    {
      return std::nullopt;
    }
    *numbers[p - 2] = *number;
    rule.Law = law;
  }
  return rule;
}

/// Makes the cell width that of the grid around surfaces, unless the number of its cells is given.
void TakeGridWidths(Arguments& to)
{
  MesherOptions& mesher = to.Mesher;
  const Vector3 widths = *ParseWidths(mesher.CellWidth);
  if (to.SurfaceFiles.empty() || to.Cells || widths == Vector3{})
  {
    return;
  }
  if (std::find(widths.begin(), widths.end(), 0.0) != widths.end())
  {
    RejectArguments(
      "--cell-width of surfaces takes widths above 0, not '" + mesher.CellWidth + "'.");
  }
  to.GridWidths = widths;
  if (!HasMaterialWidths(mesher))
  {
    mesher.CellWidth = "0";
  }
}

/// Checks that there is one input, or only surfaces.
void CheckInputs(const std::vector<std::string>& inputs)
{
  const auto surface = std::find_if(inputs.begin(), inputs.end(), IsSurfaceFile);
  const auto other = std::find_if_not(inputs.begin(), inputs.end(), IsSurfaceFile);
  if (surface != inputs.end() && other != inputs.end())
  {
    RejectArguments("Surfaces can only be meshed with surfaces, but of the inputs " + *surface +
      " is a surface and " + *other + " is not.");
  }
  if (other != inputs.end() && inputs.size() > 1)
  {
    RejectArguments("--input is given twice.");
  }
}

Arguments ReadValues(const GivenArguments& given)
{
  Arguments to;
  const std::vector<std::string> inputs = ValuesOf(given, "--input");
  to.Input = JoinTexts(inputs);
  CheckInputs(inputs);
  if (!inputs.empty() && IsSurfaceFile(inputs[0]))
  {
    to.SurfaceFiles = inputs;
  }
  to.Cells = ReadValue(given, "--cells", "an integer from " + std::to_string(LeastPlacedCells),
    [](const std::string& text)
    { return ParseCount(text, static_cast<int>(LeastPlacedCells), LargestCount - 1); });
  to.Output = TextOf(given, "--output");
  to.Dimensions =
    ReadThree(given, "--dimensions", "numbers of cells", ParseCount, 1, LargestCount - 1);
  to.Origin = ReadThree(given, "--origin", "numbers", ParseNumber, -LargestNumber, LargestNumber);
  to.Spacing = ReadThree(given, "--spacing", "numbers above 0", ParseNumber,
    std::numeric_limits<double>::min(), LargestNumber);
  to.Volume = ReadCount(given, "--volume", "", LargestCount);
  to.AxisOrder =
    ReadValue(given, "--axis-order", "xyz, xzy, yxz, yzx, zxy or zyx, or its number from 0",
      [](const std::string& text) {
        return ParseChoice(text, { "xyz", "xzy", "yxz", "yzx", "zxy", "zyx" });
      });
  to.Fragments = TextOf(given, "--fragments");
  to.Geometry = TextOf(given, "--geometry");
  to.Surfaces = TextOf(given, "--surfaces");
  to.SurfaceFolder = FindSurfaceFolder(to.Surfaces);
  if (!to.SurfaceFolder.empty())
  {
    to.Surfaces = to.SurfaceFolder + "/" + MaterialPlace + ".stl";
  }
  to.Report = TextOf(given, "--report");
  to.Fractions = ReadList(given, "--fractions");
  const std::vector<std::string> levelSets = ReadList(given, "--level-set");
  to.Fractions.insert(to.Fractions.end(), levelSets.begin(), levelSets.end());
  to.Labels = TextOf(given, "--labels");
  to.Materials = ReadList(given, "--material");
  if (to.Materials.size() == 1 && IsSameWord(to.Materials[0], "all"))
  {
    to.Materials.clear();
  }
  to.State = ReadList(given, "--state");
  to.Bins = ReadValue(given, "--bins",
    "ARRAY,COUNT, or with A,B or A,B,V or A,B,V,C0,C1 after it, COUNT from 1 to " +
      std::to_string(LargestBinCount),
    ParseBins);
  to.RefinesCells = given.count("--refine-cells") > 0;
  to.Mesher = ReadOptions(given);
  const Settings settings = ListSettings(given);
  to.SetsFlat = std::any_of(settings.begin(), settings.end(), IsOfFlat);
  if (!levelSets.empty() && to.Mesher.LevelSets == LevelSetRule::Off)
  {
    to.Mesher.LevelSets = LevelSetRule::Priority;
  }
  to.Step = ReadCount(given, "--step", "", LargestCount);
  to.Time = ReadValue(given, "--time", "a number",
    [](const std::string& text) { return ParseNumber(text, -LargestNumber, LargestNumber); });
  to.Form = ReadForm(given);
  to.TrustsInput = given.count("--trust-input") > 0;
  to.Quiet = given.count("--quiet") > 0;
  TakeGridWidths(to);
  return to;
}

void CheckVoxels(const Arguments& from)
{
  const bool isText = HasSuffix(from.Input, ".spn");
  if (isText && !from.Dimensions)
  {
    RejectArguments(
      "The input " + from.Input + " does not contain its size: --dimensions NX,NY,NZ is missing.");
  }
  if (!isText && from.Dimensions)
  {
    RejectArguments("--dimensions is for .spn files.");
  }
  const bool isVoxels = IsVoxelFile(from.Input);
  if (!isVoxels && (from.Origin || from.AxisOrder))
  {
    RejectArguments("--origin and --axis-order are for .spn and .npy files.");
  }
  if (!IsImageFile(from.Input) && from.Volume)
  {
    RejectArguments("--volume is for " + JoinTexts(GetImageSuffixes()) + " files.");
  }
  if (!isVoxels && !IsImageFile(from.Input) && from.Spacing)
  {
    RejectArguments("--spacing is for " + JoinTexts(GetImageSuffixes()) + ", .spn and .npy files.");
  }
}

void CheckInput(const Arguments& from)
{
  if (from.Input.empty())
  {
    RejectArguments("--input FILE is missing.");
  }
  if (from.SurfaceFiles.empty())
  {
    CheckInputSuffix(from.Input);
  }
  if (from.SurfaceFiles.empty() && from.Cells)
  {
    RejectArguments("--cells is for surfaces: " + JoinTexts(GetSurfaceSuffixes()) + ".");
  }
  CheckVoxels(from);
}

/// Rejects the arguments with a message, unless it is empty.
void CheckProblem(const std::string& problem)
{
  if (!problem.empty())
  {
    RejectArguments(problem);
  }
}

void CheckOutput(const Arguments& from)
{
  CheckProblem(FindOutputProblem(from.Output, from.Form));
}

void CheckMesh(const Arguments& from)
{
  CheckInput(from);
  if (from.Output.empty())
  {
    RejectArguments("--output FILE is missing, as in sculptor " +
      (from.SurfaceFiles.empty() ? from.Input : JoinTexts(from.SurfaceFiles, " ")) + " mesh.vtu.");
  }
  CheckProblem(from.Geometry.empty() ? "" : FindGeometryProblem(from.Geometry));
  CheckProblem(from.Surfaces.empty() ? "" : FindSurfaceProblem(from.Surfaces));
  CheckProblem(from.Report.empty() ? "" : FindReportProblem(from.Report));
  CheckOutput(from);
}

/// Rejects a velocity or energy array if the state is copied, because the mesh would lack it.
void CheckConserved(const MesherOptions& options)
{
  const bool isConserved = ConservesState(options.StateTransfer, options.DensityArrays);
  if (!isConserved && !(options.VelocityArray + options.EnergyArray).empty())
  {
    RejectArguments("--velocity and --energy require conserved state: add --density ARRAY or "
                    "--state-transfer Conserve. To copy arrays, list them in --state.");
  }
}

/// Adds the densities and the array of bins to the arrays that readers read.
void AddState(Arguments& to)
{
  std::vector<std::string> names = to.Mesher.DensityArrays;
  if (to.Bins)
  {
    names.push_back(to.Bins->Array);
  }
  for (const std::string& name : names)
  {
    if (std::find(to.State.begin(), to.State.end(), name) == to.State.end())
    {
      to.State.push_back(name);
    }
  }
}

void CheckExclusive(const GivenArguments& given)
{
  for (const auto& [one, other] :
    { std::pair("--step", "--time"), { "--fractions", "--labels" }, { "--smooth", "--no-smooth" },
      { "--refine", "--refine-cells" }, { "--refine", "--refine-box" },
      { "--threshold", "--fractions" }, { "--threshold", "--material" },
      { "--level-set", "--fractions" }, { "--level-set", "--labels" },
      { "--level-set", "--threshold" }, { "--level-set", "--material" } })
  {
    if (given.count(one) + given.count(other) == 2)
    {
      RejectArguments(std::string(one) + " and " + other + " exclude each other.");
    }
  }
}

/// Rejects options that a task does not take.
/// @param task  name of the task, for the message
void CheckTaken(
  const GivenArguments& given, const std::string& task, const std::vector<std::string>& taken)
{
  for (const auto& argument : given)
  {
    if (std::find(taken.begin(), taken.end(), argument.first) == taken.end())
    {
      RejectArguments(task + " takes " + JoinTexts(taken) + ", not " + argument.first + ".");
    }
  }
}

Command FindTask(const GivenArguments& given, bool isTest)
{
  const auto has = [&given](const char* name) { return given.count(name) > 0; };
  return has("--help") ? Command::Help
    : has("--version") ? Command::Version
    : isTest           ? Command::Test
    : has("--list")    ? Command::List
                       : Command::Mesh;
}

} // namespace

std::vector<std::string> ListOtherArrays(
  const Arguments& arguments, const std::vector<std::string>& there)
{
  const MesherOptions& mesher = arguments.Mesher;
  std::vector<std::string> names = arguments.State, ofVelocity;
  std::copy_if(there.begin(), there.end(), std::back_inserter(ofVelocity),
    [&mesher](const std::string& name) { return IsOfVector(name, mesher.VelocityArray); });
  if (ofVelocity.empty())
  {
    ofVelocity.push_back(mesher.VelocityArray);
  }
  names.insert(names.end(), ofVelocity.begin(), ofVelocity.end());
  names.insert(names.end(), { mesher.EnergyArray, mesher.RefinementArray });
  names.erase(std::remove(names.begin(), names.end(), ""), names.end());
  return names;
}

Arguments ParseArguments(const std::vector<std::string>& words)
{
  const bool isTest = !words.empty() && words[0] == "test";
  const GivenArguments given = ReadWords({ words.begin() + (isTest ? 1 : 0), words.end() }, isTest);
  CheckExclusive(given);
  Arguments arguments = ReadValues(given);
  arguments.Task = FindTask(given, isTest);
  switch (arguments.Task)
  {
    case Command::Test: // makes its own input
      CheckTaken(given, "sculptor test",
        { "--tetmesh", "--stairstep", "--smooth", "--no-smooth", "--material", "--refine",
          "--refine-cells", "--output", "--quiet" });
      if (!arguments.Output.empty())
      {
        CheckOutput(arguments);
      }
      break;
    case Command::List:
      CheckTaken(given, "--list",
        { "--input", "--cells", "--cell-width", "--dimensions", "--origin", "--spacing", "--volume",
          "--axis-order", "--step", "--time", "--trust-input", "--list" });
      CheckInput(arguments);
      break;
    case Command::Mesh:
      CheckMesh(arguments);
      AddState(arguments);
      CheckConserved(arguments.Mesher);
      break;
    case Command::Help:
    case Command::Version:
      break;
  }
  return arguments;
}

} // namespace vfm
