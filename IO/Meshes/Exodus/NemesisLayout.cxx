#include "Meshes/Exodus/NemesisLayout.h"

#include "Meshes/Exodus/ExodusLayout.h"

#include <algorithm>
#include <numeric>

namespace vfm
{
namespace
{

using Numbers = std::vector<Index>;

void AddNumbers(NetcdfLayout& layout, const std::string& name, NetcdfKind kind,
  std::size_t dimension, Numbers numbers)
{
  AddVariable(layout, name, kind, { dimension },
    [numbers = std::move(numbers)]() -> NetcdfValues { return numbers; });
}

/// Returns the places, from 1, whose flag equals isSet.
Numbers Choose(const std::vector<char>& flags, bool isSet)
{
  Numbers chosen;
  for (std::size_t i = 0; i < flags.size(); ++i)
  {
    if ((flags[i] != 0) == isSet)
    {
      chosen.push_back(static_cast<Index>(i) + 1);
    }
  }
  return chosen;
}

std::vector<char> FindBorderNodes(const ExodusModel& model)
{
  std::vector<char> isBorder(model.Mesh.Data.NumberOfPoints, 0);
  for (const auto& entry : model.Sharing.Places)
  {
    for (Index place : entry.second)
    {
      isBorder[place] = 1;
    }
  }
  return isBorder;
}

/// Marks the elements that have border nodes, in the order of their numbers in the file.
std::vector<char> FindBorderElements(const ExodusModel& model, const std::vector<char>& isBorder)
{
  const MeshData& mesh = model.Mesh.Data;
  std::vector<char> border(model.Numbers.size(), 0);
  for (std::size_t e = 0; e < model.Numbers.size(); ++e)
  {
    const Index* points = mesh.Element(static_cast<Index>(e));
    border[model.Numbers[e] - 1] =
      std::any_of(points, points + mesh.Corners, [&](Index point) { return isBorder[point] != 0; });
  }
  for (const CohesiveBlock& block : model.Cohesive)
  {
    const std::ptrdiff_t corners = CohesiveCorners(mesh);
    for (auto at = block.Points.begin(); at != block.Points.end(); at += corners)
    {
      border.push_back(
        std::any_of(at, at + corners, [&](Index point) { return isBorder[point] != 0; }));
    }
  }
  border.resize(static_cast<std::size_t>(model.NumberOfElements()), 0); // particles
  return border;
}

template <class Items>
Numbers IdsOf(const Items& items)
{
  Numbers ids;
  for (const auto& item : items)
  {
    ids.push_back(item.Id);
  }
  return ids;
}

/// Adds ids and totals of node sets or side sets. There are no distribution factors.
void AddSetTotals(NetcdfLayout& layout, const std::string& prefix, const std::string& count,
  NetcdfKind kind, std::size_t dimension, Numbers ids, const Numbers& totals)
{
  AddNumbers(layout, prefix + "_ids_global", NetcdfKind::Int, dimension, std::move(ids));
  AddNumbers(layout, prefix + count, kind, dimension, totals);
  AddNumbers(layout, prefix + "_df_cnt_global", kind, dimension, Numbers(totals.size(), 0));
}

void AddCommunication(NetcdfLayout& layout, const ExodusModel& model)
{
  Numbers ids, ends, nodes, ranks;
  for (const auto& entry : model.Sharing.Places)
  {
    ids.push_back(entry.first + 1);
    for (Index place : entry.second)
    {
      nodes.push_back(place + 1);
      ranks.push_back(entry.first);
    }
    ends.push_back(static_cast<Index>(nodes.size()));
  }
  const NetcdfKind kind = KindOfNumbers(model);
  const std::size_t maps = AddDimension(layout, "num_n_cmaps", static_cast<Index>(ids.size()));
  const std::size_t all = AddDimension(layout, "ncnt_cmap", static_cast<Index>(nodes.size()));
  Numbers status(ids.size(), 1);
  AddNumbers(layout, "n_comm_ids", NetcdfKind::Int, maps, std::move(ids));
  AddNumbers(layout, "n_comm_stat", NetcdfKind::Int, maps, std::move(status));
  AddNumbers(layout, "n_comm_data_idx", kind, maps, std::move(ends));
  AddNumbers(layout, "n_comm_nids", kind, all, std::move(nodes));
  AddNumbers(layout, "n_comm_proc", kind, all, std::move(ranks));
}

} // namespace

void AddNemesisHead(NetcdfLayout& layout, const ExodusModel& model, int ranks)
{
  const auto add = [&layout](const char* name, Index length)
  { return AddDimension(layout, name, length); };
  add("num_processors", ranks);
  add("num_procs_file", 1);
  add("num_nodes_global", model.TotalNodes);
  add("num_elems_global", model.TotalElements);
  const std::size_t blocks = add("num_el_blk_global", static_cast<Index>(model.Blocks.size()));
  const std::size_t nodeSets = add("num_ns_global", static_cast<Index>(model.NodeTotals.size()));
  const std::size_t sideSets = add("num_ss_global", static_cast<Index>(model.SideTotals.size()));
  // 0: file of a parallel computation
  AddVariable(layout, "nem_ftype", NetcdfKind::Int, {}, [] { return Numbers{ 0 }; });
  const NetcdfKind kind = KindOfNumbers(model);
  Numbers totals;
  for (const ExodusBlock& block : model.Blocks)
  {
    totals.push_back(block.Total);
  }
  AddNumbers(layout, "el_blk_ids_global", NetcdfKind::Int, blocks, IdsOf(model.Blocks));
  AddNumbers(layout, "el_blk_cnt_global", kind, blocks, std::move(totals));
  AddSetTotals(
    layout, "ns", "_node_cnt_global", kind, nodeSets, IdsOf(model.Sets.NodeSets), model.NodeTotals);
  AddSetTotals(
    layout, "ss", "_side_cnt_global", kind, sideSets, IdsOf(model.Sets.SideSets), model.SideTotals);
}

void AddNemesis(NetcdfLayout& layout, const ExodusModel& model)
{
  const std::vector<char> isBorder = FindBorderNodes(model);
  const std::vector<char> isBorderElement = FindBorderElements(model, isBorder);
  struct Map
  {
    const char *Dimension, *Name, *Status;
    Numbers Items;
  };
  Map maps[] = {
    { "num_int_elem", "elem_mapi", "int_e_stat", Choose(isBorderElement, false) },
    { "num_bor_elem", "elem_mapb", "bor_e_stat", Choose(isBorderElement, true) },
    { "num_int_node", "node_mapi", "int_n_stat", Choose(isBorder, false) },
    { "num_bor_node", "node_mapb", "bor_n_stat", Choose(isBorder, true) },
    { "num_ext_node", "node_mape", "ext_n_stat", {} },
  };
  const auto files = static_cast<std::size_t>(
    std::find_if(layout.Dimensions.begin(), layout.Dimensions.end(),
      [](const NetcdfDimension& dimension) { return dimension.Name == "num_procs_file"; }) -
    layout.Dimensions.begin());
  for (const Map& map : maps)
  {
    AddNumbers(layout, map.Status, NetcdfKind::Int, files, { map.Items.empty() ? 0 : 1 });
  }
  for (Map& map : maps)
  {
    const std::size_t count =
      AddDimension(layout, map.Dimension, static_cast<Index>(map.Items.size()));
    AddNumbers(layout, map.Name, KindOfNumbers(model), count, std::move(map.Items));
  }
  AddCommunication(layout, model);
}

} // namespace vfm
