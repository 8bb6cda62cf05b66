#include "FilterOptions.h"

#include "Base/ParseText.h"
#include "Base/Runtime.h"

#include "vtkVolumeFractionMeshAlgorithm.h"
#include "vtkVolumeFractionToTet.h"

#include <array>
#include <functional>
#include <limits>
#include <sstream>
#include <type_traits>

namespace vfm
{
namespace
{

using Mesher = vtkVolumeFractionMeshAlgorithm;
using TetMesher = vtkVolumeFractionToTet;

constexpr double Above0 = std::numeric_limits<double>::min();
constexpr double Below1 = 1.0 - std::numeric_limits<double>::epsilon() / 2;
constexpr double Largest = std::numeric_limits<double>::max();

struct FilterOption
{
  std::string Name;
  std::string Allowed; ///< for messages: "it takes ..."
  std::string Default;
  bool OnlyTets;
  std::function<bool(Mesher&, const std::string&)> Set; ///< false: the value is not allowed
};

/// parse: from text to std::optional of a value that is allowed.
template <class Owner, class Value, class Parse>
FilterOption MakeOption(const char* name, const std::string& allowed, const char* byDefault,
  void (Owner::*set)(Value), Parse parse)
{
  return { name, allowed, byDefault, std::is_same<Owner, TetMesher>::value,
    [set, parse](Mesher& mesher, const std::string& text)
    {
      const auto value = parse(text);
      if (value)
      {
        (dynamic_cast<Owner&>(mesher).*set)(*value);
      }
      return value.has_value();
    } };
}

template <class Owner>
FilterOption Number(const char* name, const std::string& allowed, const char* byDefault,
  void (Owner::*set)(double), double least, double most)
{
  return MakeOption(name, allowed, byDefault, set,
    [least, most](const std::string& text) { return ParseNumber(text, least, most); });
}

template <class Owner>
FilterOption Count(
  const char* name, const char* byDefault, void (Owner::*set)(int), int least, int most)
{
  const std::string upTo =
    most == std::numeric_limits<int>::max() ? " or more" : " to " + std::to_string(most);
  return MakeOption(name, "a whole number, " + std::to_string(least) + upTo, byDefault, set,
    [least, most](const std::string& text) { return ParseCount(text, least, most); });
}

template <class Owner>
FilterOption Switch(const char* name, const char* byDefault, void (Owner::*set)(bool))
{
  return MakeOption(name, "on or off", byDefault, set, ParseSwitch);
}

/// The first word is number 0.
template <class Owner>
FilterOption Choice(const char* name, const char* byDefault, void (Owner::*set)(int),
  const std::vector<std::string>& words)
{
  const std::string numbers = "0 to " + std::to_string(words.size() - 1);
  return MakeOption(name, JoinTexts(words) + " (or " + numbers + ")", byDefault, set,
    [words](const std::string& text) { return ParseChoice(text, words); });
}

std::optional<double> ParseAspectRatio(const std::string& text)
{
  const std::optional<double> off = ParseNumber(text, 0.0, 0.0);
  return off ? off : ParseNumber(text, 1.1, Largest);
}

/// Numbers of a box (AddRefinementBox), parted by commas; nothing when it is none.
std::optional<std::array<double, 7>> ParseBox(const std::string& text)
{
  const std::vector<std::string> parts = SplitText(text);
  std::array<double, 7> box{};
  box.back() = 1.0;
  bool isBox = parts.size() == 6 || (parts.size() == 7 && ParseCount(parts[6], 0, MostHalvings));
  for (std::size_t i = 0; isBox && i < parts.size(); ++i)
  {
    const std::optional<double> number = ParseNumber(parts[i], -Largest, Largest);
    isBox = number.has_value();
    box[i] = number.value_or(0.0);
  }
  return isBox ? std::make_optional(box) : std::nullopt;
}

/// Boxes parted by semicolons replace those that the mesher has; no text: none.
bool SetBoxes(Mesher& mesher, const std::string& text)
{
  std::vector<std::array<double, 7>> boxes;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ';');)
  {
    const auto box = ParseBox(part);
    if (!box)
    {
      return false;
    }
    boxes.push_back(*box);
  }
  mesher.ClearRefinementBoxes();
  for (const auto& b : boxes)
  {
    mesher.AddRefinementBox(b[0], b[1], b[2], b[3], b[4], b[5], b[6]);
  }
  return true;
}

