/**
 * MaterialGuess: guesses the content of an array from its name, type and range, for all front ends.
 */
#pragma once

#include "Input/ValueType.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <string>

namespace vfm
{

/// Returns whether a name is that of an array that marks ghost and blanked cells or points.
inline bool IsGhostName(const std::string& name)
{
  return name == "vtkGhostType" || name == "vtkGhostLevels";
}

/// Returns whether a name is used for ids of cells or points by VTK, ParaView or this project.
inline bool IsIdName(const std::string& name)
{
  const char* const names[] = { "GlobalCellIds", "GlobalPointIds", "vtkOriginalCellIds",
    "vtkOriginalPointIds", "GlobalElementId", "GlobalNodeId", "GlobalIds", "PedigreeElementId",
    "PedigreeNodeId", "PedigreeIds" };
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

/// Returns whether panels list an array of that name; internal arrays of VTK and ParaView are not.
inline bool IsOffered(const std::string& name)
{
  return !IsGhostName(name) && !IsIdName(name) && name != "vtkValidPointMask";
}

enum class MaterialGuess
{
  Nothing,  ///< neither fractions nor labels
  Fraction, ///< volume fractions of a material
  Labels,   ///< material of each cell
  Unclear   ///< fractions or labels
};

/// Guesses the content of an array of one component.
/// @param type one of ValueType; 0 if blocks have different types
inline MaterialGuess GuessMaterial(int type, double least, double most)
{
  constexpr double rounding = 1e-6, maximumOfBytes = 255.0;
  if (IsRealType(type))
  {
    const bool areFractions = least >= -rounding && most <= 1.0 + rounding;
    return areFractions ? MaterialGuess::Fraction : MaterialGuess::Nothing;
  }
  const bool areBytes = type == ValueType::UnsignedChar && most == maximumOfBytes; // 255 may mean 1
  const bool areLabels =
    least >= 0.0 && most > 0.0 && most <= std::numeric_limits<int>::max() && !areBytes;
  return areLabels ? MaterialGuess::Labels : MaterialGuess::Unclear;
}

} // namespace vfm
