/**
 * sculptor: meshes volume fractions in a file, on any number of MPI ranks.
 */
#include "ArgumentOptions.h"
#include "Arguments.h"
#include "Base/ParseText.h"
#include "Base/Runtime.h"
#include "BuiltInTest.h"
#include "ChooseArrays.h"
#include "ControllerRanks.h"
#include "ListInput.h"
#include "MakeMesh.h"
#include "MeshDataOfGrid.h"
#include "Meshes/WriteMesh.h"
#include "Meshes/WriteTable.h"
#include "PrintSummary.h"
#include "Ranks/WorkTogether.h"
#include "ReadInput.h"
#include "State/ArrayStems.h"
#include "Summary/FragmentTable.h"
#include "Summary/MeshMaterials.h"
#include "WriteGeometry.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkMPI.h"
#include "vtkMPIController.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeFractionMeshAlgorithm.h"

#include <algorithm>
#include <chrono>
#include <iostream>

namespace vfm
{
namespace
{

/// Seconds since it was last asked, of the slowest rank. Collective.
class StageTimes
{
public:
  explicit StageTimes(Ranks& ranks) : Group(ranks) {}
  void Add(const char* name)
  {
    const auto now = std::chrono::steady_clock::now();
    this->Times.push_back(
      { name, this->Group.Max(std::chrono::duration<double>(now - this->Last).count()) });
    this->Last = std::chrono::steady_clock::now();
  }
  const std::vector<StageTime>& Get() const { return this->Times; }

private:
  Ranks& Group;
  std::chrono::steady_clock::time_point Last = std::chrono::steady_clock::now();
  std::vector<StageTime> Times;
};

void PrintHead(const Arguments& arguments, const Input& input, const ChosenArrays& arrays)
{
  std::cout << arguments.Input << " -> " << arguments.Output << "\n";
  if (input.Time)
  {
    std::cout << "time " << *input.Time << "\n";
  }
  std::cout << "materials from "
            << (arrays.Labels.empty() ? JoinTexts(arrays.Fractions) : arrays.Labels) << " ("
            << arrays.How << ")\n\n";
}

/// The arrays of the mesh that hold the densities: those of their names or, where arrays a material became one, that of their stem.
std::vector<std::string> FindDensities(const MeshData& mesh, const Arguments& arguments)
{
  std::vector<std::string> names;
  std::vector<int> labels;
  for (const auto& material : NamesOfMaterials(mesh))
  {
    labels.push_back(material.first);
    names.push_back(material.second);
  }
  const std::vector<std::string>&densities = arguments.Mesher.DensityArrays,
        &states = arguments.State;
  const auto isState = [&states](const std::string& name)
  { return std::find(states.begin(), states.end(), name) != states.end(); };
  const bool isLost = !densities.empty() && !FindArray(mesh.ElementArrays, densities[0]);
  if (isLost)
  {
    for (const ArrayStem& stem : MaterialStems(names, labels).FindStems(densities[0]))
    {
      if (std::all_of(stem.Members.begin(), stem.Members.end(), isState))
      {
        return { stem.Name };
      }
    }
  }
  return densities;
}

void WriteFragments(const MeshData& mesh, const Arguments& arguments, Ranks& ranks)
{
  if (arguments.Fragments.empty())
  {
    return;
  }
  FieldArrays table;
  WorkInStage(ranks, ErrorCode::UnreadableInput,
    [&] { table = MakeFragmentTable(mesh, FindDensities(mesh, arguments), ranks); });
  WorkInStage(ranks, ErrorCode::UnwritableOutput,
    [&]
    {
      if (ranks.Rank() > 0)
      {
        return;
      }
      PrefixErrors("Cannot write the table " + arguments.Fragments + ": ",
        [&] { WriteTable(table, arguments.Fragments); });
    });
}

void MeshFile(const Arguments& arguments, vtkMultiProcessController* controller)
{
  ControllerRanks ranks(controller);
  StageTimes times(ranks);
  const auto mesher = MakeMesher(arguments);
  WorkInStage(ranks, ErrorCode::UnwritableOutput,
    [&]
    {
      for (const std::string& path : { arguments.Output, arguments.Fragments, arguments.Geometry })
      {
        const std::string problem = path.empty() ? "" : FindFolderProblem(path);
        if (!problem.empty())
        {
          throw InputError(problem);
        }
      }
    });
  const Input input = ReadInput(arguments, ranks);
  const ChosenArrays arrays =
    ChooseArrays(input.Data, arguments, mesher->GetFractionTolerance(), ranks);
  if (ranks.Rank() == 0 && !arrays.Warning.empty())
  {
    std::cerr << "sculptor: warning: " << arrays.Warning << "\n";
  }
  KeepMaterials(input.Data, arrays, arguments.Materials, ranks);
  times.Add("read");
  const auto mesh = MakeMesh(*mesher, input.Data, arrays, arguments.Quiet, controller);
  if (input.Time)
  {
    mesh->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), *input.Time);
  }
  times.Add("mesh");
  const StoredMesh plain = MeshDataOf(mesh);
  WorkInStage(ranks, ErrorCode::UnwritableOutput,
    [&]
    {
      WriteMesh(plain.Data, arguments.Output, ranks,
        arguments.SingleFile ? OutputFiles::Single : OutputFiles::AsUsual);
    });
  WriteFragments(plain.Data, arguments, ranks);
  if (!arguments.Geometry.empty())
  {
    WriteGeometry(*mesher, input.Time ? &*input.Time : nullptr, arguments.Geometry, controller);
  }
  times.Add("write");
  if (!arguments.Quiet)
  {
    const MeshSummary summary = Summarise(plain.Data, ranks);
    if (ranks.Rank() == 0)
    {
      PrintHead(arguments, input, arrays);
      PrintSummary(summary, times.Get(), std::cout);
    }
  }
}

