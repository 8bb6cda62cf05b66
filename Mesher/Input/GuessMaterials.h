/**
 * GuessMaterials: selects the arrays of materials if the user does not.
 */
#pragma once

#include "Input/ArrayInfo.h"

#include <string>
#include <vector>

namespace vfm
{

/// Name of label arrays in meshes and in the output of voxel readers.
constexpr const char* LabelsName = "MaterialId";

struct GuessedMaterials
{
  std::vector<std::string> Fractions; ///< arrays of material 1, 2, ...
  std::string Labels;                 ///< array of labels; empty: fractions, or nothing
  bool AreNumbered = false;           ///< true if Fractions have names as in SpyPlot files
};

/// Returns whether a name is that of a volume fraction in a SpyPlot file.
bool IsSpyPlotFraction(const std::string& name);

/// Returns whether an array has one integer per cell.
bool IsWhole(const ArrayInfo& array);

/// Returns whether all values are fractions: unsigned char, or reals in [0, 1] up to tolerance.
bool IsFraction(const ArrayInfo& array, double tolerance);

/// Selects the arrays of materials: arrays with names as in SpyPlot files, ordered by material;
/// else all fractions except MaterialId and others; else MaterialId as labels; else nothing.
/// @param others names of arrays that do not hold materials
GuessedMaterials GuessMaterials(
  const std::vector<ArrayInfo>& arrays, const std::vector<std::string>& others, double tolerance);

} // namespace vfm
