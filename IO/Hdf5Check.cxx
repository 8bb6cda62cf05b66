#include "Hdf5Check.h"

#include "Hdf5Bytes.h"

#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace vfm
{
namespace
{

// Types of messages in the header of an object: "HDF5 File Format Specification", version 3.0.
enum Message
{
  Dataspace = 0x1,
  Datatype = 0x3,
  Link = 0x6,
  Attribute = 0xC,
  Continuation = 0x10,
  SymbolTable = 0x11,
  LinkCount = 0x16
};

constexpr int Word = 8; // width of addresses and lengths, bytes

void Require(bool isGood, const char* what)
{
  if (!isGood)
  {
    RejectHdf5(what);
  }
}

/// Checks that the bits of an integer or a real number are inside its bytes. The library writes
/// beyond its buffers, or since 1.14 does not open the object.
void CheckBits(const Hdf5Bytes& type, std::uint64_t size, bool isReal)
{
  const std::uint64_t first = type.Number(8, 2), count = type.Number(10, 2);
  const auto isInside = [count](std::uint64_t begin, std::uint64_t bits)
  { return bits > 0 && begin + bits <= count; };
  const bool isGood = count > 0 && first + count <= 8 * size &&
    (!isReal || // sign, exponent and mantissa
      (isInside(type.Number(2, 1), 1) && isInside(type.Number(12, 1), type.Number(13, 1)) &&
        isInside(type.Number(14, 1), type.Number(15, 1))));
  Require(isGood, "a number has bits outside of its bytes");
}

/// Checks that a type is as long as its class requires, and returns the size of a value.
std::uint64_t CheckType(const Hdf5Bytes& type)
{
  // Bytes behind the first eight, of integers, reals, times, .., arrays; base types have eight.
  constexpr std::uint64_t least[] = { 4, 12, 2, 0, 4, 0, 8, 0, 8, 8, 8 };
  constexpr std::uint64_t longest = 64; // bytes of an integer or a real number
  const std::uint64_t kind = type.Number(0, 1) & 0xF, size = type.Number(4, 4);
  const bool isReal = kind == 1, isNumber = kind == 0 || isReal;
  Require(
    kind < std::size(least) && size > 0 && !(isNumber && size > longest), "a type is unknown");
  type.Part(Word, least[kind]);
  if (isNumber)
  {
    CheckBits(type, size, isReal);
  }
  return size;
}

/// Checks a shape and returns the number of values; infinite if it is too large.
double CountValues(const Hdf5Bytes& space)
{
  const std::uint64_t version = space.Number(0, 1), rank = space.Number(1, 1);
  const bool hasLimits = space.Number(2, 1) & 1;
  Require((version == 1 || version == 2) && rank <= 32, "a shape is unknown");
  const std::size_t begin = version == 1 ? 8 : 4;
  space.Part(begin, rank * Word * (hasLimits ? 2 : 1));
  double count = version == 2 && space.Number(3, 1) == 2 ? 0.0 : 1.0;
  for (std::size_t i = 0; i < rank; ++i)
  {
    count *= static_cast<double>(space.Number(begin + i * Word, Word));
  }
  return count;
}

/// Checks that an attribute contains its name, type, shape and values.
void CheckAttribute(const Hdf5Bytes& attribute)
{
  const std::uint64_t version = attribute.Number(0, 1);
  Require(version >= 1 && version <= 3, "an attribute is unknown");
  const std::uint64_t shared = version == 1 ? 0 : attribute.Number(1, 1) & 3;
  std::size_t at = version == 3 ? 9 : 8;
  const auto take = [&](std::size_t place)
  {
    const std::uint64_t size = attribute.Number(place, 2);
    const std::uint64_t stored = version == 1 ? (size + 7) / 8 * 8 : size;
    const Hdf5Bytes part = attribute.Part(at, size);
    at += stored;
    return part;
  };
  const Hdf5Bytes name = take(2), type = take(4), space = take(6);
  Require(name.HasText(0), "a name of an attribute has no end");
  Require(shared == 0, "an attribute has a type or a shape of its own object");
  const double size = static_cast<double>(CheckType(type)) * CountValues(space);
  const double left = static_cast<double>(attribute.Size()) - static_cast<double>(at);
  Require(size <= left, "an attribute is shorter than its values");
}

/// Walks through all objects that are reached from the root.
class StructureWalk
{
public:
  explicit StructureWalk(const std::string& path) : Stream(path) { this->FindRoot(); }

  void CheckAll()
  {
    while (!this->ToDo.empty())
    {
      const std::uint64_t address = this->ToDo.back();
      this->ToDo.pop_back();
      // The library counts on the number of links to find cycles.
      Require(this->Single.count(address) == 0, "an object has more links than it counts");
      if (this->IsNew(address))
      {
        this->Current = address;
        this->Single.insert(address);
        this->CheckObject(address);
      }
    }
  }

private:
  /// Part of the header of an object.
  struct Chunk
  {
    std::uint64_t Address, Size;
    bool IsMarked = false; ///< begins with "OCHK", ends with a checksum
  };

  bool IsNew(std::uint64_t address) { return this->Visited.insert(address).second; }

  void FindRoot()
  {
    const std::uint64_t version = this->Stream.Read(8, 1).Number(0, 1);
    const bool isOld = version < 2;
    const std::size_t sizes = isOld ? 13 : 9, root = isOld ? (version == 0 ? 64 : 68) : 36;
    const Hdf5Bytes head = this->Stream.Read(0, root + Word);
    Require(version <= 3 && head.Number(sizes, 1) == Word && head.Number(sizes + 1, 1) == Word,
      "its version is unknown");
    this->MostSymbols = isOld ? 2 * head.Number(16, 2) : this->MostSymbols;
    this->ToDo.push_back(head.Number(root, Word));
  }

  void CheckObject(std::uint64_t address)
  {
    const Hdf5Bytes head = this->Stream.Read(address, 6);
    if (head.BeginsWith("OHDR"))
    {
      const std::uint64_t flags = head.Number(5, 1);
      const std::uint64_t begin = address + 6 + (flags & 0x20 ? 16 : 0) + (flags & 0x10 ? 4 : 0);
      const int width = 1 << (flags & 3);
      const std::uint64_t size = this->Stream.Read(begin, width).Number(0, width);
      this->CheckChunks({ begin + width, size }, flags & 4 ? 6 : 4);
      return;
    }
    Require(head.Number(0, 1) == 1, "an object is unknown");
    constexpr int prefix = 16;
    const Hdf5Bytes old = this->Stream.Read(address, prefix);
    this->CountLinks(old.Number(4, 4));
    this->CheckChunks({ address + prefix, old.Number(8, 4) }, OldPrefix);
  }

  /// Checks the messages of an object.
  /// @param prefix  bytes in front of each message
  void CheckChunks(const Chunk& first, std::size_t prefix)
  {
    std::vector<Chunk> chunks{ first };
    while (!chunks.empty())
    {
      const Chunk chunk = chunks.back();
      chunks.pop_back();
      const std::vector<Chunk> more = this->CheckChunk(chunk, prefix);
      chunks.insert(chunks.end(), more.begin(), more.end());
    }
  }

  /// Returns the chunks that continue the header.
  std::vector<Chunk> CheckChunk(const Chunk& chunk, std::size_t prefix)
  {
    const Hdf5Bytes bytes = this->Stream.Read(chunk.Address, chunk.Size);
    const bool isOld = prefix == OldPrefix;
    constexpr std::size_t mark = 4; // length of "OCHK" and of the checksum
    Require(!chunk.IsMarked || (bytes.BeginsWith("OCHK") && bytes.Size() >= 2 * mark),
      "the header of an object is damaged");
    const std::size_t end = bytes.Size() - (chunk.IsMarked ? mark : 0);
    std::vector<Chunk> more;
    for (std::size_t at = chunk.IsMarked ? mark : 0; at + prefix <= end;)
    {
      const std::uint64_t type = bytes.Number(at, isOld ? 2 : 1);
      const std::uint64_t size = bytes.Number(at + (isOld ? 2 : 1), 2);
      const bool isShared = bytes.Number(at + (isOld ? 4 : 3), 1) & 2;
      const Hdf5Bytes message = bytes.Part(at + prefix, size);
      at += prefix + size;
      if (type == Continuation)
      {
        more.push_back({ message.Number(0, Word), message.Number(Word, Word), !isOld });
        Require(this->IsNew(more.back().Address), "the header of an object repeats itself");
      }
      else if (!isShared)
      {
        this->CheckMessage(type, message);
      }
    }
    return more;
  }

  void CheckMessage(std::uint64_t type, const Hdf5Bytes& message)
  {
    switch (type)
    {
      case Dataspace:
        CountValues(message);
        break;
      case Datatype:
        CheckType(message);
        break;
      case Attribute:
        CheckAttribute(message);
        break;
      case Link:
        this->AddLink(message);
        break;
      case LinkCount:
        this->CountLinks(message.Number(1, 4));
        break;
      case SymbolTable:
        this->CheckGroup(message.Number(0, Word), message.Number(Word, Word));
        break;
      default:
        break;
    }
  }

  void CountLinks(std::uint64_t count)
  {
    if (count > 1)
    {
      this->Single.erase(this->Current);
    }
  }

  /// Adds the object of a hard link.
  void AddLink(const Hdf5Bytes& link)
  {
    const std::uint64_t flags = link.Number(1, 1);
    const bool isHard = !(flags & 8) || link.Number(2, 1) == 0;
    const std::size_t at = 2 + (flags & 8 ? 1 : 0) + (flags & 4 ? 8 : 0) + (flags & 0x10 ? 1 : 0);
    const int width = 1 << (flags & 3);
    const std::uint64_t name = link.Number(at, width);
    const Hdf5Bytes after = link.Part(at + width, name + (isHard ? Word : 0));
    if (isHard)
    {
      this->ToDo.push_back(after.Number(name, Word));
    }
  }

  /// Checks a group: the names in its heap and the nodes of its tree.
  void CheckGroup(std::uint64_t tree, std::uint64_t heap)
  {
    if (!this->Groups.insert({ tree, heap }).second)
    {
      return;
    }
    Require(this->IsNew(tree), "two groups have the same tree");
    const Hdf5Bytes head = this->Stream.Read(heap, 32);
    Require(head.BeginsWith("HEAP") && head.Number(8, Word) > 0, "a group has no names");
    const Hdf5Bytes names = this->Stream.Read(head.Number(24, Word), head.Number(8, Word));
    this->CheckNode(tree, names, this->Stream.Read(tree, 24).Number(5, 1));
  }

  void CheckNode(std::uint64_t address, const Hdf5Bytes& names, std::uint64_t level)
  {
    const Hdf5Bytes head = this->Stream.Read(address, 24);
    const std::uint64_t count = head.Number(6, 2);
    Require(head.BeginsWith("TREE") && head.Number(4, 1) == 0 && head.Number(5, 1) == level,
      "a group has no tree of its entries");
    const Hdf5Bytes keys = this->Stream.Read(address + 24, Word * (2 * count + 1));
    for (std::size_t i = 0; i < count; ++i)
    {
      Require(names.HasText(keys.Number(Word * 2 * i, Word)), "a name of a group has no end");
      const std::uint64_t child = keys.Number(Word * (2 * i + 1), Word);
      Require(this->IsNew(child), "a tree of a group repeats itself");
      level > 0 ? this->CheckNode(child, names, level - 1) : this->CheckSymbols(child, names);
    }
    Require(names.HasText(keys.Number(Word * 2 * count, Word)), "a name of a group has no end");
  }

  void CheckSymbols(std::uint64_t address, const Hdf5Bytes& names)
  {
    constexpr std::size_t size = 40; // of an entry
    const Hdf5Bytes head = this->Stream.Read(address, 8);
    const std::uint64_t count = head.Number(6, 2);
    Require(
      head.BeginsWith("SNOD") && count <= this->MostSymbols, "entries of a group are damaged");
    const Hdf5Bytes entries = this->Stream.Read(address + 8, count * size);
    for (std::size_t at = 0; at < entries.Size(); at += size)
    {
      const std::uint64_t kind = entries.Number(at + 16, 4);
      Require(names.HasText(entries.Number(at, Word)), "a name of a group has no end");
      if (kind == 2) // a soft link
      {
        Require(names.HasText(entries.Number(at + 24, 4)), "a link of a group has no end");
        continue;
      }
      this->ToDo.push_back(entries.Number(at + 8, Word));
      if (kind == 1) // a group, whose message SymbolTable is repeated
      {
        this->CheckGroup(entries.Number(at + 24, Word), entries.Number(at + 32, Word));
      }
    }
  }

  static constexpr std::size_t OldPrefix = 8; // bytes in front of a message of version 1

  Hdf5Stream Stream;
  std::uint64_t MostSymbols = 8; // entries in a node; 8 unless the head of the file says more
  std::vector<std::uint64_t> ToDo;
  std::uint64_t Current = 0;       // address of the object that is checked
  std::set<std::uint64_t> Single;  // addresses of objects that have one link
  std::set<std::uint64_t> Visited; // addresses of objects, chunks and nodes
  std::set<std::pair<std::uint64_t, std::uint64_t>> Groups; // addresses of tree and heap
};

} // namespace

void CheckHdf5(const std::string& path)
{
  StructureWalk(path).CheckAll();
}

} // namespace vfm
