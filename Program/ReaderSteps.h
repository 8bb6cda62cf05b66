/**
 * ReaderSteps: what reading any kind of file takes and gives: the file, the time, the reader's errors.
 */
#pragma once

#include "Arguments.h"
#include "Input/InputBlocks.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;

namespace vfm
{

class VtkMessages;

struct Input
{
  vtkSmartPointer<vtkDataObject> Data; ///< of this rank
  std::optional<double> Time;          ///< of the step that was read, where the file has times
  std::vector<double> Times = {};      ///< of all steps
  std::vector<InputBlock> Blocks = {}; ///< whose memory Data uses
};

/// Throws InputError (UnreadableInput), as all that follows.
[[noreturn]] void RefuseInput(const std::string& message);

/// Does a check, whose InputError does not name the input.
void CheckInput(const std::string& path, const std::function<void()>& check);

/// The file can be opened and is not empty. role: follows the path in the message.
void CheckInputFile(const std::string& path, const std::string& role = "");

/// Of a reader whose information is up to date; none where its file has no times.
std::vector<double> GetTimes(vtkAlgorithm* reader);

/// The one that the arguments ask for, else the first; nothing where the file has no times.
std::optional<double> ChooseTime(const Arguments& arguments, const std::vector<double>& times);

void CheckReaderErrors(const VtkMessages& messages, const std::string& path);

} // namespace vfm
