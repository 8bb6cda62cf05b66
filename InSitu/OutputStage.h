/**
 * OutputStage: writing of files by all ranks together, with one message when it fails.
 */
#pragma once

#include "VtkMessages.h"

#include <functional>
#include <string>

class vtkMultiProcessController;
class vtkXMLWriterBase;

namespace vfm
{

/// Writes binary data inline. False, or an error among the messages, when it fails; throws std::runtime_error, which tells why, where
/// the writer knows it: its messages are less plain.
bool RunWriter(vtkXMLWriterBase* writer, const char* path, VtkMessages& messages);

/// Collective: does the work, which is to write a file or this rank's part of it; false, or an error among the messages: it failed. Throws
/// ProgramError (UnwritableOutput) on all ranks then: that what, such as "output", cannot be written there.
void WriteInStage(const char* what, const std::string& path, vtkMultiProcessController* controller,
  const std::function<bool(VtkMessages&)>& write);

} // namespace vfm
