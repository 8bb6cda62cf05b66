#include "ArgumentOptions.h"

#include "Base/ParseText.h"
#include "Options/OptionTable.h"

#include <algorithm>
#include <limits>

namespace vfm
{
namespace
{

using Taker = ArgumentTaker;

/// Sets an option of the mesher to the value that follows.
Taker TakeOption(const std::string& name)
{
  return [name](Arguments& to, ArgumentWords& words, const std::string& option)
  { to.Options.emplace_back(name, words.TakeValue(option)); };
}

Taker SetTo(const std::string& name, const char* value)
{
  return [name, value](Arguments& to, ArgumentWords&, const std::string&)
  { to.Options.emplace_back(name, value); };
}

void TakeRefine(Arguments& to, ArgumentWords& words, const std::string& option)
{
  const std::string text = words.TakeValue(option);
  if (!ParseCount(text, 0, MostHalvings)) // MaximumLevel takes -1, too
  {
    RefuseArguments(option + " takes a whole number from 0 to " + std::to_string(MostHalvings) +
      ", not '" + text + "'.");
  }
  to.Options.emplace_back("Refinement", "Uniform");
  to.Options.emplace_back("MaximumLevel", text);
}

/// What is named to be refined is all that is, unless options say otherwise.
void RefineByName(Arguments& to)
{
  const std::pair<std::string, std::string> first{ "Refinement", "Automatic" };
  if (to.Options.empty() || to.Options[0] != first)
  {
    to.Options.insert(
      to.Options.begin(), { first, { "ThinCells", "0" }, { "FineInterfaces", "off" } });
  }
}

void TakeRefineCells(Arguments& to, ArgumentWords& words, const std::string& option)
{
  RefineByName(to);
  if (to.Task == Command::Test)
  {
    to.RefinesCells = true;
    return;
  }
  to.Options.emplace_back("RefinementArray", words.TakeValue(option));
}

void TakeRefineBox(Arguments& to, ArgumentWords& words, const std::string& option)
{
  RefineByName(to);
  const std::string box = words.TakeValue(option);
  const auto boxes = std::find_if(to.Options.begin(), to.Options.end(),
    [](const auto& set) { return set.first == "RefinementBoxes"; });
  if (boxes == to.Options.end())
  {
    to.Options.emplace_back("RefinementBoxes", box);
    return;
  }
  boxes->second += ";" + box;
}

void TakeSettings(Arguments& to, ArgumentWords& words, const std::string& option)
{
  do
  {
    const std::string setting = words.TakeValue(option);
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos)
    {
      RefuseArguments(option + " takes Option=Value, not '" + setting + "'.");
    }
    to.Options.emplace_back(
      TrimText(setting.substr(0, equals)), TrimText(setting.substr(equals + 1)));
  } while (words.HasValue());
}

void TakeStep(Arguments& to, ArgumentWords& words, const std::string& option)
{
  const std::string text = words.TakeValue(option);
  to.Step = ParseCount(text, 0, std::numeric_limits<int>::max());
  if (!to.Step)
  {
    RefuseArguments(option + " takes a whole number from 0, not '" + text + "'.");
  }
}

void TakeTime(Arguments& to, ArgumentWords& words, const std::string& option)
{
  constexpr double largest = std::numeric_limits<double>::max();
  const std::string text = words.TakeValue(option);
  to.Time = ParseNumber(text, -largest, largest);
  if (!to.Time)
  {
    RefuseArguments(option + " takes a number, not '" + text + "'.");
  }
}

void TakeMaterials(Arguments& to, ArgumentWords& words, const std::string& option)
{
  to.Materials = words.TakeList(option);
  if (to.Materials.size() == 1 && IsSameWord(to.Materials[0], "all"))
  {
    to.Materials.clear();
  }
}

/// Three values with commas between them.
template <class Value>
Taker TakeThree(std::optional<std::array<Value, 3>> Arguments::*member, Value least, Value most,
  std::function<std::optional<Value>(const std::string&, Value, Value)> parse, const char* what)
{
  return [=](Arguments& to, ArgumentWords& words, const std::string& option)
  {
    const std::string text = words.TakeValue(option);
    const std::vector<std::string> parts = SplitText(text);
    std::array<Value, 3> values{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto value = parts.size() == 3 ? parse(parts[i], least, most) : std::nullopt;
      if (!value)
      {
        RefuseArguments(
          option + " takes three " + what + " with commas between them, not '" + text + "'.");
      }
      values[i] = *value;
    }
    to.*member = values;
  };
}

Taker TakeDimensions()
{
  return TakeThree<int>(
    &Arguments::Dimensions, 1, std::numeric_limits<int>::max() - 1, ParseCount, "numbers of cells");
}

Taker TakeLengths(
  std::optional<std::array<double, 3>> Arguments::*member, double least, const char* what)
{
  return TakeThree<double>(member, least, std::numeric_limits<double>::max(), ParseNumber, what);
}

void TakeAxisOrder(Arguments& to, ArgumentWords& words, const std::string& option)
{
  const std::string text = words.TakeValue(option);
  to.AxisOrder = ParseChoice(text, { "xyz", "xzy", "yxz", "yzx", "zxy", "zyx" });
  if (!to.AxisOrder)
  {
    RefuseArguments(
      option + " takes xyz, xzy, yxz, yzx, zxy or zyx, or its number from 0, not '" + text + "'.");
  }
}

void TakeTets(Arguments& to, ArgumentWords& words, const std::string&)
{
  to.Tets = true;
  if (words.HasValue())
  {
    to.Options.emplace_back("Method", words.Take());
  }
}

Taker TakeText(std::string Arguments::*member)
{
  return [member](Arguments& to, ArgumentWords& words, const std::string& option)
  { to.*member = words.TakeValue(option); };
}

Taker TakeNames(std::vector<std::string> Arguments::*member)
{
  return [member](Arguments& to, ArgumentWords& words, const std::string& option)
  { to.*member = words.TakeList(option); };
}

/// Of options that have names here: the value that follows, switches are turned on.
std::vector<ArgumentOption> ListMesherArguments()
{
  std::vector<ArgumentOption> arguments;
  for (const Option& option : GetOptionTable())
  {
    const std::string& name = option.Argument;
    if (!name.empty())
    {
      const bool isSwitch = option.Kind == OptionKind::Switch;
      arguments.push_back({ name.substr(0, name.find(' ')), "", "",
        isSwitch ? SetTo(option.Name, "on") : TakeOption(option.Name) });
    }
  }
  return arguments;
}

} // namespace

