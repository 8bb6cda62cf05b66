/**
 * AmrexInput: plotfiles of codes on AMReX (BoxLib), which are folders, by VTK's reader.
 */
#pragma once

#include "Arguments.h"
#include "Ranks/Ranks.h"

#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;

namespace vfm
{

/// Whether it is a folder that holds a file Header.
bool IsAmrexFolder(const std::string& path);

/// On one rank: checks the structure, and of the blocks those of this rank. Throws InputError. Inputs of other kinds pass.
void CheckAmrexFolder(const Arguments& arguments, Ranks& ranks);

vtkSmartPointer<vtkAlgorithm> MakeAmrexReader(const Arguments& arguments);

/// Has the reader, when it is one of plotfiles, read the arrays of the arguments, or all where they name no materials or one that is missing. Its
/// information must be up to date.
void ChooseAmrexArrays(vtkAlgorithm* reader, const Arguments& arguments);

} // namespace vfm
