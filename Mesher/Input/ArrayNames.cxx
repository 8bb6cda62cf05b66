#include "Input/ArrayNames.h"

#include "Base/ParseText.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <regex>
#include <vector>

namespace vfm
{
namespace
{

template <class List>
bool Holds(const List& names, const std::string& name)
{
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

/// Returns the words of a name in lower case: "volume", "fraction", "2" for "VolumeFraction-2".
std::vector<std::string> SplitName(const std::string& name)
{
  enum class Kind
  {
    None,
    Lower,
    Upper,
    Digit
  };
  std::vector<std::string> words;
  Kind last = Kind::None;
  for (const char letter : name)
  {
    const auto code = static_cast<unsigned char>(letter);
    const Kind kind = std::isdigit(code) ? Kind::Digit
      : std::isupper(code)               ? Kind::Upper
      : std::isalpha(code)               ? Kind::Lower
                                         : Kind::None;
    const bool continues = kind == last || (last == Kind::Upper && kind == Kind::Lower);
    if (kind != Kind::None && !continues)
    {
      words.emplace_back();
    }
    if (kind != Kind::None)
    {
      words.back().push_back(ToLower(letter));
    }
    last = kind;
  }
  return words;
}

/// Returns the letters and digits of a name in lower case: "materialid" for "Material_Id".
std::string Compact(const std::string& name)
{
  std::string compact;
  for (const std::string& word : SplitName(name))
  {
    compact += word;
  }
  return compact;
}

bool HasWord(const std::string& name, const std::vector<std::string>& sought)
{
  const std::vector<std::string> words = SplitName(name);
  return std::any_of(
    words.begin(), words.end(), [&sought](const std::string& word) { return Holds(sought, word); });
}

/// Returns whether a word of the name begins with a text.
bool HasBegin(const std::string& name, const std::string& begin)
{
  const std::vector<std::string> words = SplitName(name);
  return std::any_of(words.begin(), words.end(),
    [&begin](const std::string& word) { return word.compare(0, begin.size(), begin) == 0; });
}

} // namespace

bool IsGhostName(const std::string& name)
{
  return name == "vtkGhostType" || name == "vtkGhostLevels";
}

bool IsIdName(const std::string& name)
{
  const char* const names[] = { "GlobalCellIds", "GlobalPointIds", "vtkOriginalCellIds",
    "vtkOriginalPointIds", "GlobalElementId", "GlobalNodeId", "GlobalIds", "PedigreeElementId",
    "PedigreeNodeId", "PedigreeIds" };
  return Holds(names, name);
}

bool IsOffered(const std::string& name)
{
  return !IsGhostName(name) && !IsIdName(name) && name != "vtkValidPointMask";
}

bool IsSpyPlotFraction(const std::string& name)
{
  // "Material volume fraction - 1", in newer files "Volume Fraction - 1".
  static const std::regex pattern(".*[vV]olume [fF]raction - [0-9]+");
  return std::regex_match(name, pattern);
}

bool IsFractionName(const std::string& name)
{
  const std::string compact = Compact(name);
  const auto contains = [&compact](const char* part)
  { return compact.find(part) != std::string::npos; };
  // VOLM is the variable of CTH, VOLFRC of ALEGRA, alpha.water of OpenFOAM.
  return name.compare(0, 6, "alpha.") == 0 || contains("volumefrac") || contains("volfrac") ||
    contains("volfrc") || contains("fracvol") || contains("fractionvol") ||
    HasWord(name, { "vf", "vof", "vfrac", "vfrc", "volm", "matvf", "vofm", "fvol" });
}

bool IsVoidName(const std::string& name)
{
  return HasBegin(name, "void") || HasWord(name, { "vacuum" });
}

bool IsStateName(const std::string& name)
{
  return HasWord(name,
    { "damage", "porosity", "distension", "pressure", "temperature", "energy", "enthalpy",
      "entropy", "velocity", "speed", "momentum", "acceleration", "displacement", "stress",
      "strain", "eqps", "viscosity", "vorticity", "mach" });
}

bool IsMassName(const std::string& name)
{
  return HasBegin(name, "mass") || HasBegin(name, "dens") || HasWord(name, { "rho" });
}

bool IsDistanceName(const std::string& name)
{
  return HasWord(name, { "phi", "sdf", "distance", "dist", "levelset", "signeddistance" }) ||
    Compact(name).find("levelset") != std::string::npos;
}

bool IsBookkeepingName(const std::string& name)
{
  const char* const names[] = { "processid", "procid", "proc", "processor", "rank", "mpirank",
    "vtkprocessid", "vtkdomainid", "partition", "partitionid", "level", "amrlevel", "vtkamrlevel",
    "refinementlevel", "cellid", "cellids", "elementid", "elementids", "cellindex" };
  return Holds(names, Compact(name));
}

int FindLabelsRank(const std::string& name)
{
  const char* const names[] = { "materialid", "materialids", "material", "materials", "matid",
    "mat", "featureids", "featureid", "grainid", "grainids", "grain", "grains", "spin", "labels",
    "label", "labelmap", "segmentation", "regionid", "region", "regions", "phaseid", "phase",
    "phases" };
  if (name == LabelsName)
  {
    return 0;
  }
  const auto found = std::find(std::begin(names), std::end(names), Compact(name));
  return found == std::end(names) ? -1 : 1 + static_cast<int>(found - std::begin(names));
}

} // namespace vfm
