/**
 * VtkFileCheck: checks a file of VTK, legacy or XML, before a reader of VTK opens it.
 *
 * The readers end the program, need memory without bound, or return other values, if a file
 * contradicts itself. Checked are the type of the file, version and byte order, the extents and
 * numbers of points and cells, each value of each array, and the files that a file names.
 */
#pragma once

#include "GridFiles/VtkStorage.h"
#include "GridFiles/XmlOutline.h"

namespace vfm
{

/// Part of the arrays and named files of a file that a rank checks.
struct VtkCheckShare
{
  int Rank = 0, Ranks = 1;

  bool Has(int number) const { return number % this->Ranks == this->Rank; }
};

/// Functions of libraries that not every program has.
struct VtkFileTools
{
  ReadVtkOutline ReadOutline;
  UnpackVtkBlock Unpack;
};

/// Checks a file by its suffix; files of other suffixes are not checked. All ranks together check
/// all of it, so none may open it before all are done.
/// @throws InputError  if the file or one that it names cannot be read, is damaged, or is of
///   another type; the message does not contain the path
void CheckVtkFile(
  const std::string& path, const VtkFileTools& tools, const VtkCheckShare& share = {});

} // namespace vfm
