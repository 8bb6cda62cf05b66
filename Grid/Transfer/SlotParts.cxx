#include "Transfer/SlotParts.h"

#include <limits>

namespace vfm
{
namespace
{

/// A part of an element in a cell of another rank.
struct SentPart
{
  Index Id, Key; // of the element, of the cell
  int Fragment, Material;
  double Volume;
  Vector3 Centroid;
};

void AddPart(double volume, const Vector3& centroid, Slot& slot, SlotShape& shape)
{
  const Vector3 x = centroid - slot.Centroid;
  slot.Overlap += volume;
  shape.First = shape.First + volume * x;
  for (int a = 0; a < 3; ++a)
  {
    shape.Second[a] += volume * x[a] * x[a];
    shape.Lower[a] = std::min(shape.Lower[a], x[a]);
    shape.Upper[a] = std::max(shape.Upper[a], x[a]);
  }
  shape.Second[3] += volume * x[0] * x[1];
  shape.Second[4] += volume * x[0] * x[2];
  shape.Second[5] += volume * x[1] * x[2];
}

constexpr std::size_t ElementsAtOnce = 32768;

/// Finds slots of parts; elements one after the other are mostly in the same cells.
class SlotFinder
{
public:
  SlotFinder(const CartesianGrid& grid, SlotTable& slots) : Grid(grid), Slots(slots) {}

