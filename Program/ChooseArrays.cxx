#include "ChooseArrays.h"

#include "Base/ParseText.h"
#include "Images/ImageFile.h"
#include "Input/GuessMaterials.h"
#include "Ranks/Agreement.h"
#include "Ranks/WorkTogether.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkSignedCharArray.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <set>
#include <sstream>

namespace vfm
{
namespace
{

constexpr std::size_t ListedLabels = 20;
constexpr double LargestTolerance = 0.1; // of fractions, as the mesher takes it

bool Lists(const std::vector<std::string>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Files of images hold one array, of labels where it is of whole numbers.
bool HoldsLabels(const std::string& path, const std::vector<ArrayInfo>& arrays)
{
  return IsImageFile(path) && arrays.size() == 1 && IsWhole(arrays[0]);
}

/// Those of arrays that the arguments name as no materials.
std::vector<std::string> ListOthers(
  const std::vector<ArrayInfo>& arrays, const Arguments& arguments)
{
  std::vector<std::string> names;
  std::transform(arrays.begin(), arrays.end(), std::back_inserter(names),
    [](const ArrayInfo& array) { return array.Name; });
  return ListOtherArrays(arguments, names);
}

/// Those that would be fractions if values a little outside of [0, 1] were.
std::string WarnOfNearFractions(
  const std::vector<ArrayInfo>& arrays, const Arguments& arguments, double tolerance)
{
  std::vector<std::string> names;
  double outside = 0.0;
  const std::vector<std::string> others = ListOthers(arrays, arguments);
  for (const ArrayInfo& array : arrays)
  {
    if (IsFraction(array, LargestTolerance) && !IsFraction(array, tolerance) &&
      !Lists(others, array.Name))
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
  text << "Not taken for volume fractions: " << JoinTexts(names) << ", with values up to "
       << outside << " outside [0, 1]. --clip T takes those that lie outside by no more than T.";
  return text.str();
}

/// Collective.
[[noreturn]] void RefuseArrays(
  vtkDataObject* data, const Arguments& arguments, const std::string& warning, Ranks& ranks)
{
  std::string text =
    "No array of the input that can be meshed holds volume fractions: numbers in [0, 1] of type "
    "float or double, or unsigned char. " +
    DescribeArrays(data, ranks);
  if (!ListOtherArrays(arguments, {}).empty())
  {
    text += " Those of --state, --density, --velocity, --energy and --refine-cells are taken for "
            "others, unless named as --fractions.";
  }
  text += warning.empty() ? "" : " " + warning;
  throw InputError(ErrorCode::UnreadableInput,
    text + " Name them (--fractions A,B,..), or an array of labels (--labels ARRAY).");
}

/// The place of a material in the list of arrays.
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

void ReplaceByZeros(vtkDataSetAttributes* attributes, const std::string& name)
{
  vtkNew<vtkSignedCharArray> zeros; // the smallest type that does not count 0..255
  zeros->SetName(name.c_str());
  zeros->SetNumberOfTuples(attributes->GetArray(name.c_str())->GetNumberOfTuples());
  zeros->Fill(0);
  attributes->AddArray(zeros);
}

/// Of an array that --material changes.
void CheckUse(const ChosenArrays& arrays, const std::string& name)
{
  if (Lists(arrays.State, name))
  {
    throw InputError(ErrorCode::WrongArguments,
      "The elements cannot carry '" + name + "' (--state): --material leaves materials of it out.");
  }
  if (arrays.Refinement == name)
  {
    throw InputError(ErrorCode::WrongArguments,
      "Cells cannot be refined by '" + name +
        "' (--refine-cells): --material leaves materials of it out.");
  }
}

void KeepFractions(
  vtkDataObject* data, const ChosenArrays& arrays, const std::vector<std::string>& materials)
{
  const std::vector<std::string>& fractions = arrays.Fractions;
  std::set<std::size_t> kept;
  for (const std::string& material : materials)
  {
    kept.insert(FindMaterial(material, fractions));
  }
  for (std::size_t m = 0; m < fractions.size(); ++m)
  {
    if (kept.count(m) > 0)
    {
      continue;
    }
    CheckUse(arrays, fractions[m]);
    for (vtkDataSet* grid : GetGrids(data))
    {
      vtkDataSetAttributes* attributes = GetAttributes(grid, arrays.Place);
      if (attributes->GetArray(fractions[m].c_str()))
      {
        ReplaceByZeros(attributes, fractions[m]);
      }
    }
  }
}

/// Null when it is none of labels, as the mesher's message tells.
vtkDataArray* GetLabels(vtkDataSet* grid, const ChosenArrays& arrays)
{
  vtkDataArray* array = GetAttributes(grid, arrays.Place)->GetArray(arrays.Labels.c_str());
  return array && array->GetNumberOfComponents() == 1 ? array : nullptr;
}

/// 0 of void, and of what is no label: that the mesher refuses.
int GetLabel(vtkDataArray* array, vtkIdType cell)
{
  const double value = array->GetComponent(cell, 0);
  const bool isInt = value > 0.0 && value <= std::numeric_limits<int>::max(); // nor NaN
  return isInt ? static_cast<int>(value) : 0;
}

/// Sets labels that are not kept to 0.
void KeepLabels(vtkDataSet* grid, const ChosenArrays& arrays, const std::set<int>& kept)
{
  vtkDataArray* array = GetLabels(grid, arrays);
  if (!array)
  {
    return;
  }
  vtkSmartPointer<vtkDataArray> changed;
  changed.TakeReference(array->NewInstance());
  changed->DeepCopy(array);
  for (vtkIdType cell = 0; cell < array->GetNumberOfTuples(); ++cell)
  {
    if (kept.count(GetLabel(array, cell)) == 0)
    {
      changed->SetComponent(cell, 0, 0.0);
    }
  }
  GetAttributes(grid, arrays.Place)->AddArray(changed);
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
        "'" + material + "' is no label (--material): labels are whole numbers from 1.");
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

/// How many ranks have a numeric array of that name. Collective.
std::int64_t CountRanksWith(
  vtkDataObject* data, ArrayPlace place, const std::string& name, Ranks& ranks)
{
  const std::vector<vtkDataSet*> grids = GetGrids(data);
  std::vector<std::int64_t> count{ std::any_of(grids.begin(), grids.end(),
    [&](vtkDataSet* grid)
    { return GetAttributes(grid, place)->GetArray(name.c_str()) != nullptr; }) };
  ranks.Sum(count);
  return count[0];
}

/// Collective: refuses names of arrays that no rank has where they can be meshed; what else they must be the mesher checks. Returns the
/// place of the last. option: that names them.
ArrayPlace CheckNamedArrays(vtkDataObject* data, const std::string& option,
  const std::vector<std::string>& names, Ranks& ranks)
{
  ArrayPlace place = ArrayPlace::Cells;
  for (const std::string& name : names)
  {
    place = ArrayPlace::Cells;
    if (CountRanksWith(data, ArrayPlace::Cells, name, ranks) > 0)
    {
      continue;
    }
    place = ArrayPlace::Points;
    const bool isOfPoints = CountRanksWith(data, ArrayPlace::Points, name, ranks) > 0;
    if (isOfPoints && AreImages(data, ranks))
    {
      continue;
    }
    throw InputError(ErrorCode::UnreadableInput,
      (isOfPoints ? "The array '" + name + "' (" + option + ") has values of points, not of cells. "
                  : "The input has no numeric array '" + name + "' (" + option + "). ") +
        DescribeArrays(data, ranks));
  }
  return place;
}

/// Of arrays in one place: the materials, maybe none.
ChosenArrays FindMaterials(const std::vector<ArrayInfo>& arrays, ArrayPlace place,
  const Arguments& arguments, double tolerance)
{
  const bool isOfPoints = place == ArrayPlace::Points;
  GuessedMaterials guess = GuessMaterials(arrays, ListOthers(arrays, arguments), tolerance);
  if (!guess.AreNumbered && HoldsLabels(arguments.Input, arrays))
  {
    guess = { {}, arrays[0].Name };
  }
  ChosenArrays chosen{ guess.Fractions, guess.Labels, arguments.State, "", "" };
  chosen.Place = place;
  if (guess.AreNumbered)
  {
    chosen.How = "named Material volume fraction - N";
    return chosen;
  }
  chosen.How =
    std::string("all ") + (isOfPoints ? "point" : "cell") + " arrays with values in [0, 1]";
  if (!guess.Labels.empty())
  {
    chosen.How = isOfPoints ? "labels of points" : "labels";
  }
  if (!HoldsLabels(arguments.Input, arrays))
  {
    chosen.Warning = WarnOfNearFractions(arrays, arguments, tolerance);
  }
  return chosen;
}

bool HasMaterials(const ChosenArrays& arrays)
{
  return !arrays.Fractions.empty() || !arrays.Labels.empty();
}

} // namespace

ChosenArrays FindMaterials(
  vtkDataObject* data, const Arguments& arguments, double tolerance, Ranks& ranks)
{
  const std::vector<ArrayInfo> cells = FindArrays(data, ArrayPlace::Cells, ranks);
  const ChosenArrays ofCells = FindMaterials(cells, ArrayPlace::Cells, arguments, tolerance);
  if (HasMaterials(ofCells) || !AreImages(data, ranks))
  {
    return ofCells;
  }
  const ChosenArrays ofPoints = FindMaterials(
    FindArrays(data, ArrayPlace::Points, ranks), ArrayPlace::Points, arguments, tolerance);
  return HasMaterials(ofPoints) || cells.empty() ? ofPoints : ofCells;
}

std::vector<int> FindLabels(vtkDataObject* data, const ChosenArrays& arrays, Ranks& ranks)
{
  std::set<int> found;
  WorkInStage(ranks, ErrorCode::InternalError,
    [&]
    {
      for (vtkDataSet* grid : GetGrids(data))
      {
        vtkDataArray* array = GetLabels(grid, arrays);
        for (vtkIdType cell = 0; array && cell < array->GetNumberOfTuples(); ++cell)
        {
          found.insert(GetLabel(array, cell));
        }
      }
    });
  return Unite(ranks, std::vector<int>(found.upper_bound(0), found.end()));
}

ChosenArrays ChooseArrays(
  vtkDataObject* data, const Arguments& arguments, double tolerance, Ranks& ranks)
{
  const ArrayPlace ofFractions = CheckNamedArrays(data, "--fractions", arguments.Fractions, ranks);
  CheckNamedArrays(data, "--density", arguments.Mesher.DensityArrays, ranks); // which State has too
  CheckNamedArrays(data, "--state", arguments.State, ranks);
  if (!arguments.Mesher.RefinementArray.empty())
  {
    CheckNamedArrays(data, "--refine-cells", { arguments.Mesher.RefinementArray }, ranks);
  }
  const bool isOfLabels = !arguments.Labels.empty();
  const ArrayPlace place =
    isOfLabels ? CheckNamedArrays(data, "--labels", { arguments.Labels }, ranks) : ofFractions;
  const char* ofPoints = place == ArrayPlace::Points ? " of points" : "";
  ChosenArrays chosen{ arguments.Fractions, arguments.Labels, arguments.State,
    (isOfLabels ? "labels" : "as asked") + std::string(ofPoints), "" };
  chosen.Place = place;
  if (!HasMaterials(chosen))
  {
    chosen = FindMaterials(data, arguments, tolerance, ranks);
  }
  if (!HasMaterials(chosen))
  {
    RefuseArrays(data, arguments, chosen.Warning, ranks);
  }
  chosen.Refinement = arguments.Mesher.RefinementArray;
  return chosen;
}

void KeepMaterials(vtkDataObject* data, const ChosenArrays& arrays,
  const std::vector<std::string>& materials, Ranks& ranks)
{
  if (materials.empty())
  {
    return;
  }
  if (arrays.Labels.empty())
  {
    WorkInStage(ranks, ErrorCode::WrongArguments, [&] { KeepFractions(data, arrays, materials); });
    return;
  }
  CheckUse(arrays, arrays.Labels);
  const std::set<int> kept = ParseLabels(materials);
  CheckLabels(kept, FindLabels(data, arrays, ranks), arrays.Labels);
  WorkInStage(ranks, ErrorCode::InternalError,
    [&]
    {
      for (vtkDataSet* grid : GetGrids(data))
      {
        KeepLabels(grid, arrays, kept);
      }
    });
}

} // namespace vfm
