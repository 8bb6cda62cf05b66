#include "Images/DealImage.h"

#include "ArrayMemory.h"

#include "vtkDataArray.h"

#include <cstring>

namespace vfm
{
namespace
{

/// The values of a box of a whole image, as bytes.
Bytes Cut(vtkDataArray* values, const Index3& size, const IndexBox& box)
{
  const Index width = values->GetDataTypeSize();
  Bytes part(box.NumberOfCells() * width);
  char* to = part.data();
  const char* from = static_cast<const char*>(FindMemory(values));
  ForRows(box,
    [&](Index j, Index k)
    {
      const Index length = box.Size(0) * width;
      std::memcpy(to, from + ((k * size[1] + j) * size[0] + box.Lower[0]) * width, length);
      to += length;
    });
  return part;
}

vtkSmartPointer<vtkDataArray> MakeArray(int type, const IndexBox& box, const Bytes& bytes)
{
  const auto values = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  values->SetNumberOfTuples(box.NumberOfCells());
  std::memcpy(FindMemory(values), bytes.data(), bytes.size());
  return values;
}

} // namespace

vtkSmartPointer<vtkDataArray> ReadPart(ImageFile& file, const IndexBox& box, Ranks& ranks)
{
  const IndexBox whole{ {}, file.Place().Size };
  const bool isEmpty = box.NumberOfCells() == 0;
  if (file.ReadsParts() || (ranks.Count() == 1 && box == whole))
  {
    return isEmpty ? nullptr : file.Read(box);
  }
  const std::vector<IndexBox> boxes = GatherItems(ranks, std::vector<IndexBox>{ box });
  const auto values = ranks.Rank() == 0 ? file.Read(whole) : vtkSmartPointer<vtkDataArray>();
  const int type = GatherItems(ranks, std::vector<int>{ values ? values->GetDataType() : 0 })[0];
  Bytes mine;
  for (int rank = 1; rank < ranks.Count(); ++rank) // one at a time: a part is held twice, not all
  {
    if (ranks.Rank() == 0)
    {
      ranks.Exchange({ rank }, { Cut(values, whole.Upper, boxes[rank]) });
    }
    else if (ranks.Rank() == rank)
    {
      mine = ranks.Exchange({ 0 }, { Bytes() })[0];
    }
  }
  if (ranks.Rank() == 0)
  {
    mine = Cut(values, whole.Upper, box);
  }
  return isEmpty ? nullptr : MakeArray(type, box, mine);
}

} // namespace vfm
