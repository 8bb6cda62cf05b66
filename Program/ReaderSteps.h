/**
 * ReaderSteps: common steps of the readers: checks of the file, choice of the time, errors of VTK.
 * All functions throw InputError (UnreadableInput).
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

/// Rejects the input with a message.
[[noreturn]] void RejectInput(const std::string& message);

/// Calls a step of reading and puts the path in front of the message of its InputError.
/// @param head  text in front of the path
void CheckInput(const std::string& path, const std::function<void()>& step,
  const std::string& head = "Cannot read the input ");

/// Checks that a file can be opened and is not empty.
/// @param role  text after the path in the message
void CheckInputFile(const std::string& path, const std::string& role = "");

/// Returns the times of a reader whose information is up to date; empty if its file has no times.
std::vector<double> GetTimes(vtkAlgorithm* reader);

/// Returns the time that the arguments select, by default the first; nothing if there are no times.
std::optional<double> ChooseTime(const Arguments& arguments, const std::vector<double>& times);

/// Lists the arrays of materials that the arguments name, and the others (ListOtherArrays).
std::vector<std::string> ListNamedArrays(
  const Arguments& arguments, const std::vector<std::string>& there);

/// Reads a piece of the data, at a time if the file has times.
void UpdatePiece(
  vtkAlgorithm* reader, const std::optional<double>& time, int piece, int numberOfPieces);

/// Rejects the input if VTK has reported errors.
void CheckReaderErrors(const VtkMessages& messages, const std::string& path);

} // namespace vfm
