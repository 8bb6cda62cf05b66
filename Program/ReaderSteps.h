/**
 * ReaderSteps: what reading any kind of file takes and gives: the file, the time, the reader's errors.
 */
#pragma once

#include "Arguments.h"
#include "Input.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

class vtkAlgorithm;

namespace vfm
{

class VtkMessages;

/// Throws InputError (UnreadableInput), as all that follows.
[[noreturn]] void RejectInput(const std::string& message);

/// Does a step of reading, whose InputError does not name the input. head: of the message, before the path.
void CheckInput(const std::string& path, const std::function<void()>& step,
  const std::string& head = "Cannot read the input ");

/// The file can be opened and is not empty. role: follows the path in the message.
void CheckInputFile(const std::string& path, const std::string& role = "");

/// Of a reader whose information is up to date; none where its file has no times.
std::vector<double> GetTimes(vtkAlgorithm* reader);

/// The one that the arguments ask for, else the first; nothing where the file has no times.
std::optional<double> ChooseTime(const Arguments& arguments, const std::vector<double>& times);

/// The arrays of materials that the arguments name, and the others (ListOtherArrays).
std::vector<std::string> ListNamedArrays(
  const Arguments& arguments, const std::vector<std::string>& there);

/// Reads a piece at a time, where the file has times.
void UpdatePiece(
  vtkAlgorithm* reader, const std::optional<double>& time, int piece, int numberOfPieces);

void CheckReaderErrors(const VtkMessages& messages, const std::string& path);

} // namespace vfm
