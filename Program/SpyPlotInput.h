/**
 * SpyPlotInput: files of the shock code CTH, by ParaView's reader where the build found it.
 */
#pragma once

#include "Arguments.h"
#include "Ranks/Ranks.h"
#include "SpyPlotFile.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkAlgorithm;

namespace vfm
{

constexpr const char* SpyPlotSuffix = ".spcth";

bool HasSpyPlotReader();

/// Whether an array of that name is the volume fraction of a material in a SpyPlot file.
bool IsSpyPlotFraction(const std::string& name);

/// On one rank, before all read: the share of this rank in the binary files of a case, checked. Throws InputError when one is
/// missing, damaged, or holds other times or arrays than the first: ParaView's reader would crash or leave out blocks, and
/// does not tell the other ranks. Empty for inputs of other kinds.
std::vector<SpyPlotFile> OpenSpyPlotFiles(const Arguments& arguments, int rank, int ranks);

/// On one rank: checks the values of what ChooseSpyPlotArrays() chooses. Throws InputError.
void CheckSpyPlotArrays(
  const std::vector<SpyPlotFile>& files, double time, const Arguments& arguments);

/// Only where HasSpyPlotReader().
vtkSmartPointer<vtkAlgorithm> MakeSpyPlotReader(const Arguments& arguments);

/// Collective: has the reader, when it is one of SpyPlot files, read the arrays of the arguments, or the volume fractions,
/// and no others, and not as bytes. Its information must be up to date.
void ChooseSpyPlotArrays(vtkAlgorithm* reader, const Arguments& arguments, Ranks& ranks);

} // namespace vfm
