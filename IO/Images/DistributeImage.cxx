#include "Images/DistributeImage.h"

#include "Ranks/ItemRoute.h"

#include <algorithm>
#include <cstring>

namespace vfm
{
namespace
{

/// Returns the type and the values in a box of a whole image, as bytes.
Bytes Cut(const TypedValues& values, const Index3& size, const IndexBox& box)
{
  const Index width = WidthOfType(values.Type);
  Bytes part(sizeof(values.Type) + box.NumberOfCells() * width);
  std::memcpy(part.data(), &values.Type, sizeof(values.Type));
  char* to = part.data() + sizeof(values.Type);
  ForRows(box,
    [&](Index j, Index k)
    {
      const Index length = box.Size(0) * width;
      std::memcpy(
        to, values.Bytes.data() + ((k * size[1] + j) * size[0] + box.Lower[0]) * width, length);
      to += length;
    });
  return part;
}

/// Converts the result of Cut to values.
TypedValues Uncut(const IndexBox& box, const Bytes& bytes)
{
  int type = 0;
  std::memcpy(&type, bytes.data(), sizeof(type));
  TypedValues values = MakeValues("", type, box.NumberOfCells());
  std::copy(bytes.begin() + sizeof(type), bytes.end(), values.Bytes.begin());
  return values;
}

} // namespace

TypedValues ReadPart(const ImageFile& file, const IndexBox& box, Ranks& ranks)
{
  const IndexBox whole{ {}, file.Place.Size };
  const bool isEmpty = box.NumberOfCells() == 0;
  if (file.ReadsParts || (ranks.Count() == 1 && box == whole))
  {
    return isEmpty ? TypedValues() : file.Read(box);
  }
  const std::vector<IndexBox> boxes = // of all ranks, on rank 0
    ItemRoute({ 0 }, ranks).Send(std::vector<IndexBox>{ box });
  const TypedValues values = ranks.Rank() == 0 ? file.Read(whole) : TypedValues();
  Bytes mine;
  // Parts are sent one by one, so that at most one of them is in memory twice.
  for (int rank = 1; rank < ranks.Count(); ++rank)
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
  return isEmpty ? TypedValues() : Uncut(box, mine);
}

} // namespace vfm
