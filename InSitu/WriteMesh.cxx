#include "WriteMesh.h"

#include "Base/ParseText.h"
#include "ControllerRanks.h"
#include "FileSuffix.h"
#include "GatherMesh.h"
#include "OutputStage.h"
#include "Stage.h"
#include "WriteAbaqus.h"
#include "WriteExodus.h"

#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLPUnstructuredGridWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <unistd.h>

namespace vfm
{
namespace
{

using Writer = bool (*)(
  vtkUnstructuredGrid*, const char* path, vtkMultiProcessController*, VtkMessages&);

struct Format
{
  const char* Suffix;
  Writer Write;       ///< collective; false, or an error among the messages, when it fails
  Writer WriteSingle; ///< one file from several ranks; null when there is none such
};

bool WriteVtu(vtkUnstructuredGrid* mesh, const char* path, vtkMultiProcessController* controller,
  VtkMessages& messages)
{
  ControllerRanks ranks(controller);
  const vtkSmartPointer<vtkUnstructuredGrid> whole = GatherMesh(mesh, ranks);
  if (ranks.Rank() > 0)
  {
    return true;
  }
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(whole);
  return RunWriter(writer, path, messages);
}

bool WritePvtu(vtkUnstructuredGrid* mesh, const char* path, vtkMultiProcessController* controller,
  VtkMessages& messages)
{
  vtkNew<vtkXMLPUnstructuredGridWriter> writer;
  writer->SetController(controller);
  writer->SetInputData(mesh);
  writer->SetUseSubdirectory(true);
  writer->SetNumberOfPieces(controller->GetNumberOfProcesses());
  writer->SetStartPiece(controller->GetLocalProcessId());
  writer->SetEndPiece(controller->GetLocalProcessId());
  return RunWriter(writer, path, messages);
}

template <ExodusParts parts>
bool WriteExodusFiles(
  vtkUnstructuredGrid* mesh, const char* path, vtkMultiProcessController* controller, VtkMessages&)
{
  ControllerRanks ranks(controller);
  WriteExodus(mesh, path, ranks, parts);
  return true;
}

bool WriteInp(
  vtkUnstructuredGrid* mesh, const char* path, vtkMultiProcessController* controller, VtkMessages&)
{
  ControllerRanks ranks(controller);
  WriteAbaqus(mesh, path, ranks);
  return true;
}

constexpr Writer WriteExodusParts = WriteExodusFiles<ExodusParts::OneARank>;
constexpr Writer WriteExodusFile = WriteExodusFiles<ExodusParts::One>;

constexpr Format Formats[] = { { ".vtu", WriteVtu, WriteVtu }, { ".pvtu", WritePvtu, nullptr },
  { ".e", WriteExodusParts, WriteExodusFile }, { ".ex2", WriteExodusParts, WriteExodusFile },
  { ".exo", WriteExodusParts, WriteExodusFile }, { ".inp", WriteInp, WriteInp } };

const Format* FindFormat(const std::string& path)
{
  const auto found = std::find_if(std::begin(Formats), std::end(Formats),
    [&path](const Format& format) { return HasSuffix(path, format.Suffix); });
  return found == std::end(Formats) ? nullptr : found;
}

} // namespace

std::vector<std::string> GetOutputSuffixes()
{
  std::vector<std::string> suffixes;
  for (const Format& format : Formats)
  {
    suffixes.emplace_back(format.Suffix);
  }
  return suffixes;
}

void CheckOutputSuffix(const std::string& path, OutputFiles files)
{
  const Format* format = FindFormat(path);
  if (!format)
  {
    throw ProgramError(ExitCode::WrongArguments,
      "The output " + path + " is of an unknown kind. Written are " +
        JoinTexts(GetOutputSuffixes()) + ".");
  }
  if (files == OutputFiles::Single && !format->WriteSingle)
  {
    throw ProgramError(
      ExitCode::WrongArguments, "The output " + path + " is always several files.");
  }
}

void CheckOutputFolder(const std::string& path)
{
  const std::size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  if (access(folder.c_str(), W_OK | X_OK) != 0)
  {
    throw ProgramError(ExitCode::UnwritableOutput,
      "Cannot write the output " + path + ": " + std::strerror(errno) + ".");
  }
}

void WriteMesh(vtkUnstructuredGrid* mesh, const std::string& path,
  vtkMultiProcessController* controller, OutputFiles files)
{
  const Format& format = *FindFormat(path);
  const Writer write = files == OutputFiles::Single ? format.WriteSingle : format.Write;
  WriteInStage("output", path, controller,
    [&](VtkMessages& messages) { return write(mesh, path.c_str(), controller, messages); });
}

} // namespace vfm
