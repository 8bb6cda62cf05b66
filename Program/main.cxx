/**
 * sculptor: command-line tool that meshes volume fractions in a file, on any number of MPI ranks.
 */
#include "ArgumentOptions.h"
#include "Arguments.h"
#include "Base/ParseText.h"
#include "BuiltInTest.h"
#include "CheckFiles.h"
#include "ChooseArrays.h"
#include "Elements/MeshWithRuns.h"
#include "InputTrust.h"
#include "ListInput.h"
#include "MakeMesh.h"
#include "Meshes/Files/WriteTable.h"
#include "Meshes/Vtk/WriteGeometry.h"
#include "Meshes/WriteMesh.h"
#include "MpiTransport.h"
#include "PrintSummary.h"
#include "Process/EndBySignal.h"
#include "Process/StandardStreams.h"
#include "Ranks/PrintableText.h"
#include "Ranks/WorkTogether.h"
#include "ReadInput.h"
#include "Report/Fragments/FragmentTable.h"
#include "Report/MeshMaterials.h"
#include "Report/WriteReport.h"
#include "State/ArrayStems.h"
#include "State/ViewMesh.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <optional>

namespace vfm
{
namespace
{

/// Times of the stages, on the slowest rank. Collective.
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

std::string DescribeMaterials(const ChosenArrays& arrays)
{
  return (arrays.Labels.empty() ? JoinTexts(arrays.Fractions) : arrays.Labels) + " (" + arrays.How +
    ")";
}

void PrintHead(const Arguments& arguments, const Input& input, const ChosenArrays& arrays)
{
  std::cout << MakePrintable(arguments.Input + " -> " + arguments.Output) << "\n";
  if (input.Time)
  {
    std::cout << "time " << *input.Time << "\n";
  }
  std::cout << "materials from " << MakePrintable(DescribeMaterials(arrays)) << "\n\n";
}

/// Returns the arrays of the mesh that hold the densities. If arrays of several materials became
/// one array, its name is their common stem.
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
  FieldArrays table;
  WorkInStage(ranks, ErrorCode::UnreadableInput,
    [&] { table = MakeFragmentTable(mesh, FindDensities(mesh, arguments), ranks); });
  const auto write = [&] { WriteTable(table, arguments.Fragments, ranks); };
  PrefixErrors("Cannot write the table " + arguments.Fragments + ": ",
    [&] { WorkInStage(ranks, ErrorCode::UnwritableOutput, write); });
}

/// Returns the texts of the report.
/// @param warnings  warnings of the mesher
ReportHead DescribeRun(
  const Arguments& arguments, const ChosenArrays& arrays, const std::vector<std::string>& warnings)
{
  ReportHead head;
  head.Title = "Mesh quality: " + arguments.Output;
  head.Facts = { { "Input", arguments.Input }, { "Mesh", arguments.Output },
    { "Materials from", DescribeMaterials(arrays) } };
  if (!arguments.Materials.empty())
  {
    head.Facts.emplace_back("Materials meshed", JoinTexts(arguments.Materials));
  }
  head.Options = ListReportOptions(arguments.Mesher);
  if (!arrays.Warning.empty())
  {
    head.Warnings.push_back(arrays.Warning);
  }
  head.Warnings.insert(head.Warnings.end(), warnings.begin(), warnings.end());
  return head;
}

/// Makes the folder of surfaces on rank 0, unless it exists. Returns when it exists.
/// @pre Collective
void MakeSurfaceFolder(const Arguments& arguments, Ranks& ranks)
{
  std::error_code error;
  if (ranks.Rank() == 0 && !arguments.SurfaceFolder.empty())
  {
    std::filesystem::create_directory(arguments.SurfaceFolder, error);
  }
  if (error)
  {
    throw InputError(
      "Cannot make the folder " + arguments.SurfaceFolder + ": " + error.message() + ".");
  }
  ranks.Any(false); // waits for rank 0
}

/// Writes the mesh, and the table of fragments, the geometry, the surfaces and the report if
/// requested.
/// @param head  texts of the report
/// @pre Collective
void WriteFiles(const MesherResult& result, const MeshData& mesh, const ReportHead& head,
  const Arguments& arguments, Ranks& ranks)
{
  WorkInStage(ranks, ErrorCode::UnwritableOutput,
    [&] { WriteMesh(mesh, arguments.Output, ranks, arguments.Form); });
  if (!arguments.Fragments.empty())
  {
    WriteFragments(mesh, arguments, ranks);
  }
  if (!arguments.Geometry.empty())
  {
    const auto write = [&] { WriteGeometry(result.TheMesh, mesh.Time, arguments.Geometry, ranks); };
    PrefixErrors("Cannot write the geometry " + arguments.Geometry + ": ",
      [&] { WorkInStage(ranks, ErrorCode::UnwritableOutput, write); });
  }
  if (!arguments.Surfaces.empty())
  {
    WorkInStage(ranks, ErrorCode::UnwritableOutput, [&] { MakeSurfaceFolder(arguments, ranks); });
    WorkInStage(
      ranks, ErrorCode::UnwritableOutput, [&] { WriteMesh(mesh, arguments.Surfaces, ranks); });
  }
  if (!arguments.Report.empty())
  {
    WorkInStage(ranks, ErrorCode::UnwritableOutput,
      [&] { WriteReport(mesh, result.MaterialFields, head, arguments.Report, ranks); });
  }
}

/// Returns whether the mesh may leave out hexes (CellRuns), because its file is the only output and
/// can be written without them in memory.
bool MayLeaveHexes(const Arguments& arguments, const Ranks& ranks)
{
  const bool isOnly = arguments.Fragments.empty() && arguments.Geometry.empty() &&
    arguments.Surfaces.empty() && arguments.Report.empty() && !arguments.Bins;
  return isOnly && ranks.Count() == 1 && !arguments.Form.IsDual && TakesRuns(arguments.Output);
}

/// Groups the elements if requested, and adds the groups to the mesh.
/// @return  groups, which must outlive the mesh
/// @pre Collective
BinnedElements AddBins(const Arguments& arguments, Ranks& ranks, MeshData& mesh)
{
  BinnedElements bins;
  if (arguments.Bins)
  {
    WorkInStage(
      ranks, ErrorCode::RejectedMesh, [&] { bins = BinElements(mesh, *arguments.Bins, ranks); });
    mesh.ElementArrays.push_back({ BinIdName, ValueType::Int, 1, {}, bins.Ids.data() });
    ReplaceBins(bins.Fields, mesh.Fields);
  }
  return bins;
}

/// Returns the paths of files with particles beside the files of meshes.
std::vector<std::string> ListParticlesBeside(const Arguments& arguments)
{
  std::vector<std::string> paths;
  for (const std::string& mesh : { arguments.Output, arguments.Surfaces })
  {
    const std::string path = FindParticlesBeside(mesh);
    if (!path.empty())
    {
      paths.push_back(path);
    }
  }
  return paths;
}

/// Checks that all outputs can be written.
/// @pre Collective
void CheckOutputs(const Arguments& arguments, Ranks& ranks)
{
  WorkInStage(ranks, ErrorCode::UnwritableOutput,
    [&]
    {
      CheckFiles(arguments);
      const std::string& surfaces =
        arguments.SurfaceFolder.empty() ? arguments.Surfaces : arguments.SurfaceFolder;
      for (const std::string& path :
        { arguments.Output, arguments.Fragments, arguments.Geometry, surfaces, arguments.Report })
      {
        const std::string problem = path.empty() ? "" : FindFolderProblem(path);
        if (!problem.empty())
        {
          throw InputError(problem);
        }
      }
    });
}

/// Returns the arguments with Flat for a picture of one slice, unless an option says what Flat is.
Arguments CompleteArguments(const Arguments& given, const Input& input)
{
  Arguments arguments = given;
  arguments.Mesher.Flat = given.Mesher.Flat || (input.IsPicture && !given.SetsFlat);
  return arguments;
}

/// Returns the begin of messages of the mesher.
std::string DescribeTask(const Arguments& arguments)
{
  return "Cannot mesh " + arguments.Input +
    (arguments.Mesher.Flat && !arguments.SetsFlat
        ? " as a plane (--set Flat=off: as a layer of solid elements): "
        : ": ");
}

void MeshFile(const Arguments& given, Ranks& ranks)
{
  StageTimes times(ranks);
  CheckOutputs(given, ranks);
  const Input input = ReadInput(given, ranks);
  const Arguments arguments = CompleteArguments(given, input);
  const ChosenArrays arrays = ChooseArrays(input, arguments, ranks);
  if (ranks.Rank() == 0 && !arrays.Warning.empty())
  {
    std::cerr << "sculptor: warning: " << MakePrintable(arrays.Warning) << "\n";
  }
  times.Add("read");
  std::vector<std::string> warnings;
  MesherResult result;
  CellRuns leftOut;
  CellRuns* const runs = MayLeaveHexes(arguments, ranks) ? &leftOut : nullptr;
  PrefixErrors(DescribeTask(arguments),
    [&] { result = MakeMesh(arguments, input, arrays, ranks, &warnings, runs); });
  times.Add("mesh");
  MeshData mesh = ViewMesh(result.TheMesh, result.State, result.Fields);
  mesh.Time = input.Time;
  ParticleData particles;
  if (result.State.TheParticles)
  {
    particles = ViewParticles(*result.State.TheParticles);
    mesh.Particles = &particles;
  }
  const BinnedElements bins = AddBins(arguments, ranks, mesh);
  std::optional<MeshWithRuns> whole;
  if (leftOut.Runs.empty())
  {
    WriteFiles(result, mesh, DescribeRun(arguments, arrays, warnings), arguments, ranks);
  }
  else
  {
    whole.emplace(result.TheMesh, leftOut);
    WorkInStage(
      ranks, ErrorCode::UnwritableOutput, [&] { WriteMesh(mesh, *whole, arguments.Output); });
  }
  times.Add("write");
  if (!arguments.Quiet)
  {
    const MeshSummary summary = Summarise(mesh, ranks, whole ? &*whole : nullptr);
    if (ranks.Rank() == 0)
    {
      PrintHead(arguments, input, arrays);
      PrintSummary(summary, ListParticlesBeside(arguments), times.Get(), std::cout);
      PrintBins(bins.Bins, std::cout);
    }
  }
}

/// Returns the exit status of a failure: its code if that is 1 to 4, otherwise 5.
int StatusOf(ErrorCode code)
{
  const bool isListed = code >= ErrorCode::WrongArguments && code <= ErrorCode::UnwritableOutput;
  return static_cast<int>(isListed ? code : ErrorCode::InternalError);
}

/// Executes the command of the arguments and returns the exit status.
int Work(const Arguments& arguments, Ranks& ranks)
{
  const bool isFirst = ranks.Rank() == 0;
  const InputTrust trust(arguments.TrustsInput);
  switch (arguments.Task)
  {
    case Command::Help:
      std::cout << (isFirst ? GetHelp() : "");
      break;
    case Command::Version:
      std::cout << (isFirst ? "sculptor " VFM_VERSION "\n" : "");
      break;
    case Command::Test:
      return RunBuiltInTest(arguments, ranks) ? 0 : StatusOf(ErrorCode::RejectedMesh);
    case Command::List:
      ListInput(arguments, ranks, std::cout);
      break;
    case Command::Mesh:
      MeshFile(arguments, ranks);
      break;
  }
  return 0;
}

int Run(const std::vector<std::string>& words, Ranks& ranks)
{
  try
  {
    int status = 0;
    WorkInStage(
      ranks, ErrorCode::InternalError, [&] { status = Work(ParseArguments(words), ranks); },
      Ranks::Frame::Program);
    return status;
  }
  catch (const InputError& error) // all ranks throw it
  {
    if (ranks.Rank() == 0)
    {
      std::cerr << "sculptor: " << MakePrintable(error.what()) << "\n";
    }
    return StatusOf(error.Code());
  }
  catch (const std::exception& error)
  {
    std::cerr << "sculptor: internal error: " << MakePrintable(error.what()) << std::endl;
    if (ranks.Count() > 1)
    {
      // Other ranks may be waiting for a message.
      MPI_Abort(MPI_COMM_WORLD, StatusOf(ErrorCode::InternalError));
    }
    return StatusOf(ErrorCode::InternalError);
  }
}

} // namespace
} // namespace vfm

int main(int argc, char* argv[])
{
  vfm::OpenStandardStreams();
  vfm::HandleSignals();
  MPI_Init(&argc, &argv);
  vfm::MpiRanks ranks(MPI_COMM_WORLD);
  if (ranks.Rank() > 0)
  {
    vfm::HandleSignalsSilently();
  }
  const int status = vfm::Run(std::vector<std::string>(argv + 1, argv + argc), ranks);
  std::cout.flush();
  if (status != 0)
  {
    vfm::HandleSignalsSilently(); // mpiexec ends ranks that have not ended yet
  }
  MPI_Finalize();
  return status;
}
