#include "WriteExodus.h"

#include "Base/Runtime.h"
#include "ExodusFile.h"
#include "ExodusModel.h"
#include "OrderMesh.h"
#include "Ranks/Agreement.h"
#include "WriteNemesis.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkUnstructuredGrid.h"

#include "vtk_exodusII.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <limits>
#include <memory>

namespace vfm
{
namespace
{

/// Exodus' number of a face of a vtkHexahedron, of a vtkTetra.
constexpr Index HexSides[6] = { 4, 2, 1, 3, 5, 6 };
constexpr Index TetSides[4] = { 1, 2, 3, 4 };

constexpr std::size_t DefaultNameLength = 32;

Index Size(std::size_t size)
{
  return static_cast<Index>(size);
}

int FindMode(const ExodusModel& model)
{
  int mode = model.HasWideIds || model.HasLargeArrays ? EX_NETCDF4 : EX_64BIT_OFFSET;
  if (model.HasWideIds)
  {
    mode |= EX_MAPS_INT64_DB;
  }
  if (std::max(model.TotalNodes, model.TotalElements) > std::numeric_limits<int>::max())
  {
    mode |= EX_BULK_INT64_DB;
  }
  return mode;
}

std::string Describe(const ExodusModel& model)
{
  return std::to_string(model.TotalElements) + (model.IsTets ? " tetrahedra" : " hexahedra") +
    " and " + std::to_string(model.TotalNodes) +
    " nodes, materials: " + std::to_string(model.Blocks.size());
}

std::string Now(const char* format)
{
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char text[MAX_STR_LENGTH + 1];
  text[std::strftime(text, sizeof(text), format, &local)] = '\0';
  return text;
}

void WriteRecords(const ExodusModel& model, ExodusFile& file)
{
  std::array<std::string, 4> qa{ "VolumeFractionMesh", VFM_VERSION, Now("%Y/%m/%d"),
    Now("%H:%M:%S") };
  char* record[1][4] = { { &qa[0][0], &qa[1][0], &qa[2][0], &qa[3][0] } };
  file.Check(ex_put_qa(file.Id(), 1, record));
  std::string line = Describe(model);
  char* lines[1] = { &line[0] };
  file.Check(ex_put_info(file.Id(), 1, lines));
}

template <class Items>
std::vector<char*> GetNames(const Items& items)
{
  std::vector<char*> names;
  for (const auto& item : items)
  {
    names.push_back(const_cast<char*>(item.Name.c_str())); // the library reads only
  }
  return names;
}

/// All at once: the library does not find entities without items by their ids.
template <class Items>
void NameEntities(ex_entity_type type, const Items& items, ExodusFile& file)
{
  std::vector<char*> names = GetNames(items);
  if (!names.empty())
  {
    file.Check(ex_put_names(file.Id(), type, names.data()));
  }
}

/// What is where: sizes, ids, names. All that defines variables of the file comes before the bulk of the data.
void WriteHead(const ExodusModel& model, int count, ExodusFile& file)
{
  if (model.LongestName > DefaultNameLength)
  {
    file.Check(ex_set_max_name_length(file.Id(), static_cast<int>(model.LongestName)));
  }
  const std::string title = "VolumeFractionMesh: " + Describe(model);
  file.Check(ex_put_init(file.Id(), title.c_str(), 3, model.Mesh->GetNumberOfPoints(),
    model.Mesh->GetNumberOfCells(), Size(model.Blocks.size()), Size(model.Sets.NodeSets.size()),
    Size(model.Sets.SideSets.size())));
  if (count > 1)
  {
    WriteNemesisHead(model, count, file);
  }
  WriteRecords(model, file);
  for (const ExodusBlock& block : model.Blocks)
  {
    file.Check(ex_put_block(file.Id(), EX_ELEM_BLOCK, block.Id, model.IsTets ? "TETRA" : "HEX8",
      Size(block.Cells.size()), model.IsTets ? 4 : 8, 0, 0, 0));
  }
  for (const NodeSet& set : model.Sets.NodeSets)
  {
    file.Check(ex_put_set_param(file.Id(), EX_NODE_SET, set.Id, Size(set.Points.size()), 0));
  }
  for (const SideSet& set : model.Sets.SideSets)
  {
    file.Check(ex_put_set_param(file.Id(), EX_SIDE_SET, set.Id, Size(set.Sides.size()), 0));
  }
  NameEntities(EX_ELEM_BLOCK, model.Blocks, file);
  NameEntities(EX_NODE_SET, model.Sets.NodeSets, file);
  NameEntities(EX_SIDE_SET, model.Sets.SideSets, file);
}

template <class Variables>
void NameVariables(ex_entity_type type, const Variables& variables, ExodusFile& file)
{
  std::vector<char*> names = GetNames(variables);
  if (!names.empty())
  {
    const int count = static_cast<int>(names.size());
    file.Check(ex_put_variable_param(file.Id(), type, count));
    file.Check(ex_put_variable_names(file.Id(), type, count, names.data()));
  }
}

void DefineVariables(const ExodusModel& model, ExodusFile& file)
{
  NameVariables(EX_GLOBAL, model.Numbers, file);
  if (model.Mesh->GetNumberOfPoints() > 0) // the library defines none of no nodes
  {
    NameVariables(EX_NODAL, model.PointVariables, file);
  }
  NameVariables(EX_ELEM_BLOCK, model.CellVariables, file);
  if (!model.CellVariables.empty()) // all blocks have all
  {
    std::vector<int> table(model.Blocks.size() * model.CellVariables.size(), 1);
    file.Check(ex_put_truth_table(file.Id(), EX_ELEM_BLOCK, static_cast<int>(model.Blocks.size()),
      static_cast<int>(model.CellVariables.size()), table.data()));
  }
}

void WriteNodes(const ExodusModel& model, ExodusFile& file)
{
  file.Check(ex_put_id_map(file.Id(), EX_NODE_MAP, model.PointIds->GetPointer(0)));
  const vtkIdType count = model.Mesh->GetNumberOfPoints();
  std::vector<double> coordinates[3];
  for (vtkIdType point = 0; point < count; ++point)
  {
    const double* place = model.Mesh->GetPoint(point);
    for (int axis = 0; axis < 3; ++axis)
    {
      coordinates[axis].push_back(place[axis]);
    }
  }
  char x[] = "x", y[] = "y", z[] = "z";
  char* names[3] = { x, y, z };
  file.Check(ex_put_coord_names(file.Id(), names));
  if (count > 0)
  {
    file.Check(
      ex_put_coord(file.Id(), coordinates[0].data(), coordinates[1].data(), coordinates[2].data()));
  }
}

void WriteElements(const ExodusModel& model, ExodusFile& file)
{
  std::vector<Index> ids(model.Elements.size());
  for (std::size_t cell = 0; cell < model.Elements.size(); ++cell)
  {
    ids[model.Elements[cell] - 1] = model.CellIds->GetValue(static_cast<vtkIdType>(cell));
  }
  file.Check(ex_put_id_map(file.Id(), EX_ELEM_MAP, ids.data()));
  for (const ExodusBlock& block : model.Blocks)
  {
    std::vector<Index> connectivity;
    for (vtkIdType cell : block.Cells)
    {
      vtkIdType size = 0;
      const vtkIdType* points = nullptr;
      model.Mesh->GetCells()->GetCellAtId(cell, size, points);
      std::transform(points, points + size, std::back_inserter(connectivity),
        [](vtkIdType point) { return point + 1; });
    }
    if (!connectivity.empty())
    {
      file.Check(
        ex_put_conn(file.Id(), EX_ELEM_BLOCK, block.Id, connectivity.data(), nullptr, nullptr));
    }
  }
}

void WriteSets(const ExodusModel& model, ExodusFile& file)
{
  for (const NodeSet& set : model.Sets.NodeSets)
  {
    std::vector<Index> nodes;
    std::transform(set.Points.begin(), set.Points.end(), std::back_inserter(nodes),
      [](vtkIdType point) { return point + 1; });
    if (!nodes.empty())
    {
      file.Check(ex_put_set(file.Id(), EX_NODE_SET, set.Id, nodes.data(), nullptr));
    }
  }
  for (const SideSet& set : model.Sets.SideSets)
  {
    std::vector<Index> elements, sides;
    for (const MeshSide& side : set.Sides)
    {
      elements.push_back(model.Elements[side.Element]);
      sides.push_back(model.IsTets ? TetSides[side.Side] : HexSides[side.Side]);
    }
    if (!elements.empty())
    {
      file.Check(ex_put_set(file.Id(), EX_SIDE_SET, set.Id, elements.data(), sides.data()));
    }
  }
}

/// place: of the variable in its list.
void WriteCellVariable(const ExodusModel& model, std::size_t place, ExodusFile& file)
{
  const ExodusVariable& variable = model.CellVariables[place];
  for (const ExodusBlock& block : model.Blocks)
  {
    std::vector<double> values;
    for (vtkIdType cell : block.Cells)
    {
      values.push_back(variable.Array->GetComponent(cell, variable.Component));
    }
    if (!values.empty())
    {
      file.Check(ex_put_var(file.Id(), 1, EX_ELEM_BLOCK, static_cast<int>(place) + 1, block.Id,
        Size(values.size()), values.data()));
    }
  }
}

void WriteVariables(const ExodusModel& model, ExodusFile& file)
{
  file.Check(ex_put_time(file.Id(), 1, &model.Time));
  std::vector<double> values;
  for (const ExodusNumber& number : model.Numbers)
  {
    values.push_back(number.Value);
  }
  if (!values.empty())
  {
    file.Check(ex_put_var(file.Id(), 1, EX_GLOBAL, 1, 1, Size(values.size()), values.data()));
  }
  values.resize(model.Mesh->GetNumberOfPoints());
  for (std::size_t place = 0; place < model.PointVariables.size() && !values.empty(); ++place)
  {
    const ExodusVariable& variable = model.PointVariables[place];
    for (std::size_t point = 0; point < values.size(); ++point)
    {
      values[point] =
        variable.Array->GetComponent(static_cast<vtkIdType>(point), variable.Component);
    }
    file.Check(ex_put_var(
      file.Id(), 1, EX_NODAL, static_cast<int>(place) + 1, 1, Size(values.size()), values.data()));
  }
  for (std::size_t place = 0; place < model.CellVariables.size(); ++place)
  {
    WriteCellVariable(model, place, file);
  }
}

/// path.N.RANK, the rank as wide as N.
std::string PartPath(const std::string& path, const Ranks& ranks)
{
  if (ranks.Count() == 1)
  {
    return path;
  }
  const std::string count = std::to_string(ranks.Count()), rank = std::to_string(ranks.Rank());
  return path + "." + count + "." + std::string(count.size() - rank.size(), '0') + rank;
}

void FillPart(const ExodusModel& model, ExodusFile& file, const Ranks& ranks)
{
  WriteHead(model, ranks.Count(), file);
  DefineVariables(model, file);
  if (ranks.Count() > 1)
  {
    WriteNemesis(model, ranks.Rank(), file);
  }
  WriteNodes(model, file);
  WriteElements(model, file);
  WriteSets(model, file);
  WriteVariables(model, file);
  file.Close();
}

/// The message of a failure tells which of several files it is.
std::unique_ptr<ExodusFile> WritePart(
  const ExodusModel& model, const std::string& path, const Ranks& ranks)
{
  const std::string part = PartPath(path, ranks);
  try
  {
    auto file = std::make_unique<ExodusFile>(part, FindMode(model));
    FillPart(model, *file, ranks);
    return file;
  }
  catch (const InputError& error)
  {
    throw InputError((ranks.Count() > 1 ? part + ": " : "") + error.what());
  }
}

/// Collective: the files of all ranks, or none.
void WriteParts(vtkUnstructuredGrid* mesh, const std::string& path, Ranks& ranks)
{
  const ExodusModel model = MakeExodusModel(mesh, ranks);
  std::unique_ptr<ExodusFile> file;
  WorkTogether(ranks, [&] { file = WritePart(model, path, ranks); });
  file->Keep();
}

} // namespace

void WriteExodus(
  vtkUnstructuredGrid* mesh, const std::string& path, Ranks& ranks, ExodusParts parts)
{
  if (parts == ExodusParts::OneARank || ranks.Count() == 1)
  {
    WriteParts(mesh, path, ranks);
    return;
  }
  const auto whole = OrderWholeMesh(mesh, ranks);
  WorkTogether(ranks,
    [&]
    {
      if (whole)
      {
        Ranks alone;
        WriteParts(whole, path, alone);
      }
    });
}

} // namespace vfm
