#include "Smoothing/HexRings.h"

#include "Smoothing/ActiveMesh.h"

#include <stdexcept>

namespace vfm
{
namespace
{

// HexRings::Hex::Ends of corner 0, also with the first two axes exchanged.
constexpr int Ends[2][6] = { { 1, 2, 4, 3, 6, 5 }, { 2, 1, 4, 3, 5, 6 } };

/// Numbers the points of one ring after another.
class RingNumbers
{
public:
  RingNumbers(std::size_t points, HexRings& rings) : Seen(points, -1), Number(points), Rings(rings)
  {
  }
  void Start(int center)
  {
    this->Center = center;
    this->First = static_cast<Index>(this->Rings.Points.size());
  }
  std::uint8_t Of(int point)
  {
    if (this->Seen[point] != this->Center)
    {
      const Index number = static_cast<Index>(this->Rings.Points.size()) - this->First;
      if (number >= HexRings::LargestRing)
      {
        throw std::logic_error("A point of a mesh has too many neighbours.");
      }
      this->Seen[point] = this->Center;
      this->Number[point] = static_cast<std::uint8_t>(number);
      this->Rings.Points.push_back(point);
    }
    return this->Number[point];
  }

private:
  std::vector<int> Seen; // the last center that a point was numbered for
  std::vector<std::uint8_t> Number;
  HexRings& Rings;
  int Center = -1;
  Index First = 0;
};

/// Whether the edges at a corner of a hex, along its axes, form a left-handed frame: an odd number of bits.
bool IsLeftHanded(int corner)
{
  return 0x96 >> corner & 1;
}

} // namespace

HexRings FindHexRings(const ActiveMesh& mesh)
{
  HexRings rings;
  const std::size_t count = mesh.CornerOffset.size() - 1;
  rings.Offset.reserve(2 * count + 1);
  rings.Offset.push_back(0);
  rings.Hexes.reserve(mesh.CornerList.size());
  RingNumbers numbers(mesh.X.size(), rings);
  const auto end = [&] { rings.Offset.push_back(static_cast<Index>(rings.Points.size())); };
  for (std::size_t p = 0; p < count; ++p)
  {
    const auto forHexes = [&](const auto& visit)
    {
      for (Index at = mesh.CornerOffset[p]; at < mesh.CornerOffset[p + 1]; ++at)
      {
        const Index position = mesh.CornerList[at];
        visit(mesh.Elements.data() + (position & ~7), static_cast<int>(position & 7));
      }
    };
    numbers.Start(static_cast<int>(p));
    forHexes(
      [&](const int* points, int corner)
      {
        HexRings::Hex hex{};
        hex.IsExchanged = IsLeftHanded(corner);
        for (int n = 0; n < 6; ++n)
        {
          hex.Ends[n] = numbers.Of(points[corner ^ Ends[hex.IsExchanged][n]]);
        }
        rings.Hexes.push_back(hex);
      });
    end();
    forHexes([&](const int* points, int corner) { numbers.Of(points[corner ^ 7]); });
    end();
  }
  return rings;
}

} // namespace vfm
