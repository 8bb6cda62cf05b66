#include "Meshes/Exodus/ExodusModel.h"

#include "Base/ParseText.h"
#include "Meshes/Particles/GatherParticles.h"
#include "Ranks/Agreement.h"
#include "Report/Gather/GatherMesh.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <set>

namespace vfm
{
namespace
{

constexpr std::size_t MaximumLetters = 255;   // limit of the Exodus library for names
constexpr double LargestArray = 4294967292.0; // bytes; limit of netCDF with 64-bit offsets
constexpr Index LargestPlainId = std::numeric_limits<std::int32_t>::max();

const ExodusVariable* FindByName(
  const std::vector<ExodusVariable>& variables, const std::string& name)
{
  const auto found = std::find_if(variables.begin(), variables.end(),
    [&name](const ExodusVariable& variable) { return variable.Name == name; });
  return found == variables.end() ? nullptr : &*found;
}

/// Appends the id to names that are too long or exist already. Readers (IOSS) ignore case.
template <class Items>
void NameItems(Items& items, std::size_t& longest)
{
  std::set<std::string> seen;
  for (auto& item : items)
  {
    if (item.Name.size() > MaximumLetters || seen.count(ToLower(item.Name)) > 0)
    {
      const std::string ending = "_" + std::to_string(item.Id);
      item.Name = item.Name.substr(0, MaximumLetters - ending.size()) + ending;
    }
    seen.insert(ToLower(item.Name));
    longest = std::max(longest, item.Name.size());
  }
}

/// Numbers the elements block by block, in the order of their ids, of a mesh that leaves no hexes
/// out.
void NumberInBlocks(ExodusModel& model)
{
  Index number = 0;
  model.Numbers.resize(model.Mesh.Data.NumberOfElements);
  for (const ExodusBlock& block : model.Blocks)
  {
    for (std::size_t e = 0; !block.HasParticles && e < block.Elements.size(); ++e)
    {
      model.Numbers[block.Elements[e]] = ++number;
    }
  }
}

/// Numbers the elements block by block, with the hexes that are left out.
void NumberWithRuns(ExodusModel& model)
{
  std::map<int, Index> next; // number before the next element of each material
  Index total = 0;
  for (const ExodusBlock& block : model.Blocks)
  {
    if (!block.Cohesive && !block.HasParticles)
    {
      next[block.Material] = total;
      total += block.Count();
    }
  }
  const MeshData& mesh = model.Mesh.Data;
  const auto number = [&](Index first, Index last)
  {
    for (Index e = first; e < last; ++e)
    {
      model.Numbers[e] = ++next[mesh.Material[e]];
    }
  };
  model.Numbers.resize(mesh.NumberOfElements);
  model.Whole->ForElements(
    number, [&next](const CellRuns::Run& run) { next[run.Material] += run.Count; });
}

void MakeBlocks(std::vector<ParticlePart> particles, ExodusModel& model)
{
  for (MaterialPart& part : model.Materials)
  {
    model.Blocks.push_back({ part.Id, part.Name, std::move(part.Elements), nullptr });
    ExodusBlock& block = model.Blocks.back();
    block.Material = part.Material;
    for (std::size_t r = 0; model.Whole && r < model.Whole->Cells().size(); ++r)
    {
      const CellRuns::Run& run = model.Whole->Cells()[r];
      block.LeftOut += run.Material == block.Material ? run.Count : 0;
    }
  }
  std::sort(model.Blocks.begin(), model.Blocks.end(),
    [](const ExodusBlock& a, const ExodusBlock& b) { return a.Id < b.Id; });
  for (const CohesiveBlock& block : model.Cohesive) // their ids are above all others
  {
    model.Blocks.push_back({ block.Id, block.Name, {}, &block });
  }
  for (ParticlePart& part : particles) // their ids are above those
  {
    model.Blocks.push_back({ part.Id, part.Name, std::move(part.Particles), nullptr, true });
  }
  model.Whole ? NumberWithRuns(model) : NumberInBlocks(model);
}

/// Adds the particles of this rank, their ids and nodes. Other parts of the model that depend on
/// points are made before, because particles on the boundary of the domain are in no set.
/// @pre Collective
std::vector<ParticlePart> AddParticles(
  const ParticleData* particles, ExodusModel& model, Ranks& ranks)
{
  model.Particles = OrderParticles(particles, ranks);
  if (!model.Particles)
  {
    model.Particles = std::make_shared<const ParticleData>();
    return {};
  }
  MeshData& mesh = model.Mesh.Data;
  mesh.Particles = model.Particles.get();
  const auto largest = [&ranks](const Index* ids, Index count)
  { return MaximumOverRanks(count > 0 ? *std::max_element(ids, ids + count) : 0, ranks); };
  Index lastElement = largest(mesh.ElementIds, mesh.NumberOfElements);
  for (const CohesiveBlock& block : model.Cohesive)
  {
    lastElement =
      std::max(lastElement, largest(block.Ids.data(), static_cast<Index>(block.Ids.size())));
  }
  std::vector<Index> nodeIds = NumberParticles(*model.Particles, ranks);
  const Index lastPoint = largest(mesh.PointIds, mesh.NumberOfPoints);
  for (Index& id : nodeIds)
  {
    model.ParticleIds.push_back(lastElement + 1 + id);
    id += lastPoint + 1;
  }
  StoredMesh extended = AddParticleNodes(mesh, nodeIds);
  std::vector<ParticlePart> parts = FindParticleParts(mesh, model.Cohesive, ranks);
  mesh = extended.Data;
  std::move(extended.Memory.begin(), extended.Memory.end(), std::back_inserter(model.Mesh.Memory));
  return parts;
}

/// Finds the totals over all ranks and the points that ranks share.
void CountAll(ExodusModel& model, Ranks& ranks)
{
  const MeshData& mesh = model.Mesh.Data;
  model.Sharing = FindSharedPoints({ mesh.PointIds, mesh.PointIds + mesh.NumberOfPoints }, ranks);
  const std::vector<char>& isOwned = model.Sharing.IsOwned;
  const Index leftOut = model.NumberOfPoints() - mesh.NumberOfPoints;
  std::vector<std::int64_t> counts{ std::count(isOwned.begin(), isOwned.end(), 1) + leftOut,
    model.NumberOfElements() };
  for (const ExodusBlock& block : model.Blocks)
  {
    counts.push_back(block.Count());
  }
  for (const SideSet& set : model.Sets.SideSets)
  {
    counts.push_back(static_cast<std::int64_t>(set.Sides.size()));
  }
  for (const NodeSet& set : model.Sets.NodeSets)
  {
    counts.push_back(std::count_if(set.Points.begin(), set.Points.end(),
      [&isOwned](Index point) { return isOwned[point] != 0; }));
  }
  ranks.Sum(counts);
  auto next = counts.begin();
  model.TotalNodes = *next++;
  model.TotalElements = *next++;
  for (ExodusBlock& block : model.Blocks)
  {
    block.Total = *next++;
  }
  model.SideTotals.assign(next, next + model.Sets.SideSets.size());
  next += model.Sets.SideSets.size();
  model.NodeTotals.assign(next, counts.end());
}

/// Lists the variables, which must be equal on all ranks, and shortens their names.
void ListArrays(ExodusModel& model, Ranks& ranks)
{
  const MeshData& mesh = model.Mesh.Data;
  model.PointVariables = ListVariables(mesh.PointArrays, mesh.PointIds);
  model.ElementVariables = ListVariables(mesh.ElementArrays, mesh.ElementIds);
  model.ParticleVariables = ListVariables(model.Particles->Arrays, nullptr);
  model.ParticleVariables.erase(
    std::remove_if(model.ParticleVariables.begin(), model.ParticleVariables.end(),
      [](const ExodusVariable& variable)
      {
        // IOSS ends if an attribute and a variable have the same name, in any case
        const std::string name = ToLower(variable.Name);
        return name == RadiusAttribute || name == VolumeAttribute;
      }),
    model.ParticleVariables.end());
  model.GlobalVariables = ListNumbers(mesh.Fields);
  std::string all;
  const auto take = [&](auto& variables)
  {
    for (auto& variable : variables)
    {
      variable.Name = variable.Name.substr(0, MaximumLetters);
      model.LongestName = std::max(model.LongestName, variable.Name.size());
      all += variable.Name + '\n';
    }
    all += '\n';
  };
  take(model.PointVariables);
  take(model.ElementVariables);
  take(model.ParticleVariables);
  take(model.GlobalVariables);
  if (UnionOverRanks(ranks, std::vector<std::size_t>{ std::hash<std::string>()(all) }).size() > 1)
  {
    throw InputError("The parts of the mesh have different arrays.");
  }
  const auto name = [](const ExodusVariable& variable) { return variable.Name; };
  std::vector<std::string>& names = model.ElementNames;
  std::transform(
    model.ElementVariables.begin(), model.ElementVariables.end(), std::back_inserter(names), name);
  std::transform(model.ParticleVariables.begin(), model.ParticleVariables.end(),
    std::back_inserter(names), name);
  names.erase(std::remove_if(names.begin() + model.ElementVariables.size(), names.end(),
                [&](const std::string& one) { return FindByName(model.ElementVariables, one); }),
    names.end());
}

void FindSizes(ExodusModel& model, Ranks& ranks)
{
  const MeshData& mesh = model.Mesh.Data;
  const auto isWide = [](const Index* ids, Index count)
  { return count > 0 && *std::max_element(ids, ids + count) > LargestPlainId; };
  bool hasWideIds =
    isWide(mesh.PointIds, mesh.NumberOfPoints) || isWide(mesh.ElementIds, mesh.NumberOfElements);
  for (const CohesiveBlock& block : model.Cohesive)
  {
    hasWideIds |= isWide(block.Ids.data(), static_cast<Index>(block.Ids.size()));
  }
  hasWideIds |= isWide(model.ParticleIds.data(), static_cast<Index>(model.ParticleIds.size()));
  if (model.Whole && !model.Whole->Nodes().empty()) // ids of hexes are smaller
  {
    const MeshWithRuns::NodeRun& last = model.Whole->Nodes().back();
    hasWideIds |=
      model.Whole->FirstId(last) + HexIds.PointSlots * (last.Count - 1) > LargestPlainId;
  }
  model.HasWideIds = ranks.Any(hasWideIds);
  const Index elements = model.Whole ? model.Whole->NumberOfElements() : mesh.NumberOfElements;
  const double largest = std::max(4.0 * mesh.NodesPerElement() * static_cast<double>(elements),
    8.0 * static_cast<double>(model.NumberOfPoints()));
  model.HasLargeArrays = ranks.Max(largest) > LargestArray;
}

} // namespace

const ExodusVariable* ExodusModel::VariableOf(const ExodusBlock& block, std::size_t name) const
{
  if (block.HasParticles)
  {
    return FindByName(this->ParticleVariables, this->ElementNames[name]);
  }
  return block.Cohesive || name >= this->ElementVariables.size() ? nullptr
                                                                 : &this->ElementVariables[name];
}

ExodusModel MakeExodusModel(const MeshData& mesh, Ranks& ranks, const MeshWithRuns* whole)
{
  ExodusModel model;
  model.Whole = whole;
  model.Mesh = OrderMesh(mesh, ranks);
  static_cast<MeshModel&>(model) = MakeMeshModel(model.Mesh.Data, ranks);
  if (!whole)
  {
    model.Materials = DivideByBins(model.Materials, model.Mesh.Data, ranks);
  }
  MakeBlocks(AddParticles(mesh.Particles, model, ranks), model);
  NameItems(model.Blocks, model.LongestName);
  NameItems(model.Sets.SideSets, model.LongestName);
  NameItems(model.Sets.NodeSets, model.LongestName);
  ListArrays(model, ranks);
  CountAll(model, ranks);
  FindSizes(model, ranks);
  return model;
}

} // namespace vfm
