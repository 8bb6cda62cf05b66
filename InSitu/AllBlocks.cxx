#include "AllBlocks.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

namespace vfm
{
namespace
{

/// Cells that no other box of its level has.
struct Place
{
  IndexBox Cells;
  Index Level; // no padding is sent
};

/// The host's marks of a box, or null.
const unsigned char* FindGhostTypes(const HostBox& box)
{
  for (const HostArray& array : box.Arrays)
  {
    if (array.Name == vtkDataSetAttributes::GhostArrayName() &&
      array.Type == HostType::UnsignedChar && array.Components == 1)
    {
      return static_cast<const unsigned char*>(array.Values);
    }
  }
  return nullptr;
}

/// Without layers that are copies of other boxes: coarser cells below them may be the finest there.
Place FindPlace(const HostBox& box)
{
  const unsigned char* types = FindGhostTypes(box);
  Place place{ box.Cells, box.Level };
  if (types)
  {
    place.Cells = { box.Cells.Upper, box.Cells.Lower };
    ForCells(box.Cells,
      [&](const Index3& cell)
      {
        if (*types++ & vtkDataSetAttributes::DUPLICATECELL)
        {
          return;
        }
        for (int a = 0; a < 3; ++a)
        {
          place.Cells.Lower[a] = std::min(place.Cells.Lower[a], cell[a]);
          place.Cells.Upper[a] = std::max(place.Cells.Upper[a], cell[a] + 1);
        }
      });
  }
  return place;
}

vtkSmartPointer<vtkUnsignedCharArray> CopyGhostTypes(const HostBox& box)
{
  auto copy = vtkSmartPointer<vtkUnsignedCharArray>::New();
  copy->SetName(vtkDataSetAttributes::GhostArrayName());
  copy->SetNumberOfValues(box.Cells.NumberOfCells());
  if (const unsigned char* types = FindGhostTypes(box))
  {
    std::copy_n(types, box.Cells.NumberOfCells(), copy->GetPointer(0));
  }
  else
  {
    copy->FillValue(0);
  }
  return copy;
}

void HideCovered(const HostBox& box, const std::vector<Place>& places, vtkDataObject* image)
{
  vtkSmartPointer<vtkUnsignedCharArray> types;
  for (const Place& place : places)
  {
    const int finer = static_cast<int>(place.Level) - box.Level;
    const IndexBox covered =
      finer > 0 ? Intersect(ChangeLevel(place.Cells, -finer), box.Cells) : IndexBox();
    if (covered.NumberOfCells() > 0)
    {
      types = types ? types : CopyGhostTypes(box);
      ForCells(covered,
        [&](const Index3& cell)
        { types->GetPointer(0)[IndexInBox(box.Cells, cell)] |= vtkDataSetAttributes::HIDDENCELL; });
    }
  }
  if (types)
  {
    image->GetAttributes(vtkDataObject::CELL)->AddArray(types);
  }
}

} // namespace

vtkSmartPointer<vtkMultiBlockDataSet> MakeAllBlocks(const HostGrid& grid, Ranks& ranks)
{
  CheckHostGrid(grid);
  std::vector<Place> mine;
  for (const HostBox& box : grid.Boxes)
  {
    mine.push_back(FindPlace(box));
  }
  unsigned int first = 0;
  std::vector<Place> all;
  const std::vector<Bytes> gathered = ranks.Gather(ToBytes(mine));
  for (int rank = 0; rank < ranks.Count(); ++rank)
  {
    const std::vector<Place> places = FromBytes<Place>(gathered[rank]);
    first += rank < ranks.Rank() ? static_cast<unsigned int>(places.size()) : 0;
    all.insert(all.end(), places.begin(), places.end());
  }
  auto blocks = MakeBlocks(grid, first, static_cast<unsigned int>(all.size()));
  for (const HostBox& box : grid.Boxes)
  {
    HideCovered(box, all, blocks->GetBlock(first++));
  }
  return blocks;
}

} // namespace vfm
