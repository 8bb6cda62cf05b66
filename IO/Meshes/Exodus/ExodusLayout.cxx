#include "Meshes/Exodus/ExodusLayout.h"
#include "Meshes/Files/ElementNodes.h"

#include "Meshes/Exodus/ExodusRuns.h"
#include "Meshes/Exodus/NemesisLayout.h"
#include "Report/DomainSides.h"
#include "Report/FlatData.h"

#include <algorithm>
#include <ctime>
#include <limits>

namespace vfm
{
namespace
{

// Numbers of the faces in Exodus, indexed by the numbers in VTK.
constexpr Index HexSides[6] = { 4, 2, 1, 3, 5, 6 };
constexpr Index TetSides[4] = { 1, 2, 3, 4 }; // also of quads and triangles

constexpr std::size_t NameLength = 256, QaLength = 33, LineLength = 81; // final zero included
constexpr std::size_t LeastLongestName = 32;
constexpr float LibraryVersion = 8.11f, NemesisVersion = 2.6f; // versions of the described files
constexpr int WideMaps = 0x0400, WideNumbers = 0x1000;         // bits of int64_status

/// Dimensions that several variables have.
struct Sizes
{
  std::size_t Name, Time, Axes, Nodes, Elements, Blocks, NodeSets, SideSets;
};

Index Size(std::size_t size)
{
  return static_cast<Index>(size);
}

bool HasWideNumbers(const ExodusModel& model)
{
  return std::max(model.TotalNodes, model.TotalElements) > std::numeric_limits<int>::max();
}

std::string Describe(const ExodusModel& model)
{
  Index particles = 0, blocks = 0;
  for (const ExodusBlock& block : model.Blocks)
  {
    particles += block.HasParticles ? block.Total : 0;
    blocks += block.HasParticles ? 0 : 1;
  }
  return std::to_string(model.TotalElements - particles) + " " + ShapeOf(model.Mesh.Data).Plural +
    " and " + std::to_string(model.TotalNodes) + " nodes, materials: " + std::to_string(blocks) +
    (particles > 0 ? ", particles: " + std::to_string(particles) : "");
}

std::string Now(const char* format)
{
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char text[QaLength];
  text[std::strftime(text, sizeof(text), format, &local)] = '\0';
  return text;
}

/// Returns a function that joins texts, each filled with zeros to the same length.
std::function<NetcdfValues()> Texts(std::vector<std::string> texts, std::size_t length)
{
  return [texts = std::move(texts), length]
  {
    std::string all;
    for (const std::string& text : texts)
    {
      all += text.substr(0, length - 1);
      all.resize((all.size() / length + 1) * length, '\0');
    }
    return all;
  };
}

template <class Items, class Get>
auto Collect(const Items& items, const Get& get)
{
  std::vector<std::decay_t<decltype(get(*items.begin()))>> values;
  values.reserve(items.size());
  std::transform(items.begin(), items.end(), std::back_inserter(values), get);
  return values;
}

template <class Items>
std::vector<std::string> NamesOf(const Items& items)
{
  return Collect(items, [](const auto& item) { return item.Name; });
}

void AddNames(NetcdfLayout& layout, const std::string& name, std::size_t count, std::size_t length,
  std::vector<std::string> names)
{
  AddVariable(layout, name, NetcdfKind::Text, { count, length },
    Texts(std::move(names), NameLength), { { "_FillValue", std::string(1, '\0') } });
}

void AddHead(NetcdfLayout& layout, const ExodusModel& model)
{
  const int wide = (model.HasWideIds ? WideMaps : 0) | (HasWideNumbers(model) ? WideNumbers : 0);
  layout.Attributes = { { "api_version", LibraryVersion }, { "version", LibraryVersion },
    { "floating_point_word_size", 8 }, { "file_size", 1 },
    { "maximum_name_length", static_cast<int>(std::max(model.LongestName, LeastLongestName)) },
    { "int64_status", wide }, { "title", "VolumeFractionMesh: " + Describe(model) } };
}

Sizes AddSizes(NetcdfLayout& layout, const ExodusModel& model)
{
  const auto add = [&layout](const char* name, std::size_t length)
  { return AddDimension(layout, name, Size(length)); };
  Sizes sizes{};
  sizes.Name = add("len_name", NameLength);
  layout.Dimensions.push_back({ "time_step", 0 });
  sizes.Time = sizes.Name + 1;
  sizes.Axes = add("num_dim", NumberOfAxes(model.Mesh.Data));
  sizes.Nodes = add("num_nodes", model.NumberOfPoints());
  sizes.Elements = add("num_elem", model.NumberOfElements());
  sizes.Blocks = add("num_el_blk", model.Blocks.size());
  sizes.NodeSets = add("num_node_sets", model.Sets.NodeSets.size());
  sizes.SideSets = add("num_side_sets", model.Sets.SideSets.size());
  return sizes;
}

/// Adds ids and status of blocks or sets; the status is 1 if this part has items of them.
/// @param getCount  function that returns the number of items of a block or set
template <class Entities, class GetCount>
void AddIds(NetcdfLayout& layout, const std::string& prefix, std::size_t dimension,
  const Entities& entities, const GetCount& getCount)
{
  AddVariable(layout, prefix + "_status", NetcdfKind::Int, { dimension },
    [values = Collect(
       entities, [&](const auto& entity) { return static_cast<Index>(getCount(entity) > 0); })]
    { return values; });
  AddVariable(layout, prefix + "_prop1", NetcdfKind::Int, { dimension },
    [&entities]
    { return Collect(entities, [](const auto& entity) { return static_cast<Index>(entity.Id); }); },
    { { "name", "ID" } });
}

void AddNodes(NetcdfLayout& layout, const ExodusModel& model, const Sizes& sizes)
{
  const MeshData& mesh = model.Mesh.Data;
  for (int axis = 0; axis < NumberOfAxes(mesh); ++axis)
  {
    AddVariable(
      layout, std::string("coord") + "xyz" [axis], NetcdfKind::Real, { sizes.Nodes },
      [&mesh, axis]
      {
        std::vector<double> values(mesh.NumberOfPoints);
        for (Index point = 0; point < mesh.NumberOfPoints; ++point)
        {
          values[point] = mesh.Point(point)[axis];
        }
        return values;
      },
      {}, PartsOfCoordinates(model.Whole, axis));
  }
}

void AddEntities(NetcdfLayout& layout, const ExodusModel& model, const Sizes& sizes)
{
  AddVariable(layout, "time_whole", NetcdfKind::Real, { sizes.Time },
    [&model] { return std::vector<double>{ model.Mesh.Data.Time.value_or(0.0) }; });
  AddIds(layout, "eb", sizes.Blocks, model.Blocks,
    [](const ExodusBlock& block) { return block.Count(); });
  AddIds(layout, "ns", sizes.NodeSets, model.Sets.NodeSets,
    [](const NodeSet& set) { return set.Points.size(); });
  AddIds(layout, "ss", sizes.SideSets, model.Sets.SideSets,
    [](const SideSet& set) { return set.Sides.size(); });
  AddNodes(layout, model, sizes);
  AddNames(layout, "eb_names", sizes.Blocks, sizes.Name, NamesOf(model.Blocks));
  AddNames(layout, "ns_names", sizes.NodeSets, sizes.Name, NamesOf(model.Sets.NodeSets));
  AddNames(layout, "ss_names", sizes.SideSets, sizes.Name, NamesOf(model.Sets.SideSets));
  std::vector<std::string> axes{ "x", "y", "z" };
  axes.resize(NumberOfAxes(model.Mesh.Data));
  AddNames(layout, "coor_names", sizes.Axes, sizes.Name, axes);
}

void AddRecords(NetcdfLayout& layout, const ExodusModel& model)
{
  const std::size_t records = AddDimension(layout, "num_qa_rec", 1);
  const std::size_t four = AddDimension(layout, "four", 4);
  const std::size_t length = AddDimension(layout, "len_string", QaLength);
  const std::size_t lines = AddDimension(layout, "num_info", 1);
  const std::size_t lineLength = AddDimension(layout, "len_line", LineLength);
  AddVariable(layout, "qa_records", NetcdfKind::Text, { records, four, length },
    Texts({ "VolumeFractionMesh", VFM_VERSION, Now("%Y/%m/%d"), Now("%H:%M:%S") }, QaLength));
  AddVariable(layout, "info_records", NetcdfKind::Text, { lines, lineLength },
    Texts({ Describe(model) }, LineLength));
}

const char* TypeOfElements(const MeshData& mesh)
{
  if (IsFlat(mesh))
  {
    return mesh.Corners == 4 ? "QUAD4" : "TRI3";
  }
  if (mesh.Corners == 4)
  {
    return mesh.MidsPerElement > 0 ? "TETRA10" : "TETRA";
  }
  return mesh.MidsPerElement == 0 ? "HEX8" : mesh.MidsPerElement == 12 ? "HEX20" : "HEX27";
}

std::vector<Index> NodesOf(const MeshData& mesh, const ExodusBlock& block)
{
  if (block.Cohesive)
  {
    return Collect(block.Cohesive->Points, [](Index point) { return point + 1; });
  }
  if (block.HasParticles)
  {
    const Index first = mesh.NumberOfPoints - mesh.Particles->NumberOfParticles + 1;
    return Collect(block.Elements, [first](Index particle) { return first + particle; });
  }
  // Edges along z before the upper ones; the centre before the faces.
  const MidOrders orders{ { 0, 1, 2, 3, 8, 9, 10, 11, 4, 5, 6, 7 },
    { 0, 1, 2, 3, 8, 9, 10, 11, 4, 5, 6, 7, 18, 16, 17, 12, 13, 14, 15 }, {} };
  ElementNodes nodes(mesh, orders);
  std::vector<Index> all;
  all.reserve(nodes.Count() * block.Elements.size());
  for (Index element : block.Elements)
  {
    const Index* points = nodes.Of(element);
    std::transform(points, points + nodes.Count(), std::back_inserter(all),
      [](Index point) { return point + 1; });
  }
  return all;
}

/// Returns the type of elements and their number of nodes.
std::pair<const char*, int> TypeOf(const MeshData& mesh, const ExodusBlock& block)
{
  if (block.Cohesive)
  {
    const int corners = CohesiveCorners(mesh);
    return { corners == 8 ? "HEX8" : "WEDGE", corners };
  }
  if (block.HasParticles)
  {
    return { "SPHERE", 1 };
  }
  return { TypeOfElements(mesh), mesh.NodesPerElement() };
}

/// Adds the attributes of a block of particles: radius, then volume, the order of SEACAS (sphgen3d,
/// IOSS).
/// @param number  of the block, from 1
void AddAttributes(NetcdfLayout& layout, const ExodusModel& model, const ExodusBlock& block,
  const std::string& number, std::size_t elements)
{
  const std::size_t name =
    static_cast<std::size_t>(std::find_if(layout.Dimensions.begin(), layout.Dimensions.end(),
                               [](const NetcdfDimension& one) { return one.Name == "len_name"; }) -
      layout.Dimensions.begin());
  const std::size_t count =
    AddDimension(layout, "num_att_in_blk" + number, block.Count() == 0 ? 0 : 2);
  AddVariable(layout, "attrib" + number, NetcdfKind::Real, { elements, count },
    [&model, &block]
    {
      std::vector<double> values;
      for (Index particle : block.Elements)
      {
        values.push_back(model.Particles->Radius[particle]);
        values.push_back(model.Particles->Volume[particle]);
      }
      return values;
    });
  AddNames(layout, "attrib_name" + number, count, name, { RadiusAttribute, VolumeAttribute });
}

/// Adds the element blocks and returns the dimension of each.
std::vector<std::size_t> AddBlocks(NetcdfLayout& layout, const ExodusModel& model)
{
  const MeshData& mesh = model.Mesh.Data;
  std::vector<std::size_t> dimensions;
  for (const ExodusBlock& block : model.Blocks)
  {
    const std::string number = std::to_string(dimensions.size() + 1);
    const auto [type, count] = TypeOf(mesh, block);
    dimensions.push_back(AddDimension(layout, "num_el_in_blk" + number, block.Count()));
    const std::size_t nodes =
      AddDimension(layout, "num_nod_per_el" + number, block.Count() == 0 ? 0 : count);
    AddVariable(
      layout, "connect" + number, KindOfNumbers(model), { dimensions.back(), nodes },
      [&mesh, &block] { return NodesOf(mesh, block); }, { { "elem_type", type } },
      PartsOfNodes(model.Whole, block.Material));
    if (block.HasParticles)
    {
      AddAttributes(layout, model, block, number, dimensions.back());
    }
  }
  return dimensions;
}

void AddSets(NetcdfLayout& layout, const ExodusModel& model)
{
  const NetcdfKind kind = KindOfNumbers(model);
  int count = 0;
  for (const NodeSet& set : model.Sets.NodeSets)
  {
    const std::string number = std::to_string(++count);
    const std::size_t nodes = AddDimension(layout, "num_nod_ns" + number, Size(set.Points.size()));
    AddVariable(layout, "node_ns" + number, kind, { nodes },
      [&set, &model] {
        return Collect(set.Points, [&model](Index point) { return model.NumberOfPoint(point); });
      });
  }
  count = 0;
  for (const SideSet& set : model.Sets.SideSets)
  {
    const std::string number = std::to_string(++count);
    const std::size_t sides = AddDimension(layout, "num_side_ss" + number, Size(set.Sides.size()));
    AddVariable(layout, "elem_ss" + number, kind, { sides },
      [&set, &model]
      {
        return Collect(
          set.Sides, [&](const ElementSide& side) { return model.Numbers[side.Element]; });
      });
    const Index* sideNumbers = model.Mesh.Data.HasHexes() ? HexSides : TetSides;
    AddVariable(layout, "side_ss" + number, kind, { sides },
      [&set, sideNumbers] {
        return Collect(set.Sides, [&](const ElementSide& side) { return sideNumbers[side.Side]; });
      });
  }
}

void AddGlobalVariables(NetcdfLayout& layout, const ExodusModel& model, const Sizes& sizes)
{
  const std::size_t count = AddDimension(layout, "num_glo_var", Size(model.GlobalVariables.size()));
  AddNames(layout, "name_glo_var", count, sizes.Name, NamesOf(model.GlobalVariables));
  AddVariable(layout, "vals_glo_var", NetcdfKind::Real, { sizes.Time, count },
    [&model]
    {
      return Collect(
        model.GlobalVariables, [](const ExodusNumber& number) { return number.Value; });
    });
}

/// Adds the variables of nodes, unless the file has no nodes.
void AddPointVariables(NetcdfLayout& layout, const ExodusModel& model, const Sizes& sizes)
{
  const Index points = model.Mesh.Data.NumberOfPoints;
  const std::size_t count =
    AddDimension(layout, "num_nod_var", points > 0 ? Size(model.PointVariables.size()) : 0);
  AddNames(layout, "name_nod_var", count, sizes.Name, NamesOf(model.PointVariables));
  int number = 0;
  for (const ExodusVariable& variable : model.PointVariables)
  {
    AddVariable(
      layout, "vals_nod_var" + std::to_string(++number), NetcdfKind::Real,
      { sizes.Time, sizes.Nodes },
      [&variable, points]
      {
        std::vector<double> values(points);
        for (Index point = 0; point < points; ++point)
        {
          values[point] = ValueAt(*variable.Array, point, variable.Component);
        }
        return values;
      },
      {}, PartsOfPointArray(model.Whole, *variable.Array));
  }
}

/// Adds the variables of elements: each block of a material has those of elements, each block of
/// particles those of particles.
void AddElementVariables(NetcdfLayout& layout, const ExodusModel& model, const Sizes& sizes,
  const std::vector<std::size_t>& blocks)
{
  const std::size_t count = AddDimension(layout, "num_elem_var", Size(model.ElementNames.size()));
  AddNames(layout, "name_elem_var", count, sizes.Name, model.ElementNames);
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    const ExodusBlock& block = model.Blocks[b];
    for (std::size_t name = 0; name < model.ElementNames.size(); ++name)
    {
      const ExodusVariable* variable = model.VariableOf(block, name);
      if (!variable)
      {
        continue;
      }
      AddVariable(
        layout, "vals_elem_var" + std::to_string(name + 1) + "eb" + std::to_string(b + 1),
        NetcdfKind::Real, { sizes.Time, blocks[b] },
        [&block, variable]
        {
          return Collect(block.Elements,
            [variable](Index element)
            { return ValueAt(*variable->Array, element, variable->Component); });
        },
        {}, PartsOfElementArray(model.Whole, *variable->Array, block.Material));
    }
  }
  AddVariable(layout, "elem_var_tab", NetcdfKind::Int, { sizes.Blocks, count },
    [&model]
    {
      std::vector<Index> table; // whether a block has a variable
      for (const ExodusBlock& block : model.Blocks)
      {
        for (std::size_t name = 0; name < model.ElementNames.size(); ++name)
        {
          table.push_back(model.VariableOf(block, name) ? 1 : 0);
        }
      }
      return table;
    });
}

void AddMaps(NetcdfLayout& layout, const ExodusModel& model, const Sizes& sizes)
{
  const NetcdfKind kind = model.HasWideIds ? NetcdfKind::WideInt : NetcdfKind::Int;
  const MeshData& mesh = model.Mesh.Data;
  AddVariable(
    layout, "node_num_map", kind, { sizes.Nodes },
    [&mesh] { return std::vector<Index>(mesh.PointIds, mesh.PointIds + mesh.NumberOfPoints); }, {},
    PartsOfPointIds(model.Whole, mesh));
  AddVariable(
    layout, "elem_num_map", kind, { sizes.Elements },
    [&mesh, &model]
    {
      std::vector<Index> ids(mesh.NumberOfElements);
      for (Index element = 0; element < mesh.NumberOfElements; ++element)
      {
        ids[model.Numbers[element] - 1] = mesh.ElementIds[element];
      }
      for (const CohesiveBlock& block : model.Cohesive)
      {
        ids.insert(ids.end(), block.Ids.begin(), block.Ids.end());
      }
      for (const ExodusBlock& block : model.Blocks)
      {
        for (std::size_t e = 0; block.HasParticles && e < block.Elements.size(); ++e)
        {
          ids.push_back(model.ParticleIds[block.Elements[e]]);
        }
      }
      return ids;
    },
    {},
    PartsOfElementIds(model.Whole, mesh,
      Collect(model.Blocks, [](const ExodusBlock& block) { return block.Material; })));
}

} // namespace

