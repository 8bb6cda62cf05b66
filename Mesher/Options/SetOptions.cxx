#include "Options/SetOptions.h"

#include "Base/ParseText.h"
#include "Base/Runtime.h"
#include "Options/CellWidths.h"
#include "Options/MaterialWidths.h"
#include "Options/ValueRanges.h"

#include <algorithm>
#include <sstream>

namespace vfm
{
namespace
{

using Texts = std::vector<std::string>;
using Boxes = std::vector<RefinementBox>;

constexpr double Largest = std::numeric_limits<double>::max();

/// "3 (automatic)" where 3 is special.
std::string WithMeaning(double number, const OptionRange& range)
{
  const bool isSpecial = range.Special == number;
  return FormatNumber(number) + (isSpecial ? " (" + range.Meaning + ")" : "");
}

/// Describes the allowed values; noun: what a value is called.
std::string DescribeRange(const std::string& noun, const OptionRange& range)
{
  const bool hasMost = range.Most <= Largest;
  const bool isApart = range.Special && *range.Special < range.Least;
  std::string text = isApart ? WithMeaning(*range.Special, range) + " or " : "";
  const std::string least = WithMeaning(range.Least, range);
  if (!hasMost)
  {
    return text + noun + ", " + (range.IsMinimumOpen ? "above " + least : least + " or more");
  }
  const std::string to = range.IsMaximumOpen ? "below " : "";
  if (range.IsMinimumOpen)
  {
    return text + noun + " above " + least + " and " + (to.empty() ? "up to " : to) +
      FormatNumber(range.Most);
  }
  return text + noun + " from " + least + " to " + to + FormatNumber(range.Most);
}

Texts WithoutSpaces(Texts words)
{
  for (std::string& word : words)
  {
    word.erase(std::remove(word.begin(), word.end(), ' '), word.end());
  }
  return words;
}

std::optional<double> ParseValue(const Option& option, const std::string& text)
{
  switch (option.Kind)
  {
    case OptionKind::Switch:
      return ParseSwitch(text);
    case OptionKind::Choice:
      return ParseChoice(text, option.Words);
    case OptionKind::Integer:
      return ParseCount(text, std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
    default:
      return ParseNumber(text, -Largest, Largest);
  }
}

/// Parses six numbers, or seven with the number of halvings.
std::optional<RefinementBox> ParseBox(const std::string& text)
{
  const Texts parts = SplitText(text);
  std::vector<double> numbers;
  for (const std::string& part : parts)
  {
    numbers.push_back(
      ParseNumber(part, -Largest, Largest).value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  const bool isBox =
    (parts.size() == 6 || (parts.size() == 7 && ParseCount(parts[6], 0, MaximumHalvings))) &&
    std::all_of(numbers.begin(), numbers.end(), [](double number) { return number == number; });
  if (!isBox)
  {
    return std::nullopt;
  }
  numbers.push_back(1.0);
  return RefinementBox{ { numbers[0], numbers[1], numbers[2] },
    { numbers[3], numbers[4], numbers[5] }, numbers[6] };
}

bool SetBoxes(Boxes& to, const std::string& text)
{
  Boxes boxes;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ';');)
  {
    const std::optional<RefinementBox> box = ParseBox(part);
    if (!box)
    {
      return false;
    }
    boxes.push_back(*box);
  }
  to = std::move(boxes);
  return true;
}

/// Kinds are only checked for an '='; PlanState, which knows the arrays, checks the rest.
bool SetTexts(const Option& option, Texts& to, const std::string& text)
{
  const Texts parts = text.empty() ? Texts() : SplitText(text);
  const bool areKinds = option.Kind == OptionKind::Kinds;
  const auto isGood = [=](const std::string& part)
  { return !areKinds || part.find('=') != std::string::npos; };
  if (!std::all_of(parts.begin(), parts.end(), isGood))
  {
    return false;
  }
  to.clear();
  for (const std::string& part : parts)
  {
    if (!part.empty() && std::find(to.begin(), to.end(), part) == to.end())
    {
      to.push_back(part);
    }
  }
  return true;
}

bool SetNumber(MesherOptions& options, const Option& option, const std::string& text)
{
  const std::optional<double> number = ParseValue(option, text);
  const bool isAllowed = number && RangeOf(option).Holds(*number);
  if (isAllowed)
  {
    option.SetNumber(options, *number);
  }
  return isAllowed;
}

/// Returns whether ranges or widths are allowed; true for other texts.
bool IsSound(OptionKind kind, const std::string& text)
{
  return kind == OptionKind::Ranges ? ParseRanges(text).has_value()
    : kind == OptionKind::Widths    ? ParseWidths(text).has_value()
    : kind == OptionKind::Sizes     ? ParseMaterialWidths(text).has_value()
                                    : true;
}

/// Returns whether the text is allowed; otherwise the options do not change.
bool SetText(MesherOptions& options, const Option& option, const std::string& given)
{
  if (option.SetNumber)
  {
    return SetNumber(options, option, given);
  }
  const std::string text = IsSameWord(given, "None") ? "" : given;
  if (!IsSound(option.Kind, text))
  {
    return false;
  }
  if (option.Text)
  {
    options.*option.Text = text;
    return true;
  }
  return option.Texts ? SetTexts(option, options.*option.Texts, text)
                      : SetBoxes(options.RefinementBoxes, text);
}

std::string Join(const Boxes& boxes)
{
  std::string text;
  for (const auto& [l, u, halvings] : boxes)
  {
    text += text.empty() ? "" : ";";
    for (double number : { l[0], l[1], l[2], u[0], u[1], u[2] })
    {
      text += FormatNumber(number) + ",";
    }
    text += FormatNumber(halvings);
  }
  return text;
}

/// Joins names; names with commas are quoted.
std::string JoinNames(Texts names)
{
  std::transform(names.begin(), names.end(), names.begin(), QuoteName);
  return JoinTexts(names);
}

std::string ListNames(ElementKind elements, const OptionTable& table)
{
  Texts names;
  for (const Option& option : table)
  {
    if (elements == ElementKind::Tets || !option.OnlyTets)
    {
      names.push_back(option.Name);
    }
  }
  return JoinTexts(names);
}

[[noreturn]] void Reject(const Option& option, const std::string& value)
{
  throw InputError(
    "The option " + option.Name + " cannot be '" + value + "': it takes " + option.Allowed() + ".");
}

void CheckLayers(const MesherOptions& options)
{
  if (options.Layers < 2)
  {
    return;
  }
  if (options.Elements == ElementKind::Tets)
  {
    throw InputError("Layers are for hexahedra: set Layers to 0 for tetrahedra.");
  }
  if (options.StairStep)
  {
    throw InputError("Layers need hexahedra along interfaces, which StairStep does not make.");
  }
  if (options.NodalVelocity)
  {
    throw InputError("NodalVelocity is not available for meshes with Layers.");
  }
}

void CheckFlat(const MesherOptions& options)
{
  if (!options.Flat)
  {
    return;
  }
  const auto reject = [](bool isSet, const std::string& name, const std::string& value)
  {
    if (isSet)
    {
      throw InputError("The option Flat, for meshes of a plane, does not support " + name +
        ": set it to " + value + ".");
    }
  };
  reject(options.Layers > 1 && options.Elements == ElementKind::Tets, "Layers of triangles", "0");
  reject(!options.SplitInterfaces.empty() && options.SplitConnection == ConnectionKind::Cohesive,
    "cohesive elements in SplitConnection", "None, Contact or Tied");
  reject(options.ElementOrder != InterpolationOrder::Linear, "ElementOrder", "Linear");
  reject(options.UnmeshedMaterial == Unmeshed::Particles, "Particles in UnmeshedMaterial", "Give");
}

void CheckOrder(const MesherOptions& options)
{
  if (options.ElementOrder == InterpolationOrder::Linear)
  {
    return;
  }
  if (!options.SplitInterfaces.empty() && options.SplitConnection == ConnectionKind::Cohesive)
  {
    throw InputError("SplitConnection Cohesive is for meshes of ElementOrder Linear: the formats "
                     "have no cohesive elements of second order. None, Contact and Tied are "
                     "available.");
  }
}

} // namespace

std::string Option::Allowed() const
{
  switch (this->Kind)
  {
    case OptionKind::Switch:
      return "on or off";
    case OptionKind::Integer:
      return DescribeRange("an integer", this->Range);
    case OptionKind::Real:
      return DescribeRange("a number", this->Range);
    case OptionKind::Choice:
      return JoinTexts(WithoutSpaces(this->Words)) + " (or 0 to " +
        std::to_string(this->Words.size() - 1) + ")";
    case OptionKind::Array:
      return "the name of a cell array, or None";
    case OptionKind::File:
      return "a file, or None";
    case OptionKind::Arrays:
      return "names of cell arrays with commas between them, or None";
    case OptionKind::Kinds:
      return "name=kind with commas between them, or None; kinds: mass, mass*other, volume, cell, "
             "extensive, copy";
    case OptionKind::Pairs:
      return "pairs of materials such as steel/copper or 1/3 with commas between them, all, or "
             "None";
    case OptionKind::Ranges:
      return "ranges that do not overlap, LOW:HIGH with LOW below HIGH, LOW or :HIGH, with commas "
             "between them, or None";
    case OptionKind::Widths:
      return "a number, 0 (as read) or more, or three such numbers with commas between them";
    case OptionKind::Sizes:
      return "auto, or entries such as steel=0.5, 3=1 or small=100:0.5 with commas between them "
             "and "
             "widths above 0, or None";
    case OptionKind::Boxes:
      return "x0,y0,z0,x1,y1,z1, optionally followed by the number of halvings, 0 to " +
        std::to_string(MaximumHalvings) + "; boxes are separated by semicolons";
  }
  return "";
}

const Option* FindOption(const std::string& name, const OptionTable& table)
{
  const auto found = std::find_if(table.begin(), table.end(),
    [&name](const Option& option) { return IsSameWord(option.Name, name); });
  return found == table.end() ? nullptr : &*found;
}

OptionRange RangeOf(const Option& option)
{
  OptionRange range = option.Range;
  if (option.Kind == OptionKind::Switch || option.Kind == OptionKind::Choice)
  {
    range.Least = 0.0;
    range.Most = std::max(1.0, static_cast<double>(option.Words.size()) - 1.0);
  }
  else if (option.Kind == OptionKind::Integer)
  {
    range.Least = std::max<double>(range.Least, std::numeric_limits<int>::min());
    range.Most = std::min<double>(range.Most, std::numeric_limits<int>::max());
  }
  return range;
}

void SetOption(MesherOptions& options, const std::string& name, const std::string& value,
  const OptionTable& table)
{
  const Option* option = FindOption(name, table);
  if (!option)
  {
    throw InputError("There is no option '" + name + "' (given '" + value +
      "'). The options are: " + ListNames(options.Elements, table) + ".");
  }
  if (option->OnlyTets && options.Elements != ElementKind::Tets)
  {
    throw InputError("The option " + option->Name + " (given '" + value +
      "') applies to tetrahedra only, and the mesh has hexahedra. Options for hexahedra: " +
      ListNames(options.Elements, table) + ".");
  }
  if (!SetText(options, *option, value))
  {
    Reject(*option, value);
  }
}

bool SetClamped(MesherOptions& options, const std::string& name, double value)
{
  const Option& option = *FindOption(name);
  const OptionRange range = RangeOf(option);
  const bool isKept =
    option.Kind == OptionKind::Real || (option.Kind == OptionKind::Integer && option.OnlyTets);
  const double taken = isKept ? value : std::clamp(value, range.Least, range.Most);
  const bool changes = taken != option.GetNumber(options);
  option.SetNumber(options, taken);
  return changes;
}

bool SetText(MesherOptions& options, const std::string& name, const std::string& value)
{
  std::string MesherOptions::*text = FindOption(name)->Text;
  std::string after = IsSameWord(value, "None") ? "" : value;
  const bool changes = options.*text != after;
  options.*text = std::move(after);
  return changes;
}

std::string GetOption(const MesherOptions& options, const Option& option)
{
  const auto orNone = [](const std::string& text) { return text.empty() ? "None" : text; };
  switch (option.Kind)
  {
    case OptionKind::Switch:
      return option.GetNumber(options) == 0.0 ? "off" : "on";
    case OptionKind::Integer:
    case OptionKind::Real:
      return FormatNumber(option.GetNumber(options));
    case OptionKind::Choice:
      return WithoutSpaces(option.Words)[static_cast<int>(option.GetNumber(options))];
    case OptionKind::Array:
    case OptionKind::File:
    case OptionKind::Pairs:
    case OptionKind::Ranges:
    case OptionKind::Widths:
    case OptionKind::Sizes:
      return orNone(options.*option.Text);
    case OptionKind::Arrays:
    case OptionKind::Kinds:
      return orNone(JoinNames(options.*option.Texts));
    case OptionKind::Boxes:
      return orNone(Join(options.RefinementBoxes));
  }
  return "";
}

std::vector<const Option*> ListChangedOptions(
  const MesherOptions& options, const OptionTable& table)
{
  const MesherOptions defaults;
  std::vector<const Option*> changed;
  for (const Option& option : table)
  {
    if (GetOption(options, option) != GetOption(defaults, option))
    {
      changed.push_back(&option);
    }
  }
  return changed;
}

void CheckOptions(const MesherOptions& options, const OptionTable& table)
{
  for (const Option& option : table)
  {
    const bool isNumber = option.Kind == OptionKind::Integer || option.Kind == OptionKind::Real;
    const bool isUsed = !option.OnlyTets || options.Elements == ElementKind::Tets;
    if (isNumber && isUsed && !option.Range.Holds(option.GetNumber(options)))
    {
      Reject(option, FormatNumber(option.GetNumber(options)));
    }
    if (option.Text && !IsSound(option.Kind, options.*option.Text))
    {
      Reject(option, options.*option.Text);
    }
  }
  CheckLayers(options);
  CheckFlat(options);
  CheckOrder(options);
}

std::vector<std::string> DescribeOptions(ElementKind elements, const OptionTable& table)
{
  MesherOptions defaults;
  Texts lines;
  for (const Option& option : table)
  {
    if (elements == ElementKind::Tets || !option.OnlyTets)
    {
      const std::string name = option.Argument.empty() ? "" : ", " + option.Argument;
      const std::string sentence = option.Meaning.substr(0, option.Meaning.find(". "));
      lines.push_back(option.Name + name + ": " + option.Allowed() + "; default " +
        GetOption(defaults, option) + (option.OnlyTets ? "; tetrahedra only" : "") + "\n      " +
        sentence + (sentence.back() == '.' ? "" : "."));
    }
  }
  return lines;
}

} // namespace vfm
