#include "Materials/ArrayContent.h"

#include "Fractions/FractionField.h"
#include "Input/ArrayNames.h"
#include "Input/FractionChecks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace vfm
{
namespace
{

constexpr double LargestLabel = std::numeric_limits<int>::max();
constexpr double FullByte = 255.0;

bool AreBytes(const ArrayInfo& array)
{
  return array.Type == ValueType::UnsignedChar && array.Components == 1;
}

bool IsLabelsName(const std::string& name)
{
  return FindLabelsRank(name) >= 0;
}

std::string Print(double number)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%g", number);
  return text;
}

std::string Range(const ArrayInfo& array)
{
  return Print(array.Least) + " to " + Print(array.Most);
}

/// Returns the content that the name of an array determines; Content Labels: none.
ContentOfArray FindContentByName(const ArrayInfo& array)
{
  const std::string& name = array.Name;
  if (array.HoldsIds || IsIdName(name))
  {
    return { ArrayContent::Other, "ids of cells or points" };
  }
  if (!IsOffered(name))
  {
    return { ArrayContent::Other, "marks of cells or points" };
  }
  if (array.Components != 1)
  {
    return { ArrayContent::Other, std::to_string(array.Components) + " components" };
  }
  if (IsVoidName(name))
  {
    return { ArrayContent::Other, "named void, which is no material" };
  }
  if (IsMassName(name) && !IsSpyPlotFraction(name))
  {
    return { ArrayContent::Other, "named as a mass or density" };
  }
  if (IsStateName(name) && IsRealType(array.Type) && !IsFractionName(name))
  {
    return { ArrayContent::Other, "named as a state of the material" };
  }
  if (IsBookkeepingName(name))
  {
    return { ArrayContent::Other, "named as a processor, level or number of a cell" };
  }
  return { ArrayContent::Labels, "" };
}

ContentOfArray FindContentOfIntegers(const ArrayInfo& array)
{
  if (std::round(array.Least) < 0.0)
  {
    return { ArrayContent::Other,
      "integers from " + Range(array) +
        ": labels are 0 (void) or positive; replace negative ids by unused ones" };
  }
  if (array.Most > LargestLabel)
  {
    return { ArrayContent::Other,
      "integers from " + Range(array) + ": labels are at most " +
        std::to_string(std::numeric_limits<int>::max()) };
  }
  if (std::round(array.Most) <= 1.0)
  {
    return { ArrayContent::Mask,
      std::round(array.Most) == 0.0 ? "integers that are all 0: no material"
                                    : "integers 0 and 1: 1 is full" };
  }
  return { ArrayContent::Labels, "integers from " + Range(array) };
}

ContentOfArray FindContentOfReals(const ArrayInfo& array, double tolerance)
{
  const double outside = std::max(-array.Least, array.Most - 1.0);
  if (outside <= tolerance)
  {
    return { ArrayContent::Fraction, "real numbers in [0, 1]" };
  }
  if (array.AreWhole)
  {
    ContentOfArray found = FindContentOfIntegers(array);
    found.Reason = "real numbers that are " + found.Reason;
    return found;
  }
  if (outside <= LargestFractionTolerance)
  {
    return { ArrayContent::Grey,
      "real numbers up to " + Print(outside) +
        " outside [0, 1]: volume fractions with FractionTolerance " +
        Print(SufficientTolerance(outside)) + " (--clip " + Print(SufficientTolerance(outside)) +
        ")" };
  }
  if (array.Least < 0.0 && array.Most > 0.0)
  {
    const char* what = IsDistanceName(array.Name)
      ? "a level set or signed distance"
      : "probably a level set or signed distance, or a component of a vector";
    return { ArrayContent::LevelSet,
      "values of both signs, " + Range(array) + ": " + what +
        " (LevelSets Priority, --level-set)" };
  }
  return { ArrayContent::Grey,
    "real numbers from " + Range(array) + ": neither in [0, 1] nor integers" +
      (array.NotWhole == 0.0 ? "" : ", such as " + Print(array.NotWhole)) };
}

/// Returns the largest value of the arrays of bytes that may be fractions of 255.
double FindLargestByte(const std::vector<ArrayInfo>& arrays)
{
  double most = 0.0;
  for (const ArrayInfo& array : arrays)
  {
    const bool isIncluded = AreBytes(array) && !IsLabelsName(array.Name) &&
      FindContentByName(array).Content == ArrayContent::Labels;
    most = isIncluded ? std::max(most, array.Most) : most;
  }
  return most;
}

/// Returns the content of an array of bytes, except labels by name.
/// @param most  largest value of all such arrays, above LargestEmptyByte unless this array has the
///   name of a fraction
ContentOfArray FindContentOfBytes(const ArrayInfo& array, double most)
{
  if (most >= FullByte || IsFractionName(array.Name))
  {
    return { ArrayContent::Fraction, "unsigned char up to " + Print(array.Most) + ": 255 is full" };
  }
  return { ArrayContent::Unclear,
    "unsigned char up to " + Print(array.Most) +
      (most > array.Most ? ", next to " + Print(most) : "") +
      ", never 255: labels, or fractions of 255 that fill no cell" };
}

} // namespace

bool IsWhole(const ArrayInfo& array)
{
  return array.Components == 1 && !IsRealType(array.Type);
}

std::vector<ContentOfArray> FindContents(
  const std::vector<ArrayInfo>& arrays, const ContentRules& rules)
{
  const double most = rules.IsImage ? 0.0 : FindLargestByte(arrays);
  std::vector<ContentOfArray> contents;
  for (const ArrayInfo& array : arrays)
  {
    ContentOfArray found = FindContentByName(array);
    if (found.Content == ArrayContent::Labels)
    {
      const bool areOf255 = AreBytes(array) && !rules.IsImage && !IsLabelsName(array.Name) &&
        (most > LargestEmptyByte || (array.Most > 1.0 && IsFractionName(array.Name)));
      found = areOf255           ? FindContentOfBytes(array, most)
        : IsRealType(array.Type) ? FindContentOfReals(array, rules.Tolerance)
                                 : FindContentOfIntegers(array);
    }
    contents.push_back(std::move(found));
  }
  return contents;
}

const char* NameOfContent(ArrayContent content)
{
  const char* const names[] = { "fraction", "mask", "labels", "grey values", "level set", "unclear",
    "other" };
  return names[static_cast<int>(content)];
}

} // namespace vfm
