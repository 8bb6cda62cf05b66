#include "ChooseArrays.h"

#include "Base/ParseText.h"
#include "Images/ImageFile.h"
#include "Input/PlainArrays.h"
#include "Materials/ChooseMaterials.h"
#include "Ranks/Agreement.h"
#include "Ranks/WorkTogether.h"
#include "State/StateArrays.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <set>
#include <sstream>

namespace vfm
{
namespace
{

constexpr std::size_t ListedLabels = 20;
constexpr double LargestTolerance = 0.1; // largest value of --clip

bool Lists(const std::vector<std::string>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Lists the arrays that the arguments name for other purposes than materials.
std::vector<std::string> ListOthers(
  const std::vector<ArrayInfo>& arrays, const Arguments& arguments)
{
  std::vector<std::string> names;
  std::transform(arrays.begin(), arrays.end(), std::back_inserter(names),
    [](const ArrayInfo& array) { return array.Name; });
  return ListOtherArrays(arguments, names);
}

/// Returns what is known about the arrays of one place.
ChoiceRules MakeRules(const std::vector<ArrayInfo>& arrays, ArrayPlace place,
  const Arguments& arguments, double tolerance)
{
  ChoiceRules rules;
  rules.Tolerance = tolerance;
  rules.IsImage = IsImageFile(arguments.Input);
  rules.Others = ListOthers(arrays, arguments);
  rules.ArePoints = place == ArrayPlace::Points;
  rules.HasThreshold = !arguments.Mesher.Threshold.empty();
  return rules;
}

/// Returns a warning that lists arrays that would be fractions with a larger tolerance, or "".
std::string WarnOfNearFractions(const std::vector<ArrayInfo>& arrays, const ChoiceRules& rules)
{
  ChoiceRules wide = rules;
  wide.Tolerance = LargestTolerance;
  const std::vector<ContentOfArray> now = FindContents(arrays, rules);
  const std::vector<ContentOfArray> then = FindContents(arrays, wide);
  std::vector<std::string> names;
  double outside = 0.0;
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    const ArrayInfo& array = arrays[a];
    if (then[a].Content == ArrayContent::Fraction && now[a].Content != ArrayContent::Fraction &&
      !Lists(rules.Others, array.Name))
    {
      names.push_back(array.Name);
      outside = std::max({ outside, -array.Least, array.Most - 1.0 });
    }
  }
  if (names.empty())
  {
    return "";
  }
  std::ostringstream text;
  text << "Not used as volume fractions: " << JoinTexts(names) << ", with values up to " << outside
       << " outside [0, 1]. --clip T accepts values up to T outside.";
  return text.str();
}

/// Returns whether a user may miss an array among the materials; one of a single value is of no
/// interest.
bool IsOfInterest(const ArrayInfo& array, ArrayContent content)
{
  return array.Most > LabelTolerance && array.Least < array.Most && CanBeMaterial(content);
}

/// Returns a warning that lists arrays that can hold materials beside those that are chosen by
/// default, or "".
std::string WarnOfUnused(
  const std::vector<ArrayInfo>& arrays, const MaterialChoice& choice, const ChoiceRules& rules)
{
  std::vector<std::string> texts;
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    const std::string& name = arrays[a].Name;
    if (IsOfInterest(arrays[a], choice.Contents[a].Content) && name != choice.Labels &&
      !Lists(choice.Fractions, name) && !Lists(rules.Others, name))
    {
      texts.push_back("'" + name + "' (" + choice.Contents[a].Reason + ")");
    }
  }
  const bool isFound = !choice.Fractions.empty() || !choice.Labels.empty();
  return choice.IsClear || !isFound || texts.empty()
    ? ""
    : "Not used: " + JoinTexts(texts) + ". --fractions or --labels selects arrays.";
}

/// Reports that the input has no materials, and lists its arrays.
/// @pre Collective
[[noreturn]] void RejectArrays(
  const Input& input, const Arguments& arguments, const ChosenArrays& chosen, Ranks& ranks)
{
  std::string text = "Cannot mesh " + arguments.Input +
    ": no array can be meshed without a choice. " + chosen.Problem + " " +
    DescribeArrays(input, ranks);
  if (!ListOtherArrays(arguments, {}).empty())
  {
    text +=
      " Arrays of --state, --density, --velocity, --energy and --refine-cells are not used as "
      "materials, unless --fractions or --labels names them.";
  }
  text += chosen.Warning.empty() ? "" : " " + chosen.Warning;
  throw InputError(ErrorCode::UnreadableInput,
    text +
      " Name the fractions (--fractions A,B,..), an array of labels (--labels ARRAY), or ranges "
      "of values (--threshold LOW:HIGH).");
}

/// Returns the index of a material in the list of arrays.
/// @param material  name of its array, or its number from 1
std::size_t FindMaterial(const std::string& material, const std::vector<std::string>& fractions)
{
  const auto name = std::find(fractions.begin(), fractions.end(), material);
  if (name != fractions.end())
  {
    return name - fractions.begin();
  }
  const auto number = ParseCount(material, 1, static_cast<int>(fractions.size()));
  if (!number)
  {
    std::vector<std::string> known;
    for (std::size_t m = 0; m < fractions.size(); ++m)
    {
      known.push_back(std::to_string(m + 1) + " " + fractions[m]);
    }
    throw InputError(ErrorCode::WrongArguments,
      "There is no material '" + material +
        "' (--material). The materials are: " + JoinTexts(known) + ".");
  }
  return *number - 1;
}

/// Checks that an array that --material changes is not used for state or refinement.
void CheckUse(const Arguments& arguments, const std::string& name)
{
  if (Lists(arguments.State, name))
  {
    throw InputError(ErrorCode::WrongArguments,
      "The array '" + name + "' cannot be transferred (--state), because --material changes it.");
  }
  if (arguments.Mesher.RefinementArray == name)
  {
    throw InputError(ErrorCode::WrongArguments,
      "Cells cannot be refined by '" + name +
        "' (--refine-cells), because --material changes this array.");
  }
}

/// Replaces arrays of the blocks.
/// @param add  add(arrays, replaced) adds the new arrays; called once for blocks with common arrays
template <class Add>
void ReplaceArrays(std::vector<InputBlock>& blocks, const Add& add)
{
  std::map<std::shared_ptr<const BlockArrays>, std::shared_ptr<PlainArrays>> all;
  for (InputBlock& block : blocks)
  {
    std::shared_ptr<PlainArrays>& replaced = all[block.Arrays];
    if (!replaced)
    {
      replaced = std::make_shared<PlainArrays>(block.Arrays);
      add(*block.Arrays, *replaced);
    }
    block.Arrays = replaced;
  }
}

void KeepFractions(std::vector<InputBlock>& blocks, const std::vector<std::string>& fractions,
  const Arguments& arguments)
{
  std::vector<std::string> dropped = fractions;
  for (const std::string& material : arguments.Materials)
  {
    dropped[FindMaterial(material, fractions)].clear();
  }
  dropped.erase(std::remove(dropped.begin(), dropped.end(), ""), dropped.end());
  for (const std::string& name : dropped)
  {
    CheckUse(arguments, name);
  }
  ReplaceArrays(blocks,
    [&dropped](const BlockArrays& own, PlainArrays& replaced)
    {
      for (const std::string& name : dropped)
      {
        if (const auto array = own.Find(name))
        {
          // Signed char is the smallest type whose values are not scaled by 1/255.
          replaced.Store(name, ValueType::SignedChar, Buffer<signed char>(array->Tuples, 0));
        }
      }
    });
}

/// Returns an array with one component, otherwise null; the mesher then reports the error.
std::shared_ptr<const BlockArray> GetLabels(const BlockArrays& arrays, const std::string& name)
{
  const auto array = arrays.Find(name);
  return array && array->Components == 1 ? array : nullptr;
}

/// Converts a value to a label; 0 for void and for invalid values, which the mesher rejects.
int GetLabel(double value)
{
  const double label = std::round(value);
  const bool isInt = label > 0.0 && label <= std::numeric_limits<int>::max(); // false for NaN
  return isInt ? static_cast<int>(label) : 0;
}

/// Adds a copy of an array in which all labels except `kept` are 0.
void AddLabels(
  const std::string& name, const BlockArray& array, const std::set<int>& kept, PlainArrays& to)
{
  const int type = CarrierType(array.Type);
  VisitType(type,
    [&](auto tag)
    {
      using Value = typename decltype(tag)::Type;
      Buffer<Value> values(array.Tuples);
      if (array.Memory)
      {
        std::memcpy(values.data(), array.Memory, array.Tuples * sizeof(Value));
      }
      else
      {
        array.Copy(0, array.Tuples, values.data());
      }
      for (Value& value : values)
      {
        value = kept.count(GetLabel(static_cast<double>(value))) > 0 ? value : Value(0);
      }
      to.Store(name, type, std::move(values));
    });
}

std::set<int> ParseLabels(const std::vector<std::string>& materials)
{
  std::set<int> labels;
  for (const std::string& material : materials)
  {
    const auto label = ParseCount(material, 1, std::numeric_limits<int>::max());
    if (!label)
    {
      throw InputError(ErrorCode::WrongArguments,
        "'" + material + "' is not a label (--material). Labels are integers from 1.");
    }
    labels.insert(*label);
  }
  return labels;
}

void CheckLabels(const std::set<int>& kept, const std::vector<int>& found, const std::string& name)
{
  for (int label : kept)
  {
    if (!std::binary_search(found.begin(), found.end(), label))
    {
      std::vector<std::string> known;
      for (std::size_t i = 0; i < std::min(found.size(), ListedLabels); ++i)
      {
        known.push_back(std::to_string(found[i]));
      }
      throw InputError(ErrorCode::WrongArguments,
        "There is no material " + std::to_string(label) + " (--material) in the array '" + name +
          "'. It holds " + JoinTexts(known) + (found.size() > ListedLabels ? ", ..." : "") + ".");
    }
  }
}

/// Returns whether any rank has a numeric array of a name.
/// @pre Collective
bool HasArray(const Input& input, ArrayPlace place, const std::string& name, Ranks& ranks)
{
  const ArrayLists lists = ListsOf(input, place);
  return ranks.Any(std::any_of(lists.begin(), lists.end(),
    [&name](const auto& arrays) { return arrays->Find(name) != nullptr; }));
}

/// Rejects arrays that no rank has in cells, or in the points of images. The mesher checks their
/// types and values.
/// @param option  option that names the arrays
/// @return place of the last array
/// @pre Collective
ArrayPlace CheckNamedArrays(const Input& input, const std::string& option,
  const std::vector<std::string>& names, Ranks& ranks)
{
  ArrayPlace place = ArrayPlace::Cells;
  for (const std::string& name : names)
  {
    place = ArrayPlace::Cells;
    if (HasArray(input, ArrayPlace::Cells, name, ranks))
    {
      continue;
    }
    place = ArrayPlace::Points;
    const bool isOfPoints = HasArray(input, ArrayPlace::Points, name, ranks);
    if (isOfPoints && AreImages(input, ranks))
    {
      continue;
    }
    throw InputError(ErrorCode::UnreadableInput,
      (isOfPoints ? "The array '" + name + "' (" + option + ") has values of points, not of cells. "
                  : "The input has no numeric array '" + name + "' (" + option + "). ") +
        DescribeArrays(input, ranks));
  }
  return place;
}

/// Returns the materials among the arrays of one place; possibly none.
ChosenArrays FindMaterials(const std::vector<ArrayInfo>& arrays, ArrayPlace place,
  const Arguments& arguments, double tolerance)
{
  const ChoiceRules rules = MakeRules(arrays, place, arguments, tolerance);
  MaterialChoice choice = ChooseMaterials(arrays, rules);
  const bool isComplete = choice.AreNamed || (rules.IsImage && !choice.Labels.empty());
  std::string warning;
  if (!isComplete)
  {
    const std::string near = WarnOfNearFractions(arrays, rules);
    const std::string unused = WarnOfUnused(arrays, choice, rules);
    warning = near + (near.empty() || unused.empty() ? "" : " ") + unused;
  }
  return { std::move(choice.Fractions), std::move(choice.Labels), std::move(choice.How),
    std::move(warning), place, std::move(choice.Problem), true };
}

bool HasMaterials(const ChosenArrays& arrays)
{
  return !arrays.Fractions.empty() || !arrays.Labels.empty();
}

} // namespace

