#include "OutputStage.h"

#include "ControllerRanks.h"
#include "Stage.h"

#include "vtkErrorCode.h"
#include "vtkXMLWriterBase.h"

namespace vfm
{

bool RunWriter(vtkXMLWriterBase* writer, const char* path, VtkMessages& messages)
{
  messages.Watch(writer);
  writer->SetFileName(path);
  writer->SetDataModeToBinary(); // inline: with Debian's newer expat VTK 9.2 reads no appended data
  const bool isGood = writer->Write();
  if (writer->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw std::runtime_error(vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode()));
  }
  return isGood;
}

void WriteInStage(const char* what, const std::string& path, vtkMultiProcessController* controller,
  const std::function<bool(VtkMessages&)>& write)
{
  ControllerRanks ranks(controller);
  VtkMessages messages;
  const VtkSilence silence(messages);
  try
  {
    WorkInStage(ranks, ExitCode::UnwritableOutput,
      [&]
      {
        if (!write(messages) || messages.HasErrors())
        {
          throw std::runtime_error(messages.GetErrorText());
        }
      });
  }
  catch (const ProgramError& error)
  {
    throw ProgramError(
      error.Code, std::string("Cannot write the ") + what + " " + path + ": " + error.what());
  }
}

} // namespace vfm
