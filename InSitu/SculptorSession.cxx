#include "SculptorSession.h"

#include "ArrayMemory.h"
#include "ControllerRanks.h"
#include "HostImages.h"
#include "MeshDataOfGrid.h"
#include "Meshes/WriteMesh.h"
#include "Options/SetOptions.h"
#include "Ranks/WorkTogether.h"
#include "Sculptor.h"
#include "Stage.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkDummyController.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeFractionToHex.h"
#include "vtkVolumeFractionToTet.h"

#include <cmath>
#include <utility>

namespace vfm
{
namespace
{

constexpr double LargestHash = 0x1p53; // what a double counts

/// Collective: throws on all ranks when their texts differ.
void AgreeOn(const std::string& text, Ranks& ranks)
{
  const double hash = std::fmod(static_cast<double>(std::hash<std::string>()(text)), LargestHash);
  if (ranks.Max(hash) != -ranks.Max(-hash))
  {
    throw InputError("The ranks do not agree on options, or on hexahedra or tetrahedra.");
  }
}

/// Of a failure to write.
int CodeOf(ExitCode code)
{
  switch (code)
  {
    case ExitCode::WrongArguments:
      return SCULPTOR_ERROR_ARGUMENT;
    case ExitCode::UnwritableOutput:
      return SCULPTOR_ERROR_FILE;
    default:
      return SCULPTOR_ERROR_INTERNAL;
  }
}

/// Does the work of this rank alone; errors tell the rank, where there are several.
template <class Work>
void NameRank(const Ranks& ranks, const Work& work)
{
  try
  {
    work();
  }
  catch (const InputError& error)
  {
    const std::string rank = "Rank " + std::to_string(ranks.Rank()) + ": ";
    throw InputError((ranks.Count() > 1 ? rank : "") + error.what(), error.Code());
  }
}

/// Makes errors that carry their SculptorCode to other ranks; code: of wrong input.
template <class Work>
void WorkWithCode(int code, const Work& work)
{
  try
  {
    work();
  }
  catch (const SculptorError& error)
  {
    throw InputError(error.what(), error.Code);
  }
  catch (const InputError& error)
  {
    throw InputError(error.what(), error.Code() ? error.Code() : code);
  }
}

/// Of an error of all ranks.
int CodeOf(const FailedTogether& error)
{
  if (error.Code() == Failure::OutOfMemory)
  {
    return SCULPTOR_ERROR_MEMORY;
  }
  return error.Code() ? error.Code() : SCULPTOR_ERROR_INTERNAL;
}

vtkDataArray* FindMeshArray(vtkFieldData* arrays, const std::string& name)
{
  vtkDataArray* array = arrays->GetArray(name.c_str());
  if (!array)
  {
    throw InputError("The mesh has no values named '" + name + "'.");
  }
  return array;
}

/// where: for the message.
vtkDoubleArray* FindState(vtkFieldData* arrays, const std::string& name, const std::string& where)
{
  auto* array = vtkDoubleArray::SafeDownCast(arrays->GetArray(name.c_str()));
  if (!array)
  {
    throw InputError("The mesh has no state" + where + " named '" + name + "'.");
  }
  return array;
}

template <class T>
const T* ValuesOf(vtkFieldData* arrays, const char* name)
{
  return static_cast<const T*>(FindMemory(FindMeshArray(arrays, name)));
}

} // namespace

SculptorSession::SculptorSession() = default;
SculptorSession::~SculptorSession() = default;

void SculptorSession::SetOption(const std::string& name, const std::string& value)
{
  if (name == "IndexBase")
  {
    if (value != "0" && value != "1")
    {
      throw InputError("IndexBase is '" + value + "'; it must be 0 or 1.");
    }
    this->IndexBase = value == "1" ? 1 : 0;
    return;
  }
  this->Tets->SetOption(name, value);
  if (!FindOption(name)->OnlyTets)
  {
    this->Hexes->SetOption(name, value);
  }
  this->Options[name] = value;
}

void SculptorSession::SetNeighbours(const int* ranks)
{
  this->Neighbours.reset();
  if (ranks)
  {
    this->Neighbours.emplace();
    std::copy_n(ranks, 6, this->Neighbours->begin());
  }
}

vtkVolumeFractionMeshAlgorithm* SculptorSession::GetMesher(bool tets) const
{
  return tets ? static_cast<vtkVolumeFractionMeshAlgorithm*>(this->Tets) : this->Hexes;
}

void SculptorSession::CheckNeighbours() const
{
  if (this->Neighbours && !this->Blocks.IsOneBox())
  {
    const std::string here = this->Blocks.Count() == 1
      ? "is one of a finer level"
      : "are " + std::to_string(this->Blocks.Count()) + " blocks";
    throw InputError("Face neighbours (sculptor_set_neighbours) are for one block of level 0 on "
                     "every rank; here " +
      here + ". Without neighbours (a null pointer) cells are shared out anew.");
  }
}

/// What all ranks must have alike, besides the names of fields.
std::string SculptorSession::Describe(bool tets) const
{
  std::string text = tets ? "tets" : "hexes";
  for (const auto& option : this->Options)
  {
    text += '\n' + option.first + '=' + option.second;
  }
  return text;
}

void SculptorSession::Configure(vtkVolumeFractionMeshAlgorithm* mesher, const FieldNames& names,
  vtkMultiProcessController* controller)
{
  mesher->SetController(controller);
  mesher->ClearVolumeFractionArrays();
  mesher->ClearStateArrays();
  mesher->SetMaterialIdArray(names.HasMaterialIds ? MaterialIdName : "");
  for (const FieldName& material : names.Materials)
  {
    mesher->AddVolumeFractionArray(material.Name.c_str());
  }
  for (const FieldName& state : names.States)
  {
    mesher->AddStateArray(state.Name.c_str());
  }
  if (this->Neighbours)
  {
    mesher->SetFaceNeighbours(this->Neighbours->data());
  }
  else
  {
    mesher->ClearFaceNeighbours();
  }
}

/// Keeps the outputs alone, not the host's arrays.
void SculptorSession::Run(vtkVolumeFractionMeshAlgorithm* mesher, const HostGrid& grid)
{
  VtkMessages messages;
  messages.Watch(mesher);
  mesher->SetInputDataObject(MakeBlocks(grid, 0, static_cast<unsigned int>(grid.Boxes.size())));
  const bool isDone = mesher->GetExecutive()->Update();
  mesher->SetInputDataObject(nullptr);
  vtkUnstructuredGrid* output = mesher->GetOutput();
  auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  mesh->ShallowCopy(output);
  this->Geometry.emplace(*mesher);
  for (int port = 0; port < mesher->GetNumberOfOutputPorts(); ++port)
  {
    mesher->GetOutputDataObject(port)->Initialize();
  }
  for (const std::string& warning : messages.GetWarnings())
  {
    this->WarningText += warning + "\n";
  }
  if (messages.HasErrors() || !isDone)
  {
    throw SculptorError(messages.TellsLackOfMemory() ? SCULPTOR_ERROR_MEMORY : SCULPTOR_ERROR_INPUT,
      messages.HasErrors() ? messages.GetErrorText() : "The mesh could not be made.");
  }
  this->Mesh = mesh;
}

void SculptorSession::MakeMesh(bool tets, const std::function<void()>& prepare)
{
  this->Mesh = nullptr;
  this->Parts.reset();
  this->Geometry.reset();
  this->WarningText.clear();
  HostWishes wishes = std::exchange(this->Wishes, {});
  vtkMultiProcessController* controller = this->Communicator.GetController();
  ControllerRanks ranks(controller);
  FieldNames names;
  const auto agree = [&]
  {
    NameRank(ranks,
      [&]
      {
        prepare();
        this->Blocks.Check();
        this->CheckNeighbours();
      });
    AgreeOn(this->Describe(tets), ranks);
    names = this->Blocks.AgreeOnNames(ranks);
  };
  const auto mesh = [&]
  {
    HostGrid grid = this->Blocks.Place(ranks);
    const bool areNamed = wishes.AddTo(grid, ranks);
    NameRank(ranks, [&grid] { CheckHostGrid(grid); });
    vtkVolumeFractionMeshAlgorithm* mesher = this->GetMesher(tets);
    this->Configure(mesher, names, controller);
    const NamedRefinement refinement(*mesher, areNamed);
    this->Run(mesher, grid);
  };
  const auto work = [&]
  {
    WorkWithCode(SCULPTOR_ERROR_ARGUMENT, agree);
    WorkWithCode(SCULPTOR_ERROR_INPUT, mesh);
  };
  try
  {
    WorkTogether(ranks, work, Ranks::Frame::Stage);
  }
  catch (const FailedTogether& error)
  {
    this->Mesh = nullptr; // this rank may have made its part
    throw SculptorError(CodeOf(error), error.what());
  }
}

vtkUnstructuredGrid* SculptorSession::GetMesh() const
{
  if (!this->Mesh)
  {
    throw SculptorError(SCULPTOR_ERROR_NO_MESH, "There is no mesh yet, or the last one failed.");
  }
  return this->Mesh;
}

const FragmentParts& SculptorSession::GetFragmentParts()
{
  vtkUnstructuredGrid* mesh = this->GetMesh();
  if (!this->Parts)
  {
    this->Parts.emplace(mesh);
  }
  return *this->Parts;
}

GeometryParts::Cells SculptorSession::GetGeometryCells(int dimension)
{
  vtkUnstructuredGrid* mesh = this->GetMesh();
  return this->Geometry->Get(dimension, mesh);
}

vtkIntArray* SculptorSession::GetGeometryTable(const std::string& name) const
{
  this->GetMesh();
  return this->Geometry->GetTable(name);
}

int SculptorSession::GetNumberOfFragments() const
{
  return static_cast<int>(this->GetNumber("NumberOfFragments", 0));
}

template <class T>
const T* SculptorSession::GetCellValues(const char* name) const
{
  return ValuesOf<T>(this->GetMesh()->GetCellData(), name);
}

template <class T>
const T* SculptorSession::GetPointValues(const char* name) const
{
  return ValuesOf<T>(this->GetMesh()->GetPointData(), name);
}

template const int* SculptorSession::GetCellValues<int>(const char*) const;
template const std::int64_t* SculptorSession::GetCellValues<std::int64_t>(const char*) const;
template const int* SculptorSession::GetPointValues<int>(const char*) const;
template const std::int64_t* SculptorSession::GetPointValues<std::int64_t>(const char*) const;

vtkDoubleArray* SculptorSession::GetState(const std::string& name) const
{
  return FindState(this->GetMesh()->GetCellData(), name, "");
}

vtkDoubleArray* SculptorSession::GetPointState(const std::string& name) const
{
  return FindState(this->GetMesh()->GetPointData(), name, " of nodes");
}

double SculptorSession::GetNumber(const std::string& name, int index) const
{
  vtkDataArray* values = FindMeshArray(this->GetMesh()->GetFieldData(), name);
  const vtkIdType count = values->GetNumberOfValues();
  if (index < 0 || index >= count)
  {
    throw InputError("'" + name + "' has " + std::to_string(count) +
      " values, counted from 0; asked for " + std::to_string(index) + ".");
  }
  const int components = values->GetNumberOfComponents();
  return values->GetComponent(index / components, index % components);
}

void SculptorSession::Write(const char* path)
{
  vtkUnstructuredGrid* mesh = this->GetMesh(); // all ranks have one, or none
  vtkMultiProcessController* controller = this->Communicator.GetController();
  vtkNew<vtkDummyController> alone;
  controller = controller ? controller : alone;
  ControllerRanks ranks(controller);
  try
  {
    WorkInStage(ranks, ExitCode::WrongArguments,
      [&]
      {
        if (!path)
        {
          throw InputError("path is a null pointer.");
        }
        const std::string problem = FindOutputProblem(path);
        if (!problem.empty())
        {
          throw InputError(problem);
        }
      });
    WorkInStage(
      ranks, ExitCode::UnwritableOutput, [&] { WriteMesh(MeshDataOf(mesh).Data, path, ranks); });
  }
  catch (const ProgramError& error)
  {
    throw SculptorError(CodeOf(error.Code), error.what());
  }
}

} // namespace vfm
