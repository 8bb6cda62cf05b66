/**
 * MaterialGuess: what an array may hold, as far as its name, type and range tell. Filters and panels go by the same rules.
 */
#pragma once

#include "Input/ValueType.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <string>

namespace vfm
{

/// Whether an array of that name only says which cells or points are copies or blanked.
inline bool IsGhostName(const std::string& name)
{
  return name == "vtkGhostType" || name == "vtkGhostLevels";
}

/// Whether an array of that name numbers cells or points, as VTK, ParaView and the filters here name such arrays.
inline bool IsIdName(const std::string& name)
{
  const char* const names[] = { "GlobalCellIds", "GlobalPointIds", "vtkOriginalCellIds",
    "vtkOriginalPointIds", "GlobalElementId", "GlobalNodeId", "GlobalIds", "PedigreeElementId",
    "PedigreeNodeId", "PedigreeIds" };
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

/// Whether an array of that name is offered: none that VTK or ParaView keep for themselves.
inline bool IsOffered(const std::string& name)
{
  return !IsGhostName(name) && !IsIdName(name) && name != "vtkValidPointMask";
}

enum class MaterialGuess
{
  Nothing,  ///< neither
  Fraction, ///< volume fractions of a material
  Labels,   ///< a material a cell
  Unclear   ///< one or the other
};

/// Of an array of one component. type: of ValueType, 0 for several.
inline MaterialGuess GuessMaterial(int type, double least, double most)
{
  constexpr double rounding = 1e-6, maximumOfBytes = 255.0;
  if (IsRealType(type))
  {
    const bool areFractions = least >= -rounding && most <= 1.0 + rounding;
    return areFractions ? MaterialGuess::Fraction : MaterialGuess::Nothing;
  }
  const bool areBytes =
    type == ValueType::UnsignedChar && most == maximumOfBytes; // 255 may stand for 1
  const bool areLabels =
    least >= 0.0 && most > 0.0 && most <= std::numeric_limits<int>::max() && !areBytes;
  return areLabels ? MaterialGuess::Labels : MaterialGuess::Unclear;
}

} // namespace vfm
