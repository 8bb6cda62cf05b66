#include "MakeMesh.h"

#include "Base/Runtime.h"
#include "ControllerRanks.h"
#include "Ranks/WorkTogether.h"
#include "VtkMessages.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeFractionToHex.h"
#include "vtkVolumeFractionToTet.h"

#include <cstdio>
#include <iostream>
#include <memory>
#include <unistd.h>

namespace vfm
{
namespace
{

/// One line of a terminal, rewritten while the mesher works and cleared at the end.
class ProgressLine
{
public:
  explicit ProgressLine(vtkAlgorithm& algorithm) : Algorithm(algorithm)
  {
    this->Observer->SetCallback(&ProgressLine::Show);
    algorithm.AddObserver(vtkCommand::ProgressEvent, this->Observer);
  }
  ~ProgressLine()
  {
    this->Algorithm.RemoveObserver(this->Observer);
    std::fprintf(stderr, "\r\033[K");
  }

private:
  static void Show(vtkObject* caller, unsigned long, void*, void*)
  {
    vtkAlgorithm* algorithm = static_cast<vtkAlgorithm*>(caller);
    const char* stage = algorithm->GetProgressText();
    std::fprintf(
      stderr, "\r\033[K%3.0f %% %s", 100.0 * algorithm->GetProgress(), stage ? stage : "");
    std::fflush(stderr);
  }
  vtkAlgorithm& Algorithm;
  vtkNew<vtkCallbackCommand> Observer;
};

void SetArrays(vtkVolumeFractionMeshAlgorithm& mesher, const ChosenArrays& arrays)
{
  for (const std::string& name : arrays.Fractions)
  {
    mesher.AddVolumeFractionArray(name.c_str());
  }
  mesher.SetMaterialIdArray(arrays.Labels.c_str());
  for (const std::string& name : arrays.State)
  {
    mesher.AddStateArray(name.c_str());
  }
}

void CheckErrors(const VtkMessages& messages)
{
  if (messages.HasErrors())
  {
    throw InputError(
      messages.TellsLackOfMemory() ? ErrorCode::InternalError : ErrorCode::RefusedMesh,
      messages.GetErrorText());
  }
}

} // namespace

vtkSmartPointer<vtkVolumeFractionMeshAlgorithm> MakeMesher(const Arguments& arguments)
{
  vtkSmartPointer<vtkVolumeFractionMeshAlgorithm> mesher;
  if (arguments.Tets)
  {
    mesher = vtkSmartPointer<vtkVolumeFractionToTet>::New();
  }
  else
  {
    mesher = vtkSmartPointer<vtkVolumeFractionToHex>::New();
  }
  for (const auto& [name, value] : arguments.Options)
  {
    mesher->SetOption(name, value);
  }
  return mesher;
}

vtkSmartPointer<vtkUnstructuredGrid> MakeMesh(vtkVolumeFractionMeshAlgorithm& mesher,
  vtkDataObject* data, const ChosenArrays& arrays, bool isQuiet,
  vtkMultiProcessController* controller)
{
  ControllerRanks ranks(controller);
  VtkMessages messages;
  const VtkSilence silence(messages);
  messages.Watch(&mesher);
  mesher.SetController(controller);
  mesher.SetInputDataObject(data);
  SetArrays(mesher, arrays);
  WorkInStage(ranks, ErrorCode::RefusedMesh,
    [&]
    {
      const bool isShown = !isQuiet && ranks.Rank() == 0 && isatty(STDERR_FILENO);
      const auto line = isShown ? std::make_unique<ProgressLine>(mesher) : nullptr;
      mesher.UpdatePiece(ranks.Rank(), ranks.Count(), 0);
      CheckErrors(messages);
    });
  for (const std::string& warning : messages.GetWarnings())
  {
    std::cerr << "sculptor: warning: " << warning << "\n";
  }
  return vtkUnstructuredGrid::SafeDownCast(mesher.GetOutputDataObject(0));
}

} // namespace vfm
