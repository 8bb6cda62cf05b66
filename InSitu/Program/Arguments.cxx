#include "Arguments.h"

#include "FileSuffix.h"
#include "MesherOptions.h"
#include "ParseText.h"
#include "ReadInput.h"
#include "Stage.h"
#include "WriteGeometry.h"
#include "WriteMesh.h"

#include "vtkNew.h"
#include "vtkVolumeFractionToTet.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <set>

namespace vfm
{
namespace
{

constexpr int MostHalvings = 10;

[[noreturn]] void Refuse(const std::string& message)
{
  throw ProgramError(ExitCode::WrongArguments, message + " See sculptor --help.");
}

/// The words of a command line, taken from the front.
class Words
{
public:
  explicit Words(const std::vector<std::string>& words)
  {
    for (const std::string& word : words)
    {
      const std::size_t equals = IsOption(word) ? word.find('=') : std::string::npos;
      this->Left.push_back(word.substr(0, equals));
      if (equals != std::string::npos)
      {
        this->Joined.insert(this->Left.size());
        this->Left.push_back(word.substr(equals + 1));
      }
    }
  }
  bool HasWord() const { return this->Next < this->Left.size(); }
  bool HasValue() const { return this->HasWord() && !IsOption(this->Left[this->Next]); }
  /// Whether the next word stood behind the = of an option.
  bool HasJoinedValue() const { return this->Joined.count(this->Next) > 0; }
  std::string Take() { return this->Left[this->Next++]; }
  std::string TakeValue(const std::string& option)
  {
    if (!this->HasValue() || this->Left[this->Next].empty())
    {
      Refuse(option + " needs a value.");
    }
    return this->Take();
  }
  std::vector<std::string> TakeList(const std::string& option)
  {
    const std::vector<std::string> list = SplitText(this->TakeValue(option));
    std::set<std::string> seen;
    for (const std::string& item : list)
    {
      if (item.empty() || !seen.insert(item).second)
      {
        Refuse(option +
          (item.empty() ? " has an empty name in its list." : " names '" + item + "' twice."));
      }
    }
    return list;
  }

private:
  static bool IsOption(const std::string& word) { return word.compare(0, 2, "--") == 0; }
  std::vector<std::string> Left;
  std::set<std::size_t> Joined; // places of values behind an =
  std::size_t Next = 0;
};

using Taker = std::function<void(Arguments&, Words&, const std::string&)>;

/// Sets an option of the mesher to the value that follows.
Taker TakeOption(const char* name)
{
  return [name](Arguments& to, Words& words, const std::string& option)
  { to.Options.emplace_back(name, words.TakeValue(option)); };
}

Taker SetOption(const char* name, const char* value)
{
  return [name, value](Arguments& to, Words&, const std::string&)
  { to.Options.emplace_back(name, value); };
}

void TakeRefine(Arguments& to, Words& words, const std::string& option)
{
  const std::string text = words.TakeValue(option);
  if (!ParseCount(text, 0, MostHalvings)) // MaximumLevel takes -1, too
  {
    Refuse(option + " takes a whole number from 0 to " + std::to_string(MostHalvings) + ", not '" +
      text + "'.");
  }
  to.Options.emplace_back("Refinement", "Uniform");
  to.Options.emplace_back("MaximumLevel", text);
}

void TakeSettings(Arguments& to, Words& words, const std::string& option)
{
  do
  {
    const std::string setting = words.TakeValue(option);
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos)
    {
      Refuse(option + " takes Option=Value, not '" + setting + "'.");
    }
    to.Options.emplace_back(
      TrimText(setting.substr(0, equals)), TrimText(setting.substr(equals + 1)));
  } while (words.HasValue());
}

void TakeStep(Arguments& to, Words& words, const std::string& option)
{
  const std::string text = words.TakeValue(option);
  to.Step = ParseCount(text, 0, std::numeric_limits<int>::max());
  if (!to.Step)
  {
    Refuse(option + " takes a whole number from 0, not '" + text + "'.");
  }
}

void TakeTime(Arguments& to, Words& words, const std::string& option)
{
  constexpr double largest = std::numeric_limits<double>::max();
  const std::string text = words.TakeValue(option);
  to.Time = ParseNumber(text, -largest, largest);
  if (!to.Time)
  {
    Refuse(option + " takes a number, not '" + text + "'.");
  }
}

void TakeMaterials(Arguments& to, Words& words, const std::string& option)
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
  return [=](Arguments& to, Words& words, const std::string& option)
  {
    const std::string text = words.TakeValue(option);
    const std::vector<std::string> parts = SplitText(text);
    std::array<Value, 3> values{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto value = parts.size() == 3 ? parse(parts[i], least, most) : std::nullopt;
      if (!value)
      {
        Refuse(option + " takes three " + what + " with commas between them, not '" + text + "'.");
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

void TakeAxisOrder(Arguments& to, Words& words, const std::string& option)
{
  const std::string text = words.TakeValue(option);
  to.AxisOrder = ParseChoice(text, { "xyz", "xzy", "yxz", "yzx", "zxy", "zyx" });
  if (!to.AxisOrder)
  {
    Refuse(
      option + " takes xyz, xzy, yxz, yzx, zxy or zyx, or its number from 0, not '" + text + "'.");
  }
}

void TakeTets(Arguments& to, Words& words, const std::string&)
{
  to.Tets = true;
  if (words.HasValue())
  {
    to.Options.emplace_back("Method", words.Take());
  }
}

struct Option
{
  std::string Name, Value, Help;
  Taker Take;
};

Taker TakeText(std::string Arguments::*member)
{
  return [member](Arguments& to, Words& words, const std::string& option)
  { to.*member = words.TakeValue(option); };
}

Taker TakeNames(std::vector<std::string> Arguments::*member)
{
  return [member](Arguments& to, Words& words, const std::string& option)
  { to.*member = words.TakeList(option); };
}

const std::vector<Option>& Options()
{
  static const std::vector<Option> options{
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
    { "--density", "A,..",
      "cell arrays of mass per volume, one or one a material, for masses in that table",
      TakeNames(&Arguments::Densities) },
    { "--geometry", "FILE.vtm", "surfaces, curves and vertices too, and what bounds what",
      TakeText(&Arguments::Geometry) },
    { "--tetmesh", "[METHOD]", "tetrahedra instead of hexahedra; TetGen, Cells or Lattice",
      TakeTets },
    { "--stairstep", "", "cells become elements, nothing moves", SetOption("StairStep", "on") },
    { "--smooth", "ID", "0 Off, 1 QuadricSurface, 2 GeometryBased", TakeOption("Smoothing") },
    { "--no-smooth", "", "the same as --smooth Off", SetOption("Smoothing", "Off") },
    { "--iso", "V", "a cell filled less than this is void", TakeOption("IsoValue") },
    { "--void", "", "mesh the void too, as material 0", SetOption("MeshVoid", "on") },
    { "--label-smoothing", "N",
      "smooth the steps of labels by N passes of an average, 0 to 10; 2 or 3 do well",
      TakeOption("LabelSmoothing") },
    { "--minimum-region", "N", "regions of fewer than N cells go to what is around them",
      TakeOption("MinimumRegionCells") },
    { "--aspect", "R",
      "cut long cells first, until none is R times longer one way than another; 1.5 does well",
      TakeOption("MaximumAspectRatio") },
    { "--clip", "T", "clip fractions that lie outside [0, 1] by no more than T, to 0.1",
      TakeOption("FractionTolerance") },
    { "--refine", "N", "halve all cells N times before they are meshed, 0 to 10", TakeRefine },
    { "--set", "Option=Value ..", "any option of the mesher, see below", TakeSettings },
    { "--step", "N", "which time of the input, from 0", TakeStep },
    { "--time", "T", "the time of the input nearest to T", TakeTime },
    { "--single-file", "", "Exodus from several ranks as one file, which the first rank gathers",
      [](Arguments& to, Words&, const std::string&) { to.SingleFile = true; } },
    { "--quiet", "", "no progress and no table",
      [](Arguments& to, Words&, const std::string&) { to.Quiet = true; } },
    { "--help", "", "this text; also -h",
      [](Arguments& to, Words&, const std::string&) { to.Task = Command::Help; } },
    { "--version", "", "the version",
      [](Arguments& to, Words&, const std::string&) { to.Task = Command::Version; } },
  };
  return options;
}

const Option& FindOption(const std::string& word)
{
  for (const Option& option : Options())
  {
    if (option.Name == (word == "-h" ? "--help" : word))
    {
      return option;
    }
  }
  Refuse("'" + word + "' is no option.");
}

bool IsGivenTwice(const std::string& name, std::set<std::string>& seen)
{
  return !seen.insert(name == "--no-smooth" ? "--smooth" : name).second && name != "--set";
}

/// A word that is no option: the input, or after it the output.
void TakeFile(Arguments& to, const std::string& word, std::set<std::string>& seen)
{
  const bool isInput = seen.insert("--input").second;
  if (!isInput && !seen.insert("--output").second)
  {
    Refuse("'" + word + "' is a file too many: the input and the output are named already.");
  }
  (isInput ? to.Input : to.Output) = word;
}

void CheckVoxels(const Arguments& from)
{
  const bool isText = HasSuffix(from.Input, ".spn");
  if (isText && !from.Dimensions)
  {
    Refuse(
      "The input " + from.Input + " does not tell its size: --dimensions NX,NY,NZ is missing.");
  }
  if (!isText && from.Dimensions)
  {
    Refuse("--dimensions is for .spn files.");
  }
  if (!isText && !HasSuffix(from.Input, ".npy") && (from.Origin || from.Spacing || from.AxisOrder))
  {
    Refuse("--origin, --spacing and --axis-order are for .spn and .npy files.");
  }
}

void CheckMesh(const Arguments& from)
{
  if (from.Input.empty())
  {
    Refuse("--input FILE is missing.");
  }
  CheckInputSuffix(from.Input);
  if (from.Output.empty())
  {
    Refuse("--output FILE is missing, as in sculptor " + from.Input + " mesh.vtu.");
  }
  if (!from.Labels.empty() && !from.Fractions.empty())
  {
    Refuse("--fractions and --labels exclude each other.");
  }
  if (from.Step && from.Time)
  {
    Refuse("--step and --time exclude each other.");
  }
  if (!from.Densities.empty() && from.Fragments.empty())
  {
    Refuse("--density is for the table of --fragments.");
  }
  CheckVoxels(from);
  if (!from.Geometry.empty())
  {
    CheckGeometrySuffix(from.Geometry);
  }
  CheckOutputSuffix(from.Output, from.SingleFile ? OutputFiles::Single : OutputFiles::AsUsual);
}

/// Densities reach the table as arrays of the mesh.
void AddDensities(Arguments& to)
{
  for (const std::string& name : to.Densities)
  {
    if (std::find(to.State.begin(), to.State.end(), name) == to.State.end())
    {
      to.State.push_back(name);
    }
  }
}

/// The test makes its own input and asks for hexahedra with defaults.
void CheckTest(const Arguments& from, const std::set<std::string>& seen)
{
  for (const std::string& name : seen)
  {
    if (name != "--refine" && name != "--output" && name != "--quiet")
    {
      Refuse("sculptor test takes --refine, --output and --quiet, not " + name + ".");
    }
  }
  if (!from.Output.empty())
  {
    CheckOutputSuffix(from.Output);
  }
}

std::string Padded(std::string text, std::size_t width)
{
  text.resize(std::max(width, text.size() + 2), ' ');
  return text;
}

constexpr const char* ExitCodes = R"(
Exit codes
  0  all went well
  1  wrong arguments
  2  the input cannot be read, or holds no fitting arrays
  3  the mesher refuses the input, its message tells why; of sculptor test: a check failed
  4  the output cannot be written
  5  not enough memory, or an internal error

Examples
  sculptor impact.spcth impact.e
  mpiexec -n 8 sculptor --input splash.vti --fractions water --output splash.pvtu
  sculptor --input grains.vti --labels grain --tetmesh Lattice --output grains.e
  sculptor --input grains.spn --dimensions 20,20,20 --spacing 0.1,0.1,0.1 --output grains.e
  sculptor --input parts.vti --material 2 --set TargetScaledJacobian=0.4 --output second.vtu
  sculptor --input scan.vti --labels tissue --label-smoothing 3 --aspect 1.5 --output scan.e
)";

} // namespace

Arguments ParseArguments(const std::vector<std::string>& given)
{
  Arguments arguments;
  Words words(given);
  const bool isTest = !given.empty() && given[0] == "test";
  if (isTest)
  {
    arguments.Task = Command::Test;
    words.Take();
  }
  std::set<std::string> seen;
  while (words.HasWord())
  {
    const std::string word = words.Take();
    if (!isTest && !word.empty() && word[0] != '-')
    {
      TakeFile(arguments, word, seen);
      continue;
    }
    const Option& option = FindOption(word);
    if (IsGivenTwice(option.Name, seen))
    {
      Refuse(option.Name + " is given twice.");
    }
    option.Take(arguments, words, option.Name);
    if (words.HasJoinedValue())
    {
      Refuse(option.Name + " takes no value, but '" + words.Take() + "' is given.");
    }
    if (arguments.Task == Command::Help || arguments.Task == Command::Version)
    {
      return arguments;
    }
  }
  if (isTest)
  {
    CheckTest(arguments, seen);
  }
  else
  {
    CheckMesh(arguments);
    AddDensities(arguments);
  }
  return arguments;
}

std::string GetHelp()
{
  std::string text =
    "sculptor: a conforming mesh of every material from volume fractions on a grid of cells\n\n"
    "usage: [mpiexec -n RANKS] sculptor [--input] FILE [--output] FILE [options]\n"
    "       [mpiexec -n RANKS] sculptor test [--refine N] [--output FILE] [--quiet]\n\n";
  for (const Option& option : Options())
  {
    text += "  " + Padded(option.Name + " " + option.Value, 26) + option.Help + "\n";
  }
  text += "\nInput: " + JoinTexts(GetInputSuffixes()) +
    "\n  Exodus: hexahedra that form a Cartesian grid, with element variables; of FILE.N.RANK any "
    "one stands for all\n  AMReX: the folder of a plotfile\n";
  text += "Output: " + JoinTexts(GetOutputSuffixes()) +
    "\n  .vtu and .inp (Abaqus, CalculiX) are one file, also from several ranks; Exodus from N "
    "ranks is "
    "one file a rank,\n  FILE.N.RANK\n";
  text += "Without --fractions and --labels: the arrays 'Material volume fraction - N', else all "
          "cell arrays of float,\n"
          "double or unsigned char with values in [0, 1] (unsigned char: 0..255), else the labels "
          "'MaterialId'.\n";
  text += "sculptor test: meshes two boxes, checks the mesh and prints PASS or FAIL.\n";
  text += "\nOptions of the mesher, for --set\n";
  vtkNew<vtkVolumeFractionToTet> mesher;
  for (const std::string& line : ListMesherOptions(*mesher))
  {
    text += "  " + line + "\n";
  }
  return text + ExitCodes;
}

} // namespace vfm