ChosenArrays FindMaterials(
  const Input& input, const Arguments& arguments, double tolerance, Ranks& ranks)
{
  const std::vector<ArrayInfo> cells = FindArrays(input, ArrayPlace::Cells, ranks);
  const ChosenArrays ofCells = FindMaterials(cells, ArrayPlace::Cells, arguments, tolerance);
  if (HasMaterials(ofCells) || !AreImages(input, ranks))
  {
    return ofCells;
  }
  const ChosenArrays ofPoints = FindMaterials(
    FindArrays(input, ArrayPlace::Points, ranks), ArrayPlace::Points, arguments, tolerance);
  return HasMaterials(ofPoints) || cells.empty() ? ofPoints : ofCells;
}

std::vector<ContentOfArray> DescribeContents(
  const std::vector<ArrayInfo>& arrays, ArrayPlace place, const Arguments& arguments)
{
  return FindContents(
    arrays, MakeRules(arrays, place, arguments, arguments.Mesher.FractionTolerance));
}

std::vector<int> FindLabels(const ArrayLists& lists, const std::string& name, Ranks& ranks)
{
  std::set<int> found;
  WorkInStage(ranks, ErrorCode::InternalError,
    [&]
    {
      for (const std::shared_ptr<const BlockArrays>& arrays : lists)
      {
        const auto array = GetLabels(*arrays, name);
        for (Index cell = 0; array && cell < array->Tuples; ++cell)
        {
          found.insert(GetLabel(array->Get(cell, 0)));
        }
      }
    });
  return UnionOverRanks(ranks, std::vector<int>(found.upper_bound(0), found.end()));
}

