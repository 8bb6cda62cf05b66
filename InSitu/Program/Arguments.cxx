#include "Arguments.h"

#include "ArgumentOptions.h"
#include "FileSuffix.h"
#include "MesherOptions.h"
#include "ParseText.h"
#include "ReadInput.h"
#include "WriteGeometry.h"
#include "WriteMesh.h"

#include "vtkNew.h"
#include "vtkVolumeFractionToTet.h"

#include <algorithm>
#include <set>

namespace vfm
{
namespace
{

const ArgumentOption& FindOption(const std::string& word)
{
  for (const ArgumentOption& option : GetArgumentOptions())
  {
    if (option.Name == (word == "-h" ? "--help" : word))
    {
      return option;
    }
  }
  RefuseArguments("'" + word + "' is no option.");
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
  if (!isText && !HasSuffix(from.Input, ".npy") && (from.Origin || from.Spacing || from.AxisOrder))
  {
    RefuseArguments("--origin, --spacing and --axis-order are for .spn and .npy files.");
  }
}

void CheckMesh(const Arguments& from)
{
  if (from.Input.empty())
  {
    RefuseArguments("--input FILE is missing.");
  }
  CheckInputSuffix(from.Input);
  if (from.Output.empty())
  {
    RefuseArguments("--output FILE is missing, as in sculptor " + from.Input + " mesh.vtu.");
  }
  if (!from.Labels.empty() && !from.Fractions.empty())
  {
    RefuseArguments("--fractions and --labels exclude each other.");
  }
  if (from.Step && from.Time)
  {
    RefuseArguments("--step and --time exclude each other.");
  }
  if (!from.Densities.empty() && from.Fragments.empty())
  {
    RefuseArguments("--density is for the table of --fragments.");
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
      RefuseArguments("sculptor test takes --refine, --output and --quiet, not " + name + ".");
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
    const ArgumentOption& option = FindOption(word);
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
  for (const ArgumentOption& option : GetArgumentOptions())
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