std::size_t AddDimension(NetcdfLayout& layout, const std::string& name, Index length)
{
  return length > 0 ? layout.AddDimension(name, length) : NoDimension;
}

void AddVariable(NetcdfLayout& layout, const std::string& name, NetcdfKind kind,
  std::vector<std::size_t> dimensions, std::function<NetcdfValues()> values,
  std::vector<NetcdfText> attributes, NetcdfParts parts)
{
  if (std::find(dimensions.begin(), dimensions.end(), NoDimension) == dimensions.end())
  {
    layout.Variables.push_back({ name, kind, std::move(dimensions), std::move(values),
      std::move(attributes), std::move(parts) });
  }
}

NetcdfKind KindOfNumbers(const ExodusModel& model)
{
  return HasWideNumbers(model) ? NetcdfKind::WideInt : NetcdfKind::Int;
}

NetcdfLayout MakeExodusLayout(const ExodusModel& model, int ranks)
{
  NetcdfLayout layout;
  AddHead(layout, model);
  const Sizes sizes = AddSizes(layout, model);
  AddEntities(layout, model, sizes);
  if (ranks > 1)
  {
    layout.Attributes.emplace_back("nemesis_file_version", NemesisVersion);
    layout.Attributes.emplace_back("nemesis_api_version", LibraryVersion);
    AddNemesisHead(layout, model, ranks);
  }
  AddRecords(layout, model);
  const std::vector<std::size_t> blocks = AddBlocks(layout, model);
  AddSets(layout, model);
  AddGlobalVariables(layout, model, sizes);
  AddPointVariables(layout, model, sizes);
  AddElementVariables(layout, model, sizes, blocks);
  if (ranks > 1)
  {
    AddNemesis(layout, model);
  }
  AddMaps(layout, model, sizes);
  return layout;
}

} // namespace vfm
