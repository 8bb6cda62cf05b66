#include "Input/SparseCells.h"

namespace vfm
{
namespace
{

template <class T>
void Append(const T* items, std::size_t count, Bytes& bytes)
{
  const char* first = reinterpret_cast<const char*>(items);
  bytes.insert(bytes.end(), first, first + count * sizeof(T));
}

template <class T>
void Append(const std::vector<T>& items, Bytes& bytes)
{
  const std::size_t count = items.size();
  Append(&count, 1, bytes);
  Append(items.data(), count, bytes);
}

/// Takes items from a message, one after the other.
class Unpacker
{
public:
  explicit Unpacker(const Bytes& bytes) : Message(bytes) {}
  bool IsAtEnd() const { return this->At == this->Message.size(); }
  template <class T>
  void Take(T* items, std::size_t count)
  {
    if (count > 0)
    {
      std::memcpy(items, this->Message.data() + this->At, count * sizeof(T));
      this->At += count * sizeof(T);
    }
  }
  template <class T>
  void Take(std::vector<T>& items)
  {
    std::size_t count = 0;
    this->Take(&count, 1);
    items.resize(count);
    this->Take(items.data(), count);
  }

private:
  const Bytes& Message;
  std::size_t At = 0;
};

} // namespace

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
  Bytes bytes;
  for (const SparseCells& cells : boxes)
  {
    Append(&cells.Box, 1, bytes);
    Append(cells.Entry, bytes);
    Append(cells.Offset, bytes);
    Append(cells.Material, bytes);
    Append(cells.Value, bytes);
  }
  return bytes;
}

std::vector<SparseCells> UnpackCells(const Bytes& bytes)
{
  std::vector<SparseCells> boxes;
  for (Unpacker message(bytes); !message.IsAtEnd();)
  {
    boxes.emplace_back();
    SparseCells& cells = boxes.back();
    message.Take(&cells.Box, 1);
    message.Take(cells.Entry);
    message.Take(cells.Offset);
    message.Take(cells.Material);
    message.Take(cells.Value);
  }
  return boxes;
}

} // namespace vfm
