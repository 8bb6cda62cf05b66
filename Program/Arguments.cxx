#include "Arguments.h"

#include "ArgumentOptions.h"
#include "Base/ParseText.h"
#include "FileSuffix.h"
#include "Images/ImageFile.h"
#include "Meshes/WriteMesh.h"
#include "Options/SetOptions.h"
#include "ReadInput.h"
#include "State/ArrayStems.h"
#include "State/StateChoice.h"
#include "WriteGeometry.h"

#include <algorithm>
#include <set>

namespace vfm
{
namespace
{

const ArgumentOption& FindArgument(const std::string& word)
{
  for (const auto* arguments : { &GetOwnArguments(), &GetMesherArguments() })
  {
    for (const ArgumentOption& option : *arguments)
    {
      if (option.Name == (word == "-h" ? "--help" : word))
      {
        return option;
      }
    }
  }
  RefuseArguments("'" + word + "' is no option.");
}

bool IsGivenTwice(const std::string& name, std::set<std::string>& seen)
{
  return !seen.insert(name == "--no-smooth" ? "--smooth" : name).second && name != "--set" &&
    name != "--refine-box";
}

/// A word that is no option: the input, or after it the output.
void TakeFile(Arguments& to, const std::string& word, std::set<std::string>& seen)
{
  const bool isInput = seen.insert("--input").second;
  if (!isInput && !seen.insert("--output").second)
  {
    RefuseArguments(
      "'" + word + "' is a file too many: the input and the output are named already.");
  }
  (isInput ? to.Input : to.Output) = word;
}

void CheckVoxels(const Arguments& from)
{
  const bool isText = HasSuffix(from.Input, ".spn");
  if (isText && !from.Dimensions)
  {
    RefuseArguments(
      "The input " + from.Input + " does not tell its size: --dimensions NX,NY,NZ is missing.");
  }
  if (!isText && from.Dimensions)
  {
    RefuseArguments("--dimensions is for .spn files.");
  }
  const bool isVoxels = isText || HasSuffix(from.Input, ".npy");
  if (!isVoxels && (from.Origin || from.AxisOrder))
  {
    RefuseArguments("--origin and --axis-order are for .spn and .npy files.");
  }
  if (!isVoxels && !IsImageFile(from.Input) && from.Spacing)
  {
    RefuseArguments("--spacing is for " + JoinTexts(GetImageSuffixes()) + ", .spn and .npy files.");
  }
}

void CheckInput(const Arguments& from)
{
  if (from.Input.empty())
  {
    RefuseArguments("--input FILE is missing.");
  }
  CheckInputSuffix(from.Input);
  if (from.Step && from.Time)
  {
    RefuseArguments("--step and --time exclude each other.");
  }
  CheckVoxels(from);
}

void CheckRefinement(const std::set<std::string>& seen)
{
  for (const char* name : { "--refine-cells", "--refine-box" })
  {
    if (seen.count("--refine") > 0 && seen.count(name) > 0)
    {
      RefuseArguments(std::string("--refine and ") + name + " exclude each other.");
    }
  }
}

void CheckOutput(const Arguments& from)
{
  const std::string problem =
    FindOutputProblem(from.Output, from.SingleFile ? OutputFiles::Single : OutputFiles::AsUsual);
  if (!problem.empty())
  {
    RefuseArguments(problem);
  }
}

void CheckMesh(const Arguments& from, const std::set<std::string>& seen)
{
  CheckInput(from);
  if (from.Output.empty())
  {
    RefuseArguments("--output FILE is missing, as in sculptor " + from.Input + " mesh.vtu.");
  }
  if (!from.Labels.empty() && !from.Fractions.empty())
  {
    RefuseArguments("--fractions and --labels exclude each other.");
  }
  CheckRefinement(seen);
  if (!from.Geometry.empty())
  {
    CheckGeometrySuffix(from.Geometry);
  }
  CheckOutput(from);
}

MesherOptions ReadOptions(const Arguments& from)
{
  MesherOptions options;
  options.Elements = from.Tets ? ElementKind::Tets : ElementKind::Hexes;
  try
  {
    for (const auto& [name, value] : from.Options)
    {
      SetOption(options, name, value);
    }
  }
  catch (const InputError& error)
  {
    throw ProgramError(ExitCode::WrongArguments, error.what());
  }
  return options;
}

/// Throws where velocity or energy would be missing in the mesh, since only state that is conserved has them.
void CheckConserved(const MesherOptions& options)
{
  const bool isConserved = ConservesState(options.Transfer, options.DensityArrays);
  if (!isConserved && !(options.VelocityArray + options.EnergyArray).empty())
  {
    RefuseArguments("--velocity and --energy are for state that is conserved: name a --density, or "
                    "say --state-transfer Conserve. Arrays to be copied are those of --state.");
  }
}

/// Readers read the densities as other state.
void AddDensities(Arguments& to)
{
  for (const std::string& name : to.Mesher.DensityArrays)
  {
    if (std::find(to.State.begin(), to.State.end(), name) == to.State.end())
    {
      to.State.push_back(name);
    }
  }
}

/// what: for the message.
void CheckOptions(
  const std::string& what, const std::vector<std::string>& known, const std::set<std::string>& seen)
{
  for (const std::string& name : seen)
  {
    if (std::find(known.begin(), known.end(), name) == known.end())
    {
      RefuseArguments(what + " takes " + JoinTexts(known) + ", not " + name + ".");
    }
  }
}

void CheckList(const Arguments& from, const std::set<std::string>& seen)
{
  CheckOptions("--list",
    { "--input", "--dimensions", "--origin", "--spacing", "--axis-order", "--step", "--time",
      "--list" },
    seen);
  CheckInput(from);
}

/// The test makes its own input.
void CheckTest(const Arguments& from, const std::set<std::string>& seen)
{
  CheckOptions("sculptor test",
    { "--tetmesh", "--stairstep", "--smooth", "--no-smooth", "--material", "--refine",
      "--refine-cells", "--output", "--quiet" },
    seen);
  CheckRefinement(seen);
  if (!from.Output.empty())
  {
    CheckOutput(from);
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

Arguments ParseArguments(const std::vector<std::string>& given)
{
  Arguments arguments;
  ArgumentWords words(given);
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
    const ArgumentOption& option = FindArgument(word);
    if (IsGivenTwice(option.Name, seen))
    {
      RefuseArguments(option.Name + " is given twice.");
    }
    option.Take(arguments, words, option.Name);
    if (words.HasJoinedValue())
    {
      RefuseArguments(option.Name + " takes no value, but '" + words.Take() + "' is given.");
    }
    if (arguments.Task == Command::Help || arguments.Task == Command::Version)
    {
      return arguments;
    }
  }
  arguments.Mesher = ReadOptions(arguments);
  if (isTest)
  {
    CheckTest(arguments, seen);
  }
  else if (arguments.Task == Command::List)
  {
    CheckList(arguments, seen);
  }
  else
  {
    CheckMesh(arguments, seen);
    AddDensities(arguments);
    CheckConserved(arguments.Mesher);
  }
  return arguments;
}

std::string GetHelp()
{
  std::string text =
    "sculptor: a conforming mesh of every material from volume fractions on a grid of cells\n\n"
    "usage: [mpiexec -n RANKS] sculptor [--input] FILE [--output] FILE [options]\n"
    "       [mpiexec -n RANKS] sculptor test [--tetmesh [METHOD]] [--no-smooth] [--stairstep] "
    "[--refine N] ..\n"
    "       [mpiexec -n RANKS] sculptor --list FILE\n\n";
  for (const ArgumentOption& option : GetOwnArguments())
  {
    text += "  " + Padded(option.Name + " " + option.Value, 26) + option.Help + "\n";
  }
  text += "\nInput: " + JoinTexts(GetInputSuffixes()) +
    "\n  Exodus: hexahedra that form a Cartesian grid, with element variables; of FILE.N.RANK any "
    "one stands for all, with any FILE\n  AMReX: the folder of a plotfile\n";
  text += "Output: " + JoinTexts(GetOutputSuffixes()) +
    "\n  .vtu and .inp (Abaqus, CalculiX) are one file, also from several ranks; Exodus from N "
    "ranks is "
    "one file a rank,\n  FILE.N.RANK\n";
  text += "Without --fractions and --labels: the arrays 'Material volume fraction - N', else all "
          "cell arrays of float,\n"
          "double or unsigned char with values in [0, 1] (unsigned char: 0..255), else the labels "
          "'MaterialId';\n"
          "of images, if cells have none, arrays of points likewise, each point the centre of a "
          "cell; whole numbers of an image "
          "file are labels.\n";
  text +=
    "sculptor test: meshes two boxes, checks the mesh and prints PASS or FAIL; takes --tetmesh, "
    "--smooth, --no-smooth, --stairstep,\n"
    "--material 1, --refine N, --refine-cells (without an array: a few cells of one box).\n";
  text += "\nOptions of the mesher, by --set or a name of their own\n";
  for (const std::string& line : DescribeOptions(ElementKind::Tets))
  {
    text += "  " + line + "\n";
  }
  return text + ExitCodes;
}

} // namespace vfm
