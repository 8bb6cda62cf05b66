#include "Smoothing/HexRings.h"

#include "Smoothing/ActiveMesh.h"

#include <limits>
#include <stdexcept>
#include <string>
#include <unordered_map>

namespace vfm
{
namespace
{

// HexRings::Hex::Ends of corner 0, in order and with the first two axes exchanged.
constexpr int Ends[2][6] = { { 1, 2, 4, 3, 6, 5 }, { 2, 1, 4, 3, 5, 6 } };

/// Numbers the points of a ring; reused for one ring after another.
class RingNumbers
{
public:
  void Start(int center)
  {
    this->Center = center;
    this->Points.clear();
  }
  std::uint8_t Of(int point)
  {
    std::size_t at = point % Slots;
    while (this->Seen[at].Center == this->Center && this->Seen[at].Point != point)
    {
      at = (at + 1) % Slots;
    }
    Slot& slot = this->Seen[at];
    if (slot.Center != this->Center)
    {
      if (this->Points.size() >= HexRings::LargestRing)
      {
        throw std::logic_error("A point of a mesh has too many neighbours.");
      }
      slot = { this->Center, point, static_cast<std::uint8_t>(this->Points.size()) };
      this->Points.push_back(point);
    }
    return slot.Number;
  }

  std::vector<int> Points; // points of the ring

private:
  static constexpr std::size_t Slots = 1024;
  struct Slot
  {
    int Center, Point;
    std::uint8_t Number;
  };
  // Hash table; an entry with another centre is free.
  std::vector<Slot> Seen = std::vector<Slot>(Slots, { -1, -1, 0 });
  int Center = -1;
};

/// Returns whether the edges at a corner of a hex, along its axes, form a left-handed frame. It
/// does if its number has an odd number of bits.
bool IsLeftHanded(int corner)
{
  return 0x96 >> corner & 1;
}

using HexList = std::vector<HexRings::Hex>;

/// Numbers the distinct lists of hexes.
class ListNumbers
{
public:
  std::uint32_t Of(const HexList& list)
  {
    this->Key.assign(
      reinterpret_cast<const char*>(list.data()), list.size() * sizeof(HexRings::Hex));
    const auto at =
      this->Known.try_emplace(this->Key, static_cast<std::uint32_t>(this->Lists.size()));
    if (at.second)
    {
      this->Lists.push_back(list);
    }
    return at.first->second;
  }

  std::vector<HexList> Lists;

private:
  std::unordered_map<std::string, std::uint32_t> Known;
  std::string Key;
};

/// Range of numbers of points.
struct Range
{
  int Lowest = std::numeric_limits<int>::max(), Highest = -1;
  void Add(int point)
  {
    this->Lowest = std::min(this->Lowest, point);
    this->Highest = std::max(this->Highest, point);
  }
  Index Size() const { return std::max<Index>(Index(this->Highest) - this->Lowest + 1, 0); }
};

/// Returns whether a hex at an active point has a demand other than 1.
bool AnyDemand(const ActiveMesh& mesh, int point)
{
  const auto begin = mesh.CornerList.begin();
  return std::any_of(begin + mesh.CornerOffset[point], begin + mesh.CornerOffset[point + 1],
    [&](CornerPosition at) { return mesh.DemandAt(at) != 1.0; });
}

} // namespace

/// Stores the points of all rings.
void HexRings::Block::Store(const std::vector<int>& points, int firstOfRim)
{
  Range moving, rim;
  for (int point : points)
  {
    (point < firstOfRim ? moving : rim).Add(point);
  }
  if (moving.Size() + rim.Size() > std::numeric_limits<std::uint16_t>::max())
  {
    this->Wide.assign(points.begin(), points.end()); // copied to drop spare capacity
    return;
  }
  const int size = static_cast<int>(moving.Size());
  this->Codes = { moving.Lowest, rim.Lowest - size, size };
  this->Narrow.reserve(points.size());
  for (int point : points)
  {
    const int shift = point < firstOfRim ? this->Codes.MovingShift : this->Codes.RimShift;
    this->Narrow.push_back(static_cast<std::uint16_t>(point - shift));
  }
}

/// Finds the rings of a block of points. Place::Hexes is the number of a list of the block.
class HexRings::Finder
{
public:
  Finder(const ActiveMesh& mesh, int firstOfRim, Block& block) :
    Mesh(mesh), FirstOfRim(firstOfRim), Result(block)
  {
  }