ChosenArrays ChooseArrays(const Input& input, const Arguments& arguments, Ranks& ranks)
{
  const MesherOptions& mesher = arguments.Mesher;
  const ArrayPlace ofFractions = CheckNamedArrays(input, "--fractions", arguments.Fractions, ranks);
  CheckNamedArrays(input, "--density", mesher.DensityArrays, ranks); // State contains them too
  CheckNamedArrays(input, "--state", arguments.State, ranks);
  if (!mesher.RefinementArray.empty())
  {
    CheckNamedArrays(input, "--refine-cells", { mesher.RefinementArray }, ranks);
  }
  const bool isOfLabels = !arguments.Labels.empty();
  const ArrayPlace place =
    isOfLabels ? CheckNamedArrays(input, "--labels", { arguments.Labels }, ranks) : ofFractions;
  const char* ofPoints = place == ArrayPlace::Points ? " of points" : "";
  ChosenArrays chosen{ arguments.Fractions, arguments.Labels,
    (isOfLabels ? "labels" : "as requested") + std::string(ofPoints), "", place, "", false };
  if (!HasMaterials(chosen))
  {
    chosen.Fractions = input.Materials;
    chosen.How = "surfaces";
  }
  if (!HasMaterials(chosen))
  {
    chosen = FindMaterials(input, arguments, mesher.FractionTolerance, ranks);
  }
  if (!HasMaterials(chosen))
  {
    RejectArrays(input, arguments, chosen, ranks);
  }
  return chosen;
}