/// Any text will do: an array, a file.
FilterOption Name(const char* name, const char* allowed, void (Mesher::*set)(const char*))
{
  return { name, allowed, "None", false,
    [set](Mesher& mesher, const std::string& text)
    {
      (mesher.*set)(text.c_str());
      return true;
    } };
}

constexpr const char* ArrayName = "the name of a cell array, or None";

/// What the commas part replaces what the mesher has; None: nothing.
void SetList(Mesher& mesher, const std::string& text, void (Mesher::*clear)(),
  void (Mesher::*add)(const char*))
{
  (mesher.*clear)();
  for (const std::string& part : SplitText(IsSameWord(text, "None") ? "" : text))
  {
    (mesher.*add)(part.c_str());
  }
}

bool SetDensities(Mesher& mesher, const std::string& text)
{
  SetList(mesher, text, &Mesher::ClearDensityArrays, &Mesher::AddDensityArray);
  return true;
}

/// Which kinds there are the mesher tells, which knows the arrays.
bool SetKinds(Mesher& mesher, const std::string& text)
{
  const bool isNone = text.empty() || IsSameWord(text, "None");
  for (const std::string& part : SplitText(text))
  {
    if (!isNone && part.find('=') == std::string::npos)
    {
      return false;
    }
  }
  SetList(mesher, text, &Mesher::ClearStateKinds, &Mesher::AddStateKind);
  return true;
}

const std::vector<FilterOption>& Options()
{
  static const std::vector<FilterOption> options{
    Number("IsoValue", "a number above 0 and below 1", "0.5", &Mesher::SetIsoValue, Above0, Below1),
    Switch("MeshVoid", "off", &Mesher::SetMeshVoid),
    Switch("StairStep", "off", &Mesher::SetStairStep),
    Choice("Smoothing", "QuadricSurface", &Mesher::SetSmoothing,
      { "Off", "QuadricSurface", "GeometryBased" }),
    Choice("SharpEdges", "Automatic", &Mesher::SetSharpEdges, { "Off", "On", "Automatic" }),
    Number("TargetScaledJacobian", "a number from 0 (automatic) to below 1", "0",
      &Mesher::SetTargetScaledJacobian, 0.0, Below1),
    Switch("ConserveVolume", "on", &Mesher::SetConserveVolume),
    Switch("ComputeQuality", "on", &Mesher::SetComputeQuality),
    Count("NumberOfThreads", "0", &Mesher::SetNumberOfThreads, 0, std::numeric_limits<int>::max()),
    Number("FractionTolerance", "a number from 1e-6 to 0.1", "1e-6", &Mesher::SetFractionTolerance,
      1e-6, 0.1),
    Count("LabelSmoothing", "0", &Mesher::SetLabelSmoothing, 0, 10),
    Name("LabelNames", "a file that names labels", &Mesher::SetLabelNamesFile),
    Count("MinimumRegionCells", "0", &Mesher::SetMinimumRegionCells, 0,
      std::numeric_limits<int>::max()),
    Choice("Refinement", "InputLevels", &Mesher::SetRefinement,
      { "Off", "InputLevels", "Automatic", "Coarsen", "Uniform" }),
    MakeOption("MaximumLevel", "a whole number, -1 (automatic) to 10", "-1",
      &Mesher::SetMaximumLevel,
      [](const std::string& text) { return ParseCount(text, -1, MostHalvings); }),
    Switch("FineInterfaces", "on", &Mesher::SetFineInterfaces),
    Count("FineLayers", "2", &Mesher::SetFineLayers, 2, 64),
    MakeOption("MaximumAspectRatio", "0 (off) or a number, 1.1 or more", "0",
      &Mesher::SetMaximumAspectRatio, ParseAspectRatio),
    Choice("ChildFractions", "Planes", &Mesher::SetChildFractions, { "Planes", "Parent" }),
    Number("ThinCells", "a number from 0 (off) to 3", "2", &Mesher::SetThinCells, 0.0, 3.0),
    Number("CurvaturePerCell", "a number, 0 (off) or more", "0", &Mesher::SetCurvaturePerCell, 0.0,
      Largest),
    Switch("RefineFlippedCells", "off", &Mesher::SetRefineFlippedCells),
    Count("InterfaceLayers", "0", &Mesher::SetInterfaceLayers, 0, 64),
    Name("RefinementArray", ArrayName, &Mesher::SetRefinementArray),
    { "RefinementBoxes",
      "x0,y0,z0,x1,y1,z1 or with the number of halvings, 0 to 10, as seventh; semicolons part "
      "boxes",
      "no box", false, SetBoxes },
    Choice(
      "StateTransfer", "Automatic", &Mesher::SetStateTransfer, { "Automatic", "Copy", "Conserve" }),
    { "DensityArrays", "names of cell arrays with commas between them, or None", "None", false,
      SetDensities },
    { "StateKinds",
      "name=kind with commas between them, or None; kinds: mass, mass*other, volume, cell, "
      "extensive, copy",
      "None", false, SetKinds },
    Count("StateOrder", "2", &Mesher::SetStateOrder, 1, 2),
    Name("VelocityArray", ArrayName, &Mesher::SetVelocityArray),
    Name("EnergyArray", ArrayName, &Mesher::SetEnergyArray),
    Switch("NodalVelocity", "off", &Mesher::SetNodalVelocity),
    Choice(
      "LostKineticEnergy", "Report", &Mesher::SetLostKineticEnergy, { "Report", "InternalEnergy" }),
    Choice("UnmeshedMaterial", "Give", &Mesher::SetUnmeshedMaterial, { "Give", "Drop" }),
    Choice("Method", TetMesher::HasTetGen() ? "TetGen" : "Lattice", &TetMesher::SetMethod,
      { "TetGen", "Cells", "Lattice" }),
    Number("RelativeSize", "a number, 0.1 or more", "1", &TetMesher::SetRelativeSize, 0.1, Largest),
    Number("Growth", "a number, 0 or more", "0.3", &TetMesher::SetGrowth, 0.0, Largest),
    Number("RadiusEdgeRatio", "a number, 1 or more", "1.4", &TetMesher::SetRadiusEdgeRatio, 1.0,
      Largest),
    Number("MinimumDihedralAngle", "a number of degrees, 0 to 60", "10",
      &TetMesher::SetMinimumDihedralAngle, 0.0, 60.0),
    Count("OptimizationLevel", "4", &TetMesher::SetOptimizationLevel, 0, 10),
  };
  return options;
}

