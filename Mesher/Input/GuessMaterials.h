/**
 * GuessMaterials: which arrays of an input hold its materials, where nobody names them.
 */
#pragma once

#include "Input/ArrayInfo.h"

#include <string>
#include <vector>

namespace vfm
{

/// Name of arrays of labels, as readers of voxels and the meshes have it.
constexpr const char* LabelsName = "MaterialId";

struct GuessedMaterials
{
  std::vector<std::string> Fractions; ///< of material 1, 2, ...
  std::string Labels;                 ///< empty: fractions, or nothing
  bool AreNumbered = false;           ///< Fractions have the names of SpyPlot files
};

/// Whether an array of that name is the volume fraction of a material in a SpyPlot file.
bool IsSpyPlotFraction(const std::string& name);

/// Whether an array has one whole number per cell.
bool IsWhole(const ArrayInfo& array);

/// Whether values of an array are fractions: bytes, or real numbers in [0, 1] up to tolerance.
bool IsFraction(const ArrayInfo& array, double tolerance);

/// Returns the arrays that are named like those of SpyPlot files, by material; else all fractions but MaterialId and others; else
/// MaterialId as labels; else nothing. others: names of arrays that hold no materials.
GuessedMaterials GuessMaterials(
  const std::vector<ArrayInfo>& arrays, const std::vector<std::string>& others, double tolerance);

} // namespace vfm