const std::vector<ArgumentOption>& GetOwnArguments()
{
  static const std::vector<ArgumentOption> options{
    { "--input", "FILE", "what to mesh", TakeText(&Arguments::Input) },
    { "--output", "FILE", "where the mesh goes", TakeText(&Arguments::Output) },
    { "--dimensions", "NX,NY,NZ", "numbers of cells of a .spn file", TakeDimensions() },
    { "--origin", "X,Y,Z", "lower corner of a .spn or .npy file, default 0,0,0",
      TakeLengths(&Arguments::Origin, std::numeric_limits<double>::lowest(), "numbers") },
    { "--spacing", "X,Y,Z", "edges of its cells, default 1,1,1",
      TakeLengths(&Arguments::Spacing, std::numeric_limits<double>::min(), "numbers above 0") },
    { "--axis-order", "ORDER",
      "its array's indices, xyz (default) to zyx, as Sculpt's spn_xyz_order", TakeAxisOrder },
    { "--fractions", "A,B,..", "cell arrays, the volume fraction of one material each",
      TakeNames(&Arguments::Fractions) },
    { "--labels", "ARRAY", "instead: integer cell array that names the material of each cell",
      TakeText(&Arguments::Labels) },
    { "--material", "ID,..|all",
      "mesh only these, the others count as void; numbers from 1, or names of arrays",
      TakeMaterials },
    { "--state", "A,B,..", "cell arrays that the elements carry along: velocity, temperature",
      TakeNames(&Arguments::State) },
    { "--fragments", "FILE.csv", "a table of the fragments too: volumes, centroids, neighbours",
      TakeText(&Arguments::Fragments) },
    { "--geometry", "FILE.vtm", "surfaces, curves and vertices too, and what bounds what",
      TakeText(&Arguments::Geometry) },
    { "--tetmesh", "[METHOD]", "tetrahedra instead of hexahedra; TetGen, Cells or Lattice",
      TakeTets },
    { "--no-smooth", "", "the same as --smooth Off", SetTo("Smoothing", "Off") },
    { "--refine", "N", "halve all cells N times before they are meshed, 0 to 10", TakeRefine },
    { "--refine-cells", "ARRAY",
      "refine the cells that a cell array names: how many times each is to be halved, 0 to 10",
      TakeRefineCells },
    { "--refine-box", "BOX",
      "and all in the box X0,Y0,Z0,X1,Y1,Z1 or X0,..,Z1,N, N times (1); as often as there are "
      "boxes",
      TakeRefineBox },
    { "--set", "Option=Value ..", "any option of the mesher, see below", TakeSettings },
    { "--list", "", "what the input holds: times, grid, cell arrays, materials; nothing is meshed",
      [](Arguments& to, ArgumentWords&, const std::string&) { to.Task = Command::List; } },
    { "--step", "N", "which time of the input, from 0", TakeStep },
    { "--time", "T", "the time of the input nearest to T", TakeTime },
    { "--single-file", "", "Exodus from several ranks as one file, which the first rank gathers",
      [](Arguments& to, ArgumentWords&, const std::string&) { to.SingleFile = true; } },
    { "--quiet", "", "no progress and no table",
      [](Arguments& to, ArgumentWords&, const std::string&) { to.Quiet = true; } },
    { "--help", "", "this text; also -h",
      [](Arguments& to, ArgumentWords&, const std::string&) { to.Task = Command::Help; } },
    { "--version", "", "the version",
      [](Arguments& to, ArgumentWords&, const std::string&) { to.Task = Command::Version; } },
  };
  return options;
}

const std::vector<ArgumentOption>& GetMesherArguments()
{
  static const std::vector<ArgumentOption> arguments = ListMesherArguments();
  return arguments;
}

} // namespace vfm