  int Find(std::size_t place, Index cell, int fragment, int material)
  {
    Last& last = this->Recent[place % this->Recent.size()];
    if (last.Cell != cell || last.Fragment != fragment)
    {
      const Index n = this->Grid.Linear(CellInBox(this->Grid.Local(), cell));
      last = { cell, fragment, this->Slots.Get(n, fragment, material) };
    }
    return last.Slot;
  }

private:
  struct Last
  {
    Index Cell = -1;
    int Fragment = 0, Slot = 0;
  };
  const CartesianGrid& Grid;
  SlotTable& Slots;
  std::array<Last, 8> Recent;
};

SlotParts CutElements(const Mesh& mesh, std::vector<Index> elements, const CartesianGrid& grid,
  Runtime& runtime, SlotFinder& finder)
{
  SlotParts some{ std::move(elements), {}, {} };
  const Overlaps overlaps = FindOverlaps(mesh, some.Elements, grid, runtime);
  some.Offsets.assign(overlaps.Offsets.begin(), overlaps.Offsets.end());
  some.Parts.reserve(overlaps.Parts.size());
  for (std::size_t i = 0; i < some.Elements.size(); ++i)
  {
    const Index e = some.Elements[i];
    for (Index p = overlaps.Offsets[i]; p < overlaps.Offsets[i + 1]; ++p)
    {
      const OverlapPart& part = overlaps.Parts[p];
      const std::size_t place = p - overlaps.Offsets[i];
      some.Parts.push_back({ part.Volume, part.Centroid,
        finder.Find(place, part.Cell, mesh.Fragment[e], mesh.Material[e]) });
    }
  }
  return some;
}

/// Calls body(element, part) for all.
template <class Body>
void ForParts(const std::vector<SlotParts>& pieces, const Body& body)
{
  for (const SlotParts& some : pieces)
  {
    for (std::size_t i = 0; i < some.Elements.size(); ++i)
    {
      for (int p = some.Offsets[i]; p < some.Offsets[i + 1]; ++p)
      {
        body(some.Elements[i], some.Parts[p]);
      }
    }
  }
}

/// To the owners of the cells; what came for mine, by the ids of the elements.
std::vector<SentPart> ExchangeParts(const Mesh& mesh, const std::vector<SlotParts>& pieces,
  const CartesianGrid& grid, const Partition& partition, const SlotTable& slots)
{
  std::vector<std::vector<SentPart>> sent(partition.Peers().size());
  if (sent.empty())
  {
    return {};
  }
  ForParts(pieces,
    [&](Index e, const SlotPart& part)
    {
      const Slot& slot = slots[part.Slot];
      if (!slot.IsOwned)
      {
        const Index3 cell = grid.Position(slot.Cell);
        sent[partition.PeerOfCell(cell)].push_back({ mesh.ElementIds[e], grid.CellKey(cell),
          slot.Fragment, slot.Material, part.Volume, part.Centroid });
      }
    });
  std::vector<Bytes> outgoing;
  for (const std::vector<SentPart>& list : sent)
  {
    outgoing.push_back(ToBytes(list));
  }
  std::vector<SentPart> received;
  for (const Bytes& bytes : partition.Group().Exchange(partition.Peers(), outgoing))
  {
    const std::vector<SentPart> list = FromBytes<SentPart>(bytes);
    received.insert(received.end(), list.begin(), list.end());
  }
  std::stable_sort(received.begin(), received.end(),
    [](const SentPart& a, const SentPart& b) { return a.Id < b.Id; });
  return received;
}

/// Sums anew, with the parts of other ranks between those of this one, where there are some.
void AddOthers(const std::vector<SentPart>& others, const std::vector<SlotParts>& pieces,
  const Mesh& mesh, const CartesianGrid& grid, SlotTable& slots, std::vector<SlotShape>& shapes)
{
  std::vector<int> slotOf;
  for (const SentPart& other : others)
  {
    slotOf.push_back(
      slots.Get(grid.Linear(grid.CellOfKey(other.Key)), other.Fragment, other.Material));
  }
  shapes.resize(slots.Count());
  std::vector<unsigned char> isShared(slots.Count(), 0);
  for (int s : slotOf)
  {
    isShared[s] = 1;
    slots[s].Overlap = 0.0;
    shapes[s] = SlotShape();
  }
  std::size_t next = 0;
  const auto addBefore = [&](Index id)
  {
    for (; next < others.size() && others[next].Id < id; ++next)
    {
      const int s = slotOf[next];
      AddPart(others[next].Volume, others[next].Centroid, slots[s], shapes[s]);
    }
  };
  ForParts(pieces,
    [&](Index e, const SlotPart& part)
    {
      if (isShared[part.Slot])
      {
        addBefore(mesh.ElementIds[e]);
        AddPart(part.Volume, part.Centroid, slots[part.Slot], shapes[part.Slot]);
      }
    });
  addBefore(std::numeric_limits<Index>::max());
}

} // namespace

std::vector<SlotParts> FindSlotParts(const Mesh& mesh, const std::vector<Index>& elements,
  const CartesianGrid& grid, const Partition& partition, Runtime& runtime, SlotTable& slots,
  std::vector<SlotShape>& shapes)
{
  std::vector<SlotParts> pieces;
  SlotFinder finder(grid, slots);
  for (std::size_t begin = 0; begin < elements.size(); begin += ElementsAtOnce)
  {
    const std::size_t end = std::min(begin + ElementsAtOnce, elements.size());
    pieces.push_back(CutElements(mesh,
      std::vector<Index>(elements.begin() + begin, elements.begin() + end), grid, runtime, finder));
  }
  shapes.resize(slots.Count());
  ForParts(pieces,
    [&](Index, const SlotPart& part)
    {
      if (slots[part.Slot].IsOwned)
      {
        AddPart(part.Volume, part.Centroid, slots[part.Slot], shapes[part.Slot]);
      }
    });
  AddOthers(ExchangeParts(mesh, pieces, grid, partition, slots), pieces, mesh, grid, slots, shapes);
  return pieces;
}

void CentreShapes(SlotTable& slots, std::vector<SlotShape>& shapes)
{
  for (int s = 0; s < slots.Count(); ++s)
  {
    Slot& slot = slots[s];
    if (slot.Overlap > 0.0)
    {
      SlotShape& shape = shapes[s];
      const Vector3 mean = (1.0 / slot.Overlap) * shape.First;
      slot.Centroid = slot.Centroid + mean;
      const double o = slot.Overlap;
      const Vector3& m = mean;
      const std::array<double, 6> moved{ { m[0] * m[0], m[1] * m[1], m[2] * m[2], m[0] * m[1],
        m[0] * m[2], m[1] * m[2] } };
      for (int i = 0; i < 6; ++i)
      {
        shape.Second[i] -= o * moved[i];
      }
      shape.Lower = shape.Lower - mean;
      shape.Upper = shape.Upper - mean;
    }
  }
}

} // namespace vfm