void KeepMaterials(std::vector<InputBlock>& blocks, const ChosenArrays& arrays,
  const Arguments& arguments, Ranks& ranks)
{
  if (arguments.Materials.empty())
  {
    return;
  }
  if (arrays.Labels.empty())
  {
    WorkInStage(ranks, ErrorCode::WrongArguments,
      [&] { KeepFractions(blocks, arrays.Fractions, arguments); });
    return;
  }
  CheckUse(arguments, arrays.Labels);
  if (arguments.Mesher.ZeroLabel == ZeroLabelMeaning::Material)
  {
    throw InputError(ErrorCode::WrongArguments,
      "--material cannot be combined with --zero-label Material, because materials that are not "
      "listed become label 0. Use --threshold, or assign label 0 another number.");
  }
  const std::set<int> kept = ParseLabels(arguments.Materials);
  CheckLabels(kept, FindLabels(ListsOf(blocks), arrays.Labels, ranks), arrays.Labels);
  WorkInStage(ranks, ErrorCode::InternalError,
    [&]
    {
      ReplaceArrays(blocks,
        [&](const BlockArrays& own, PlainArrays& replaced)
        {
          if (const auto labels = GetLabels(own, arrays.Labels))
          {
            AddLabels(arrays.Labels, *labels, kept, replaced);
          }
        });
    });
}

} // namespace vfm
