#include "Input/SparseCells.h"

#include "Input/PackBytes.h"

namespace vfm
{

double SparseCells::Fraction(Index cell, int material) const
{
  if (!this->IsListed(cell))
  {
    return this->Entry[cell] == material ? 1.0 : 0.0;
  }
  const Index list = ~static_cast<Index>(this->Entry[cell]);
  for (Index item = this->Offset[list]; item < this->Offset[list + 1]; ++item)
  {
    if (this->Material[item] == material)
    {
      return this->Value[item];
    }
  }
  return 0.0;
}

Bytes PackCells(const std::vector<SparseCells>& boxes)
{
  Packer packer;
  for (const SparseCells& cells : boxes)
  {
    packer.Add(cells.Box);
    packer.Add(cells.Entry);
    packer.Add(cells.Offset);
    packer.Add(cells.Material);
    packer.Add(cells.Value);
  }
  return std::move(packer.Packed);
}

std::vector<SparseCells> UnpackCells(const Bytes& bytes)
{
  std::vector<SparseCells> boxes;
  for (Unpacker message(bytes); !message.IsAtEnd();)
  {
    boxes.emplace_back();
    SparseCells& cells = boxes.back();
    message.TakeTo(cells.Box);
    message.TakeTo(cells.Entry);
    message.TakeTo(cells.Offset);
    message.TakeTo(cells.Material);
    message.TakeTo(cells.Value);
  }
  return boxes;
}

} // namespace vfm