/// Exit status of a failure: 1 to 4 are its code, 5 is any other.
int StatusOf(ErrorCode code)
{
  const bool isListed = code >= ErrorCode::WrongArguments && code <= ErrorCode::UnwritableOutput;
  return static_cast<int>(isListed ? code : ErrorCode::InternalError);
}

/// Returns the exit status.
int Work(const Arguments& arguments, vtkMultiProcessController* controller)
{
  const bool isFirst = controller->GetLocalProcessId() == 0;
  switch (arguments.Task)
  {
    case Command::Help:
      std::cout << (isFirst ? GetHelp() : "");
      break;
    case Command::Version:
      std::cout << (isFirst ? "sculptor " VFM_VERSION "\n" : "");
      break;
    case Command::Test:
      return RunBuiltInTest(arguments, controller) ? 0 : StatusOf(ErrorCode::RefusedMesh);
    case Command::List:
    {
      ControllerRanks ranks(controller);
      ListInput(arguments, ranks, std::cout);
      break;
    }
    case Command::Mesh:
      MeshFile(arguments, controller);
      break;
  }
  return 0;
}

int Run(const std::vector<std::string>& words, vtkMultiProcessController* controller)
{
  try
  {
    ControllerRanks ranks(controller);
    int status = 0;
    WorkInStage(
      ranks, ErrorCode::InternalError, [&] { status = Work(ParseArguments(words), controller); },
      Ranks::Frame::Program);
    return status;
  }
  catch (const InputError& error) // on all ranks
  {
    if (controller->GetLocalProcessId() == 0)
    {
      std::cerr << "sculptor: " << error.what() << "\n";
    }
    return StatusOf(error.Code());
  }
  catch (const std::exception& error)
  {
    std::cerr << "sculptor: internal error: " << error.what() << std::endl;
    if (controller->GetNumberOfProcesses() > 1)
    {
      MPI_Abort(MPI_COMM_WORLD, StatusOf(ErrorCode::InternalError)); // others may wait
    }
    return StatusOf(ErrorCode::InternalError);
  }
}

} // namespace
} // namespace vfm

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv, 0);
  vtkMultiProcessController::SetGlobalController(controller);
  const int status = vfm::Run(std::vector<std::string>(argv + 1, argv + argc), controller);
  std::cout.flush();
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return status;
}
