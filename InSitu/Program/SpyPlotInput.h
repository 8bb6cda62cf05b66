/**
 * SpyPlotInput: files of the shock code CTH, by ParaView's reader where the build found it.
 */
#pragma once

#include "Arguments.h"
#include "Ranks.h"

#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;

namespace vfm
{

bool HasSpyPlotReader();

/// Whether an array of that name is the volume fraction of a material in a SpyPlot file.
bool IsSpyPlotFraction(const std::string& name);

/// Only where HasSpyPlotReader().
vtkSmartPointer<vtkAlgorithm> MakeSpyPlotReader(const Arguments& arguments);

/// On one rank: what is wrong with the files of a case, or an empty text, before all ranks read them: the reader crashes
/// or leaves out blocks when one of several files is bad, and does not tell the other ranks when the first one is. Empty
/// for readers of other files. VTK's messages tell more.
std::string FindSpyPlotProblem(vtkAlgorithm* reader, const Arguments& arguments);

/// Collective: has the reader, when it is one of SpyPlot files, read the arrays of the arguments, or the volume fractions,
/// and no others, and not as bytes. Its information must be up to date.
void ChooseSpyPlotArrays(vtkAlgorithm* reader, const Arguments& arguments, Ranks& ranks);

} // namespace vfm
