/**
 * ArrayContent: finds what arrays hold, from their names, types and ranges, for all front ends.
 *
 * Documentation/reference/arrays.md has the table of the rules.
 */
#pragma once

#include "Input/ArrayInfo.h"

#include <string>
#include <vector>

namespace vfm
{

enum class ArrayContent
{
  Fraction, ///< volume fraction of one material
  Mask,     ///< integers 0 and 1: one material, or labels
  Labels,   ///< integers from 0: the material of each cell
  Grey,     ///< other numbers from 0: grey values or another quantity
  LevelSet, ///< reals of both signs: level set, signed distance, component of a vector
  Unclear,  ///< labels or volume fractions: the user has to tell
  Other     ///< ids, marks, masses, vectors, void
};

struct ContentOfArray
{
  ArrayContent Content = ArrayContent::Other;
  std::string Reason; ///< for messages: "unsigned char up to 255: 255 is full"
};

/// Facts that arrays alone do not show.
struct ContentRules
{
  double Tolerance = 1e-6; ///< largest distance of volume fractions from [0, 1]
  bool IsImage = false;    ///< bytes are labels, as in image files, not fractions of 255
};

/// Returns whether an array of a content can hold materials.
constexpr bool CanBeMaterial(ArrayContent content)
{
  return content == ArrayContent::Fraction || content == ArrayContent::Mask ||
    content == ArrayContent::Labels;
}

/// Returns whether an array has one integer per cell.
bool IsWhole(const ArrayInfo& array);

/// Returns the content of each array. Bytes, except labels by name, are fractions of 255 if any of
/// their arrays reaches 255, and Unclear if their largest value is above LargestEmptyByte.
std::vector<ContentOfArray> FindContents(
  const std::vector<ArrayInfo>& arrays, const ContentRules& rules);

/// Returns the word of a content for lists: "fraction", "level set".
const char* NameOfContent(ArrayContent content);

} // namespace vfm
