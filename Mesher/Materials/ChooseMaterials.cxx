#include "Materials/ChooseMaterials.h"

#include "Base/ParseText.h"
#include "Input/ArrayNames.h"

#include <algorithm>
#include <cstdlib>

namespace vfm
{
namespace
{

constexpr std::size_t LongestList = 12; // arrays named in a message

/// An array that may hold materials.
struct Candidate
{
  const ArrayInfo& Array;
  const ContentOfArray& Found;
};

using Candidates = std::vector<Candidate>;

template <class Condition>
Candidates Select(const Candidates& from, const Condition& condition)
{
  Candidates selected;
  std::copy_if(from.begin(), from.end(), std::back_inserter(selected), condition);
  return selected;
}

std::vector<std::string> NamesOf(const Candidates& arrays)
{
  std::vector<std::string> names;
  std::transform(arrays.begin(), arrays.end(), std::back_inserter(names),
    [](const Candidate& array) { return array.Array.Name; });
  return names;
}

std::string Describe(const Candidates& arrays)
{
  std::vector<std::string> texts;
  for (std::size_t a = 0; a < std::min(arrays.size(), LongestList); ++a)
  {
    texts.push_back("'" + arrays[a].Array.Name + "' (" + arrays[a].Found.Reason + ")");
  }
  return JoinTexts(texts) + (arrays.size() > LongestList ? ", .." : "");
}

bool IsFraction(const Candidate& array)
{
  return array.Found.Content == ArrayContent::Fraction;
}

bool IsMask(const Candidate& array)
{
  return array.Found.Content == ArrayContent::Mask;
}

bool IsUnclear(const Candidate& array)
{
  return array.Found.Content == ArrayContent::Unclear;
}

bool AreLabels(const Candidate& array)
{
  return array.Found.Content == ArrayContent::Labels || IsMask(array);
}

/// Returns the SpyPlot arrays, ordered by material number.
std::vector<std::string> FindSpyPlotFractions(const Candidates& arrays)
{
  std::vector<std::string> names = NamesOf(Select(arrays,
    [](const Candidate& array)
    { return IsSpyPlotFraction(array.Array.Name) && !IsVoidName(array.Array.Name); }));
  const auto number = [](const std::string& name)
  { return std::atoi(name.c_str() + name.rfind(' ') + 1); };
  std::stable_sort(names.begin(), names.end(),
    [&number](const std::string& a, const std::string& b) { return number(a) < number(b); });
  return names;
}

/// Returns the arrays whose names say volume fraction, if any of them is one. The others belong to
/// them: the mesher reports their values outside of [0, 1].
std::vector<std::string> FindNamedFractions(const Candidates& arrays)
{
  const Candidates named = Select(arrays,
    [](const Candidate& array)
    {
      return IsFractionName(array.Array.Name) && array.Found.Content != ArrayContent::Other &&
        (IsFraction(array) || IsRealType(array.Array.Type));
    });
  return std::any_of(named.begin(), named.end(), IsFraction) ? NamesOf(named)
                                                             : std::vector<std::string>();
}

/// Selects fractions by their names. Returns whether there are any.
/// @param known  all arrays; names as in SpyPlot files are materials even if they are also state
bool ChooseNamedFractions(const Candidates& known, const Candidates& arrays, MaterialChoice& choice)
{
  choice.Fractions = FindSpyPlotFractions(known);
  choice.How = "named Material volume fraction - N";
  if (choice.Fractions.empty())
  {
    choice.Fractions = FindNamedFractions(arrays);
    choice.How = "named as volume fractions";
  }
  choice.IsClear = choice.AreNamed = !choice.Fractions.empty();
  return choice.AreNamed;
}

/// Returns the masks of integers that are materials next to fractions: not those with a name of
/// labels, not those of 1 only, which would fill every cell twice, and not those of 0 only next to
/// fractions that are no masks.
Candidates FindOwnMasks(const Candidates& integers, bool areMasks)
{
  return Select(integers,
    [areMasks](const Candidate& array)
    {
      return IsMask(array) && FindLabelsRank(array.Array.Name) < 0 &&
        array.Array.Least < LabelTolerance && (areMasks || array.Array.Most > LabelTolerance);
    });
}

/// Returns the arrays of integers that contradict fractions: a usual name of labels (MaterialId,
/// which our meshes contain next to fractions, does not count), a mask with the name of a state, or
/// labels next to masks only.
Candidates FindRivals(const Candidates& integers, bool areMasks)
{
  return Select(integers,
    [areMasks](const Candidate& array)
    {
      const int rank = FindLabelsRank(array.Array.Name);
      const bool isOther = IsMask(array) ? IsStateName(array.Array.Name) : areMasks;
      return array.Array.Most > LabelTolerance && (rank > 0 || (rank < 0 && isOther));
    });
}

/// Selects all fractions, and masks of integers next to them, unless other arrays contradict them.
/// @param fractions  arrays with this content; at least one
void ChooseAllFractions(const Candidates& candidates, const Candidates& fractions,
  const Candidates& integers, const ChoiceRules& rules, MaterialChoice& choice)
{
  const bool areMasks = std::all_of(fractions.begin(), fractions.end(),
    [](const Candidate& array) { return array.Array.AreWhole; });
  const Candidates rivals = FindRivals(integers, areMasks);
  if (!rivals.empty())
  {
    choice.Problem = "Labels " + Describe(rivals) + " or volume fractions " + Describe(fractions) +
      " can hold the materials.";
    return;
  }
  const Candidates masks = FindOwnMasks(integers, areMasks);
  const std::vector<std::string> ofMasks = NamesOf(masks);
  choice.Fractions = NamesOf(Select(candidates,
    [&ofMasks](const Candidate& array)
    {
      return IsFraction(array) ||
        std::find(ofMasks.begin(), ofMasks.end(), array.Array.Name) != ofMasks.end();
    }));
  choice.How =
    std::string("all ") + (rules.ArePoints ? "point" : "cell") + " arrays with values in [0, 1]";
  choice.IsClear = masks.size() == integers.size() &&
    (choice.Fractions.size() == 1 || (areMasks && !masks.empty()));
}

/// Selects the labels or the masks among arrays of one kind.
/// @param kind "integers", or "real numbers that are integers"
void ChooseLabels(const Candidates& all, const std::string& kind, MaterialChoice& choice)
{
  const Candidates arrays =
    Select(all, [](const Candidate& array) { return array.Array.Most > LabelTolerance; });
  const auto rank = [](const Candidate& array) { return FindLabelsRank(array.Array.Name); };
  const Candidate* named = nullptr;
  for (const Candidate& array : arrays)
  {
    named = rank(array) >= 0 && (!named || rank(array) < rank(*named)) ? &array : named;
  }
  if (named || arrays.size() == 1)
  {
    choice.Labels = (named ? *named : arrays.front()).Array.Name;
    choice.How = arrays.size() == 1 ? "labels, the only array of " + kind : "labels by its name";
    choice.IsClear = arrays.size() == 1;
  }
  else if (!arrays.empty() && std::all_of(arrays.begin(), arrays.end(), IsMask))
  {
    choice.Fractions = NamesOf(all);
    choice.How = "masks, 1 is full";
    choice.IsClear = true;
  }
  else
  {
    choice.Problem = arrays.empty()
      ? "Arrays of " + kind + " hold only 0, no material: " + Describe(all) + "."
      : "Several arrays of " + kind + " can hold the materials: " + Describe(arrays) + ".";
  }
}

/// Selects the only array of numbers, whose ranges of values are the materials.
void ChooseForThreshold(const Candidates& arrays, MaterialChoice& choice)
{
  const Candidates numbers = Select(arrays,
    [](const Candidate& array) {
      return array.Array.Components == 1 && !array.Array.HoldsIds && IsOffered(array.Array.Name);
    });
  choice.IsClear = numbers.size() == 1;
  choice.How = "the only array, by ranges of its values";
  choice.Labels = choice.IsClear ? numbers.front().Array.Name : "";
  choice.Problem = choice.IsClear ? ""
    : numbers.empty()             ? "No array holds one number per cell, as Threshold requires."
                      : "Threshold takes one array, and there are several: " + Describe(numbers) +
      ". Choose one as labels.";
}

} // namespace

MaterialChoice ChooseMaterials(const std::vector<ArrayInfo>& arrays, const ChoiceRules& rules)
{
  MaterialChoice choice;
  choice.Contents = FindContents(arrays, rules);
  Candidates known, candidates;
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    known.push_back({ arrays[a], choice.Contents[a] });
    if (std::find(rules.Others.begin(), rules.Others.end(), arrays[a].Name) == rules.Others.end())
    {
      candidates.push_back(known.back());
    }
  }
  if (rules.HasThreshold)
  {
    ChooseForThreshold(candidates, choice);
    return choice;
  }
  if (ChooseNamedFractions(known, candidates, choice))
  {
    return choice;
  }
  choice.How.clear();
  const Candidates fractions = Select(candidates, IsFraction);
  const Candidates unclear = Select(candidates, IsUnclear);
  const Candidates integers = Select(
    candidates, [](const Candidate& array) { return AreLabels(array) && IsWhole(array.Array); });
  const Candidates reals = Select(
    candidates, [](const Candidate& array) { return AreLabels(array) && !IsWhole(array.Array); });
  if (!unclear.empty())
  {
    choice.Problem = "Labels or volume fractions: " + Describe(unclear) + ".";
  }
  else if (!fractions.empty())
  {
    ChooseAllFractions(candidates, fractions, integers, rules, choice);
  }
  else if (!integers.empty() || !reals.empty())
  {
    integers.empty() ? ChooseLabels(reals, "real numbers that are integers", choice)
                     : ChooseLabels(integers, "integers", choice);
  }
  else
  {
    choice.Problem = candidates.empty()
      ? "There is no array of cells that can hold materials."
      : "No array holds volume fractions or labels: " + Describe(candidates) + ".";
  }
  return choice;
}

} // namespace vfm
