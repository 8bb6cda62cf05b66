#include "SculptorSession.h"

#include "Base/ThreadRuntime.h"
#include "HostInput.h"
#include "Labels/ReadLabelNames.h"
#include "Levels/NewCells.h"
#include "Meshes/WriteMesh.h"
#include "Options/SetOptions.h"
#include "Ranks/WorkTogether.h"
#include "Sculptor.h"
#include "State/ViewMesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vfm
{
namespace
{

constexpr double LargestHash = 0x1p53; // integers up to it are exact in a double

/// Throws on all ranks if their texts differ.
/// @pre Collective
void AgreeOn(const std::string& text, Ranks& ranks)
{
  const double hash = std::fmod(static_cast<double>(std::hash<std::string>()(text)), LargestHash);
  if (ranks.Max(hash) != -ranks.Max(-hash))
  {
    throw InputError("The ranks do not agree on options or on the type of elements. All ranks must "
                     "set the same options and request the same type.");
  }
}

/// Runs work(), which must not communicate. If there are several ranks, errors name this rank.
template <class Work>
void NameRank(const Ranks& ranks, const Work& work)
{
  PrefixErrors(ranks.Count() > 1 ? "Rank " + std::to_string(ranks.Rank()) + ": " : "", work);
}

///@{ Returns a value of a field. A field of texts is rejected.
template <class Value>
double NumberAt(const std::vector<Value>& values, const std::string& name, int index)
{
  if (index < 0 || index >= static_cast<Index>(values.size()))
  {
    throw InputError("'" + name + "' has " + std::to_string(values.size()) +
      " values, counted from 0; there is no value " + std::to_string(index) + ".");
  }
  return static_cast<double>(values[index]);
}

double NumberAt(const std::vector<std::string>&, const std::string& name, int)
{
  throw InputError("The mesh has no values named '" + name + "'.");
}
///@}

std::vector<std::string> NamesOf(const std::vector<FieldName>& fields)
{
  std::vector<std::string> names;
  for (const FieldName& field : fields)
  {
    names.push_back(field.Name);
  }
  return names;
}

/// Finds a state of type double.
/// @param where  part of the message
const TransferredArray& FindState(const TransferredArray* first, std::size_t count,
  const std::string& name, const std::string& where)
{
  const auto found = std::find_if(first, first + count,
    [&name](const TransferredArray& array)
    { return array.Name == name && array.Type == ValueType::Double; });
  if (found == first + count)
  {
    throw InputError("The mesh has no state" + where + " named '" + name + "'.");
  }
  return *found;
}

} // namespace

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
  this->Options.Elements = ElementKind::Tets; // tetrahedra accept all options
  vfm::SetOption(this->Options, name, value);
  if (this->Options.Flat)
  {
    this->Options.Flat = false;
    throw InputError("The option Flat is not available in this interface, which has hexahedra and "
                     "tetrahedra only.");
  }
  this->Texts[name] = value;
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

void SculptorSession::CheckNeighbours() const
{
  if (this->Neighbours && !this->Blocks.IsOneBox())
  {
    const std::string here = this->Blocks.Count() == 1
      ? "has one of a finer level"
      : "has " + std::to_string(this->Blocks.Count()) + " blocks";
    throw InputError("Face neighbours (sculptor_set_neighbours) require one block of level 0 on "
                     "every rank; this rank " +
      here + ". Pass a null pointer instead; cells are then redistributed.");
  }
}

/// Returns a text of the options and the type of elements, which must be equal on all ranks.
std::string SculptorSession::Describe(bool tets) const
{
  std::string text = tets ? "tets" : "hexes";
  for (const auto& option : this->Texts)
  {
    text += '\n' + option.first + '=' + option.second;
  }
  return text;
}

MesherResult SculptorSession::Run(
  bool tets, bool areCellsNamed, const FieldNames& names, const HostGrid& grid, Ranks& ranks)
{
  MesherOptions options = this->Options;
  options.Elements = tets ? ElementKind::Tets : ElementKind::Hexes;
  if (areCellsNamed)
  {
    RefineNamedCells(options);
  }
  MesherInput input;
  input.Arrays.Labels = names.HasMaterialIds ? MaterialIdName : "";
  input.Warn = [this](const std::string& text) { this->WarningText += text + "\n"; };
  input.Arrays.Fractions = NamesOf(names.Materials);
  if (names.HasMaterialIds)
  {
    input.Arrays.Names = ShareLabelNames(options.LabelNames, ranks, input.Warn);
  }
  CollectedBlocks collected = CollectHostBlocks(grid, ranks);
  input.Arrays.State =
    CompleteChoice(ChooseState(options, NamesOf(names.States)), ListsOf(collected.Blocks), ranks);
  // Cells that replace those of the input may need state of ranks that are not neighbours.
  const std::optional<std::array<int, 6>> neighbours =
    ReplacesCells(options) ? std::nullopt : this->Neighbours;
  input.Levels = FindLevels(std::move(collected), neighbours, ranks);
  input.StaysInPlace = this->Neighbours.has_value();
  ThreadRuntime runtime(ChooseThreads(options.NumberOfThreads, ranks.Count()), &ranks);
  return RunMesher(input, options, runtime);
}

void SculptorSession::MakeMesh(bool tets, const std::function<void()>& prepare)
{
  this->Result.reset();
  this->Cohesive.reset();
  this->Parts.reset();
  this->Tables.clear();
  this->WarningText.clear();
  HostRefinement requests = std::exchange(this->Requests, {});
  Ranks& ranks = this->Communicator.GetRanks();
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
    const bool areNamed = requests.AddTo(grid, ranks);
    NameRank(ranks, [&grid] { CheckHostGrid(grid); });
    this->Result = this->Run(tets, areNamed, names, grid, ranks);
  };
  try
  {
    WorkInStage(ranks, ErrorCode::RejectedMesh,
      [&]
      {
        ClassifyErrors(ErrorCode::WrongArguments, agree);
        mesh();
      });
  }
  catch (const InputError&)
  {
    this->Result.reset(); // this rank may have completed its mesh
    throw;
  }
}

