#include "ExodusModel.h"

#include "Base/Runtime.h"
#include "MeshArrays.h"
#include "MeshDataOfGrid.h"
#include "OrderMesh.h"
#include "Ranks/Agreement.h"
#include "Summary/MeshMaterials.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <limits>
#include <map>
#include <set>

namespace vfm
{
namespace
{

constexpr std::size_t MostLetters = 255;      // of a name: what the library takes
constexpr double LargestArray = 4294967292.0; // bytes, of netCDF's format with 64-bit offsets
constexpr Index LargestPlainId = std::numeric_limits<std::int32_t>::max();

std::string ToLower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

/// A name that is longer than names may be, or there already, ends with its id. Readers (IOSS) do not tell capitals.
void SetNames(const std::vector<std::string*>& names, const std::vector<int>& ids)
{
  std::set<std::string> seen;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    std::string& name = *names[i];
    if (name.size() > MostLetters || seen.count(ToLower(name)) > 0)
    {
      const std::string ending = "_" + std::to_string(ids[i]);
      name = name.substr(0, MostLetters - ending.size()) + ending;
    }
    seen.insert(ToLower(name));
  }
}

template <class Items>
void NameItems(Items& items, std::size_t& longest)
{
  std::vector<std::string*> names;
  std::vector<int> ids;
  for (auto& item : items)
  {
    names.push_back(&item.Name);
    ids.push_back(item.Id);
  }
  SetNames(names, ids);
  for (const auto& item : items)
  {
    longest = std::max(longest, item.Name.size());
  }
}

void MakeBlocks(const MeshData& mesh, ExodusModel& model, Ranks& ranks)
{
  const std::vector<int> materials = FindMaterials(mesh, ranks);
  const int voidId = materials.front() == 0 ? FindVoidId(mesh, ranks) : 0;
  const std::map<int, std::string> names = NamesOfMaterials(mesh);
  std::map<int, std::size_t> places;
  for (int material : materials)
  {
    places[material] = model.Blocks.size();
    model.Blocks.push_back(
      { material == 0 ? voidId : material, NameOfMaterial(names, material), {} });
  }
  vtkDataArray* ids = model.Mesh->GetCellData()->GetArray("MaterialId");
  for (vtkIdType cell = 0; cell < model.Mesh->GetNumberOfCells(); ++cell)
  {
    model.Blocks[places[static_cast<int>(ids->GetComponent(cell, 0))]].Cells.push_back(cell);
  }
  std::sort(model.Blocks.begin(), model.Blocks.end(),
    [](const ExodusBlock& a, const ExodusBlock& b) { return a.Id < b.Id; });
  model.Elements.resize(model.Mesh->GetNumberOfCells());
  Index next = 0;
  for (const ExodusBlock& block : model.Blocks)
  {
    for (vtkIdType cell : block.Cells)
    {
      model.Elements[cell] = ++next;
    }
  }
}

/// What needs the other ranks: totals, points between ranks.
void CountAll(ExodusModel& model, Ranks& ranks)
{
  model.Sharing = FindSharedPoints({ model.PointIds->Begin(), model.PointIds->End() }, ranks);
  const std::vector<char>& isOwned = model.Sharing.IsOwned;
  std::vector<std::int64_t> counts{ std::count(isOwned.begin(), isOwned.end(), 1),
    model.Mesh->GetNumberOfCells() };
  for (const ExodusBlock& block : model.Blocks)
  {
    counts.push_back(static_cast<std::int64_t>(block.Cells.size()));
  }
  for (const SideSet& set : model.Sets.SideSets)
  {
    counts.push_back(static_cast<std::int64_t>(set.Sides.size()));
  }
  for (const NodeSet& set : model.Sets.NodeSets)
  {
    counts.push_back(std::count_if(set.Points.begin(), set.Points.end(),
      [&isOwned](vtkIdType point) { return isOwned[point] != 0; }));
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

/// The variables, the same on all ranks, with short names.
void ListArrays(ExodusModel& model, Ranks& ranks)
{
  model.PointVariables = ListVariables(model.Mesh->GetPointData());
  model.CellVariables = ListVariables(model.Mesh->GetCellData());
  model.Numbers = ListNumbers(model.Mesh->GetFieldData());
  std::string all;
  const auto take = [&](auto& variables)
  {
    for (auto& variable : variables)
    {
      variable.Name = variable.Name.substr(0, MostLetters);
      model.LongestName = std::max(model.LongestName, variable.Name.size());
      all += variable.Name + '\n';
    }
    all += '\n';
  };
  take(model.PointVariables);
  take(model.CellVariables);
  take(model.Numbers);
  if (Unite(ranks, std::vector<std::size_t>{ std::hash<std::string>()(all) }).size() > 1)
  {
    throw InputError("The parts of the mesh have different arrays.");
  }
}

} // namespace

ExodusModel MakeExodusModel(vtkUnstructuredGrid* mesh, Ranks& ranks)
{
  ExodusModel model;
  model.Mesh = OrderMesh(mesh, ranks);
  model.Time = model.Mesh->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP());
  model.PointIds = FindMeshIds(model.Mesh->GetPointData(), "GlobalPointIds");
  model.CellIds = FindMeshIds(model.Mesh->GetCellData(), "GlobalCellIds");
  const vtkIdType cells = model.Mesh->GetNumberOfCells();
  model.IsTets = ranks.Any(cells > 0 && model.Mesh->GetCellType(0) == VTK_TETRA);
  StoredMesh plain;
  WorkTogether(ranks, [&] { plain = MeshDataOf(model.Mesh); });
  model.Sets = FindMeshSets(plain.Data, ranks);
  MakeBlocks(plain.Data, model, ranks);
  NameItems(model.Blocks, model.LongestName);
  NameItems(model.Sets.SideSets, model.LongestName);
  NameItems(model.Sets.NodeSets, model.LongestName);
  ListArrays(model, ranks);
  CountAll(model, ranks);
  const auto isWide = [](vtkIdTypeArray* ids)
  {
    return ids->GetNumberOfValues() > 0 &&
      *std::max_element(ids->Begin(), ids->End()) > LargestPlainId;
  };
  model.HasWideIds = ranks.Any(isWide(model.PointIds) || isWide(model.CellIds));
  const double corners = model.IsTets ? 4.0 : 8.0;
  model.HasLargeArrays =
    ranks.Max(std::max(4.0 * corners * static_cast<double>(cells),
      8.0 * static_cast<double>(model.Mesh->GetNumberOfPoints()))) > LargestArray;
  return model;
}

} // namespace vfm
