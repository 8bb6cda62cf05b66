#include "DescribeGrid.h"

#include "HiddenCells.h"

namespace vfm
{
namespace
{

using conduit_cpp::Node;

constexpr const char* CoordinatesName = "coords";
constexpr const char* TopologyName = "mesh";

/// Adds a child of exactly this name, which is not taken as a path. Conduit shows names with
/// slashes in braces.
Node AddChild(Node& parent, const std::string& name)
{
  return conduit_cpp::cpp_node(conduit_node_add_child(conduit_cpp::c_node(&parent), name.c_str()));
}

template <class Value>
void SetComponent(const HostArray& array, int component, Index cells, Node& values)
{
  values.set_external(static_cast<const Value*>(array.Values), cells, component * sizeof(Value),
    array.Components * sizeof(Value));
}

void SetComponentOfType(const HostArray& array, int component, Index cells, Node& values)
{
  switch (array.Type)
  {
    case HostType::Float:
      return SetComponent<float>(array, component, cells, values);
    case HostType::Int:
      return SetComponent<int>(array, component, cells, values);
    case HostType::UnsignedChar:
      return SetComponent<unsigned char>(array, component, cells, values);
    default:
      return SetComponent<double>(array, component, cells, values);
  }
}

Node AddField(const std::string& name, Node& mesh)
{
  Node fields = mesh["fields"];
  Node field = AddChild(fields, name);
  field["association"].set_string("element");
  if (name.find('/') != std::string::npos)
  {
    field["display_name"].set_string(name); // used by VTK since 9.6
  }
  field["topology"].set_string(TopologyName);
  return field["values"];
}

void DescribeArray(const HostArray& array, Index cells, Node& mesh)
{
  Node values = AddField(array.Name, mesh);
  if (array.Components == 1)
  {
    SetComponentOfType(array, 0, cells, values);
    return;
  }
  for (int c = 0; c < array.Components; ++c)
  {
    Node component = values["c" + std::to_string(c)];
    SetComponentOfType(array, c, cells, component);
  }
}

/// Describes the cells of a box; a mesh without cells if the box has none.
void DescribeCells(const HostGrid& grid, const HostBox& box, Node& mesh)
{
  Node coordinates = mesh["coordsets"][CoordinatesName];
  Node topology = mesh["topologies"][TopologyName];
  coordinates["type"].set_string("uniform");
  topology["type"].set_string("uniform");
  topology["coordset"].set_string(CoordinatesName);
  const Vector3 spacing = SpacingOf(grid, box.Level);
  for (int a = 0; a < 3; ++a)
  {
    const std::string axis(1, "xyz"[a]), index(1, "ijk"[a]);
    const Index first = box.Cells.Lower[a], cells = box.Cells.Size(a);
    coordinates["dims"][index].set_int64(cells > 0 ? cells + 1 : 0);
    coordinates["origin"][axis].set_float64(
      grid.Origin[a] + static_cast<double>(first) * spacing[a]);
    coordinates["spacing"]["d" + axis].set_float64(spacing[a]);
    topology["elements/origin"][index + "0"].set_int64(first);
  }
}

void DescribeState(
  int level, std::size_t domain, const std::vector<HostNumber>& numbers, Node& state)
{
  state["domain_id"].set_int64(static_cast<std::int64_t>(domain));
  state["level"].set_int64(level);
  for (const HostNumber& number : numbers)
  {
    Node fields = state["fields"];
    AddChild(fields, number.Name).set_float64(number.Value);
  }
}

void DescribeFields(const HostBox& box, const HostPlaces& places, Node& mesh)
{
  const std::vector<unsigned char> types = HideCovered(box, places);
  for (const HostArray& array : box.Arrays)
  {
    if (types.empty() || array.Name != GhostTypeName)
    {
      DescribeArray(array, box.Cells.NumberOfCells(), mesh);
    }
  }
  if (!types.empty())
  {
    AddField(GhostTypeName, mesh).set_uint8_vector(types);
  }
}

} // namespace

void DescribeGrid(
  const HostGrid& grid, const std::vector<HostNumber>& numbers, Ranks& ranks, Node& meshes)
{
  CheckHostGrid(grid);
  const HostPlaces places = GatherHostPlaces(grid, ranks);
  if (places.Most == 0)
  {
    throw InputError("The grid has no boxes on any rank.");
  }
  for (std::size_t b = 0; b < places.Most; ++b)
  {
    const bool isOwn = b < grid.Boxes.size();
    const HostBox box = isOwn ? grid.Boxes[b] : HostBox();
    const std::size_t domain = isOwn ? places.First + b : places.All.size() + ranks.Rank();
    Node mesh = meshes["box" + std::to_string(b)], state = mesh["state"];
    DescribeState(box.Level, domain, numbers, state);
    DescribeCells(grid, box, mesh);
    DescribeFields(box, places, mesh);
  }
}

} // namespace vfm