  std::vector<HexList> Find(int first, int last)
  {
    std::vector<int> points;
    this->Result.Places.reserve(last - first + 1);
    for (int p = first; p < last; ++p)
    {
      const std::uint32_t begin = static_cast<std::uint32_t>(points.size());
      this->FindRing(p);
      this->Result.Places.push_back(
        { begin, this->Numbers.Of(this->List), this->Near, AnyDemand(this->Mesh, p) });
      points.insert(points.end(), this->Ring.Points.begin(), this->Ring.Points.end());
    }
    this->Result.Places.push_back({ static_cast<std::uint32_t>(points.size()), 0, 0, false });
    this->Result.Store(points, this->FirstOfRim);
    return std::move(this->Numbers.Lists);
  }

private:
  void FindRing(int point)
  {
    const auto forHexes = [&](const auto& visit)
    {
      for (CornerPosition at = this->Mesh.CornerOffset[point];
           at < this->Mesh.CornerOffset[point + 1]; ++at)
      {
        const Index position = this->Mesh.CornerList[at];
        visit(this->Mesh.Elements.data() + (position & ~7), static_cast<int>(position & 7));
      }
    };
    this->Ring.Start(point);
    this->List.clear();
    forHexes(
      [&](const int* points, int corner)
      {
        Hex hex{};
        hex.IsExchanged = IsLeftHanded(corner);
        for (int n = 0; n < 6; ++n)
        {
          hex.Ends[n] = this->Ring.Of(points[corner ^ Ends[hex.IsExchanged][n]]);
        }
        this->List.push_back(hex);
      });
    this->Near = static_cast<std::uint16_t>(this->Ring.Points.size());
    forHexes([&](const int* points, int corner) { this->Ring.Of(points[corner ^ 7]); });
  }

  const ActiveMesh& Mesh;
  int FirstOfRim;
  Block& Result;
  RingNumbers Ring;
  std::uint16_t Near = 0; // points of the ring before the far corners
  HexList List;
  ListNumbers Numbers;
};

HexRings::HexRings(const ActiveMesh& mesh, Runtime& runtime)
{
  Index count = static_cast<Index>(mesh.CornerOffset.size()) - 1;
  while (count > 0 && mesh.CornerOffset[count - 1] == mesh.CornerOffset[count])
  {
    --count; // points of the rim
  }
  this->Blocks.resize((count + PointsOfBlock - 1) / PointsOfBlock);
  std::vector<std::vector<HexList>> lists(this->Blocks.size());
  ForEach(runtime, lists.size(),
    [&](Index b)
    {
      const Index first = b * PointsOfBlock, last = std::min(count, first + PointsOfBlock);
      Finder finder(mesh, static_cast<int>(count), this->Blocks[b]);
      lists[b] = finder.Find(static_cast<int>(first), static_cast<int>(last));
    });
  ListNumbers numbers;
  std::vector<std::uint32_t> begins; // first hex of each list
  for (std::size_t b = 0; b < lists.size(); ++b)
  {
    std::vector<std::uint32_t> beginOf;
    for (const HexList& list : lists[b])
    {
      const std::uint32_t number = numbers.Of(list);
      if (number == begins.size())
      {
        begins.push_back(static_cast<std::uint32_t>(this->Hexes.size()));
        this->Hexes.insert(this->Hexes.end(), list.begin(), list.end());
      }
      beginOf.push_back(begins[number]);
    }
    for (std::size_t p = 0; p + 1 < this->Blocks[b].Places.size(); ++p)
    {
      Place& place = this->Blocks[b].Places[p];
      place.Hexes = beginOf[place.Hexes];
    }
  }
}

void HexRings::UpdateDemands(const ActiveMesh& mesh)
{
  int point = 0;
  for (Block& block : this->Blocks)
  {
    for (std::size_t p = 0; p + 1 < block.Places.size(); ++p, ++point)
    {
      block.Places[p].HasDemands = AnyDemand(mesh, point);
    }
  }
}

} // namespace vfm