/// Null when no mesher has it.
const FilterOption* FindOption(const std::string& name)
{
  for (const FilterOption& option : Options())
  {
    if (IsSameWord(option.Name, name))
    {
      return &option;
    }
  }
  return nullptr;
}

bool IsOptionOf(Mesher& mesher, const FilterOption& option)
{
  return !option.OnlyTets || TetMesher::SafeDownCast(&mesher);
}

std::string ListNames(Mesher& mesher)
{
  std::vector<std::string> names;
  for (const FilterOption& option : Options())
  {
    if (IsOptionOf(mesher, option))
    {
      names.push_back(option.Name);
    }
  }
  return JoinTexts(names);
}

} // namespace

bool IsFilterOption(Mesher& mesher, const std::string& name)
{
  const FilterOption* option = FindOption(name);
  return option && IsOptionOf(mesher, *option);
}

void SetFilterOption(Mesher& mesher, const std::string& name, const std::string& value)
{
  const FilterOption* option = FindOption(name);
  if (!option)
  {
    throw InputError("There is no option '" + name + "' (given '" + value +
      "'). The options are: " + ListNames(mesher) + ".");
  }
  if (!IsOptionOf(mesher, *option))
  {
    throw InputError("The option " + option->Name + " (given '" + value +
      "') is one of tetrahedra, and hexahedra are asked for. Their options are: " +
      ListNames(mesher) + ".");
  }
  if (!option->Set(mesher, value))
  {
    throw InputError("The option " + option->Name + " cannot be '" + value + "': it takes " +
      option->Allowed + ".");
  }
}

std::vector<std::string> ListFilterOptions(Mesher& mesher)
{
  std::vector<std::string> lines;
  for (const FilterOption& option : Options())
  {
    if (IsOptionOf(mesher, option))
    {
      lines.push_back(option.Name + ": " + option.Allowed + "; default " + option.Default +
        (option.OnlyTets ? "; tetrahedra only" : ""));
    }
  }
  return lines;
}

} // namespace vfm
