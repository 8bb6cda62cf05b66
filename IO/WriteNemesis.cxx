#include "WriteNemesis.h"

#include "ExodusFile.h"

#include "vtkCellArray.h"
#include "vtkUnstructuredGrid.h"

#include "vtk_exodusII.h"

#include <algorithm>

namespace vfm
{
namespace
{

using Numbers = std::vector<Index>;

/// The places, from 1, where the flag is set, or those where it is not.
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
  std::vector<char> isBorder(model.Mesh->GetNumberOfPoints(), 0);
  for (const auto& entry : model.Sharing.Places)
  {
    for (Index place : entry.second)
    {
      isBorder[place] = 1;
    }
  }
  return isBorder;
}

/// By their numbers in the file.
std::vector<char> FindBorderElements(const ExodusModel& model, const std::vector<char>& isBorder)
{
  std::vector<char> border(model.Elements.size(), 0);
  for (std::size_t cell = 0; cell < model.Elements.size(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    model.Mesh->GetCells()->GetCellAtId(static_cast<vtkIdType>(cell), size, points);
    border[model.Elements[cell] - 1] =
      std::any_of(points, points + size, [&](vtkIdType point) { return isBorder[point] != 0; });
  }
  return border;
}

template <class Items>
Numbers GetIds(const Items& items)
{
  Numbers ids;
  for (const auto& item : items)
  {
    ids.push_back(item.Id);
  }
  return ids;
}

void WriteTotals(const ExodusModel& model, ExodusFile& file)
{
  Numbers blocks = GetIds(model.Blocks), sides = GetIds(model.Sets.SideSets),
          nodes = GetIds(model.Sets.NodeSets), totals;
  for (const ExodusBlock& block : model.Blocks)
  {
    totals.push_back(block.Total);
  }
  Numbers sideTotals = model.SideTotals, nodeTotals = model.NodeTotals;
  Numbers sideFactors(sides.size(), 0), nodeFactors(nodes.size(), 0);
  file.Check(ex_put_eb_info_global(file.Id(), blocks.data(), totals.data()));
  if (!nodes.empty())
  {
    file.Check(
      ex_put_ns_param_global(file.Id(), nodes.data(), nodeTotals.data(), nodeFactors.data()));
  }
  if (!sides.empty())
  {
    file.Check(
      ex_put_ss_param_global(file.Id(), sides.data(), sideTotals.data(), sideFactors.data()));
  }
}

void WriteCommunication(const ExodusModel& model, int rank, ExodusFile& file)
{
  Numbers ids, counts;
  for (const auto& entry : model.Sharing.Places)
  {
    ids.push_back(entry.first + 1);
    counts.push_back(static_cast<Index>(entry.second.size()));
  }
  if (ids.empty())
  {
    return;
  }
  file.Check(ex_put_cmap_params(file.Id(), ids.data(), counts.data(), nullptr, nullptr, rank));
  for (const auto& entry : model.Sharing.Places)
  {
    Numbers nodes = entry.second, ranks(nodes.size(), entry.first);
    for (Index& node : nodes)
    {
      ++node;
    }
    file.Check(ex_put_node_cmap(file.Id(), entry.first + 1, nodes.data(), ranks.data(), rank));
  }
}

} // namespace

void WriteNemesisHead(const ExodusModel& model, int count, ExodusFile& file)
{
  char parallel[] = "p";
  file.Check(ex_put_init_info(file.Id(), count, 1, parallel));
  file.Check(ex_put_init_global(file.Id(), model.TotalNodes, model.TotalElements,
    static_cast<Index>(model.Blocks.size()), static_cast<Index>(model.Sets.NodeSets.size()),
    static_cast<Index>(model.Sets.SideSets.size())));
}

void WriteNemesis(const ExodusModel& model, int rank, ExodusFile& file)
{
  const std::vector<char> isBorder = FindBorderNodes(model);
  const std::vector<char> isBorderElement = FindBorderElements(model, isBorder);
  Numbers inside = Choose(isBorder, false), border = Choose(isBorder, true),
          insideElements = Choose(isBorderElement, false),
          borderElements = Choose(isBorderElement, true);
  const auto size = [](const auto& list) { return static_cast<Index>(list.size()); };
  file.Check(ex_put_loadbal_param(file.Id(), size(inside), size(border), 0, size(insideElements),
    size(borderElements), size(model.Sharing.Places), 0, rank));
  WriteTotals(model, file);
  WriteCommunication(model, rank, file);
  file.Check(ex_put_processor_node_maps(file.Id(), inside.data(), border.data(), nullptr, rank));
  file.Check(
    ex_put_processor_elem_maps(file.Id(), insideElements.data(), borderElements.data(), rank));
}

} // namespace vfm