const MesherResult& SculptorSession::GetResult() const
{
  if (!this->Result)
  {
    throw InputError(ErrorCode::NoMesh, "There is no mesh yet, or the last one failed.");
  }
  return *this->Result;
}

const CohesiveElements& SculptorSession::GetCohesive()
{
  if (!this->Cohesive)
  {
    this->Cohesive = JoinBlocks(this->GetResult().Cohesive);
  }
  return *this->Cohesive;
}

const FragmentParts& SculptorSession::GetFragmentParts()
{
  if (!this->Parts)
  {
    this->Parts.emplace(this->GetMesh());
  }
  return *this->Parts;
}

int SculptorSession::GetNumberOfFragments() const
{
  return static_cast<int>(this->GetResult().Report.NumberOfFragments);
}

const FieldArray& SculptorSession::GetGeometryTable(const std::string& name)
{
  const GeometryTables& tables = this->GetMesh().Tables;
  if (this->Tables.empty())
  {
    for (FieldArrays lists : { ListSurfaces(tables), ListCurves(tables), ListVertices(tables) })
    {
      std::move(lists.begin(), lists.end(), std::back_inserter(this->Tables));
    }
  }
  const FieldArray* table = FindField(this->Tables, name);
  if (!table || !std::holds_alternative<std::vector<int>>(table->Values))
  {
    throw InputError("There is no table of adjacency '" + name + "' with integers.");
  }
  return *table;
}

const TransferredArray& SculptorSession::GetState(const std::string& name) const
{
  const std::vector<TransferredArray>& states = this->GetResult().State.Arrays;
  return FindState(states.data(), states.size(), name, "");
}

const TransferredArray& SculptorSession::GetPointState(const std::string& name) const
{
  const std::optional<TransferredArray>& velocity = this->GetResult().State.NodalVelocity;
  return FindState(velocity ? &*velocity : nullptr, velocity ? 1 : 0, name, " of nodes");
}

const TransferredArray& SculptorSession::GetParticleState(const std::string& name) const
{
  const std::optional<Particles>& particles = this->GetResult().State.TheParticles;
  return FindState(particles ? particles->Arrays.data() : nullptr,
    particles ? particles->Arrays.size() : 0, name, " of particles");
}

ParticleData SculptorSession::GetParticles() const
{
  const std::optional<Particles>& particles = this->GetResult().State.TheParticles;
  return particles ? ViewParticles(*particles) : ParticleData();
}

double SculptorSession::GetNumber(const std::string& name, int index) const
{
  const FieldArray* field = FindField(this->GetResult().Fields, name);
  if (!field)
  {
    throw InputError("The mesh has no values named '" + name + "'.");
  }
  return std::visit(
    [&](const auto& values) { return NumberAt(values, name, index); }, field->Values);
}

void SculptorSession::Write(const char* path)
{
  const MesherResult& result = this->GetResult(); // exists on all ranks or on none
  Ranks& ranks = this->Communicator.GetRanks();
  WorkInStage(ranks, ErrorCode::WrongArguments,
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
  MeshData mesh = ViewMesh(result.TheMesh, result.State, result.Fields);
  const ParticleData particles = this->GetParticles();
  mesh.Particles = result.State.TheParticles ? &particles : nullptr;
  WorkInStage(ranks, ErrorCode::UnwritableOutput, [&] { WriteMesh(mesh, path, ranks); });
  const std::string beside = FindParticlesBeside(path);
  if (ranks.Any(particles.NumberOfParticles > 0) && !beside.empty())
  {
    this->WarningText +=
      "Files as " + std::string(path) + " hold no particles: they are in " + beside + ".\n";
  }
}

} // namespace vfm
