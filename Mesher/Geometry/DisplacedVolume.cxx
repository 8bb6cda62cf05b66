#include "Geometry/DisplacedVolume.h"

#include "Base/ExactSum.h"
#include "Base/PortableMath.h"
#include "Base/Vector3.h"
#include "Elements/MeasureFragments.h"
#include "Ranks/AskRanks.h"

#include <unordered_map>

namespace vfm
{
namespace
{

/// The lack of a material in a block, as ExactSum::Parts, for another rank.
struct SentLack
{
  Index Key;
  ExactSum::PartArray Parts;
};

/// Part of an element.
struct ElementPart
{
  Vector3 Centre;
  double Volume;
};

/// Calls body for the 27 parts of a hexahedron with equal intervals of its coordinates. Their
/// volumes are those of their middles, scaled to the volume of the element.
template <class Body>
void ForPartsOfHex(const std::array<Vector3, 8>& x, double volume, const Body& body)
{
  std::array<ElementPart, 27> parts;
  double sum = 0.0;
  for (int n = 0; n < 27; ++n)
  {
    const Index3 step = StepAround(n);
    Vector3 t, centre{};
    std::array<Vector3, 3> derivatives{};
    for (int a = 0; a < 3; ++a)
    {
      t[a] = 0.5 + static_cast<double>(step[a]) / 3.0;
    }
    for (int c = 0; c < 8; ++c)
    {
      // VTK's order: corners 2 and 3, 6 and 7 are exchanged.
      const int bits = c ^ (c >> 1 & 1);
      std::array<double, 3> weight, sign;
      for (int a = 0; a < 3; ++a)
      {
        sign[a] = bits >> a & 1 ? 1.0 : -1.0;
        weight[a] = bits >> a & 1 ? t[a] : 1.0 - t[a];
      }
      centre = centre + weight[0] * weight[1] * weight[2] * x[c];
      for (int a = 0; a < 3; ++a)
      {
        derivatives[a] =
          derivatives[a] + sign[a] * weight[(a + 1) % 3] * weight[(a + 2) % 3] * x[c];
      }
    }
    parts[n] = { centre, Dot(derivatives[0], Cross(derivatives[1], derivatives[2])) };
    sum += parts[n].Volume;
  }
  for (const ElementPart& part : parts)
  {
    body(part.Centre, part.Volume / sum * volume);
  }
}

/// Calls body for the 8 parts of equal volume of a tetrahedron: 4 at corners, 4 of the octahedron
/// between them.
template <class Body>
void ForPartsOfTet(const std::array<Vector3, 8>& x, double volume, const Body& body)
{
  for (int c = 0; c < 4; ++c)
  {
    const Vector3 others = x[(c + 1) % 4] + x[(c + 2) % 4] + x[(c + 3) % 4];
    body(0.625 * x[c] + 0.125 * others, volume / 8.0);
    body(0.125 * x[c] + (0.875 / 3.0) * others, volume / 8.0);
  }
}

/// Volumes in the fractions minus those in elements, by block and material, in mean cells.
class BlockVolumes
{
public:
  BlockVolumes(const CartesianGrid& grid, const FractionField& fractions) :
    Grid(grid),
    Materials(fractions.NumberOfMaterials() + 1),
    Totals(this->Materials),
    Unit(1.0 / Cube(grid.MeanWidth()))
  {
    for (int a = 0; a < 3; ++a)
    {
      this->Blocks[a] = (grid.Domain().Size(a) + CellsOfBlock - 1) / CellsOfBlock;
    }
    ForCells(grid.Owned(),
      [&](const Index3& cell)
      {
        fractions.ForParts(grid.Linear(cell),
          [&](int material, double fraction)
          {
            const double volume = this->Unit * grid.CellVolume(cell) * fraction;
            this->Totals[material].Add(volume);
            this->Lack[this->KeyOf(cell, material)].Add(volume);
          });
      });
  }

  /// Adds elements, and far material in its cells.
  void AddMesh(const Mesh& mesh)
  {
    for (const FarMatter& far : mesh.Far)
    {
      ExactSum sum;
      sum.Add(this->Unit * far.Volume);
      this->Lack[this->KeyOf(this->Grid.CellOfKey(far.Cell), far.Material)].Subtract(sum);
    }
    for (Index e = 0; e < static_cast<Index>(mesh.Material.size()); ++e)
    {
      this->AddElement(mesh, e);
    }
  }

  /// Collective.
  std::vector<double> Finish(Ranks& ranks);

private:
  /// Returns the key of the block of a cell, or of its copy in the domain, and a material.
  Index KeyOf(const Index3& cell, int material) const
  {
    const Index3 inside = this->Grid.Canonical(this->Grid.Global().Nearest(cell));
    Index3 block;
    for (int a = 0; a < 3; ++a)
    {
      block[a] = (inside[a] - this->Grid.Domain().Lower[a]) / CellsOfBlock;
    }
    return ((block[2] * this->Blocks[1] + block[1]) * this->Blocks[0] + block[0]) *
      this->Materials +
      material;
  }

  /// Returns whether a box from a cell up to a point lies in one block.
  bool IsInOneBlock(const Index3& cell, const Vector3& upper) const
  {
    for (int a = 0; a < 3; ++a)
    {
      const Index first = this->Grid.Domain().Lower[a];
      const Index end = std::min(
        cell[a] - (cell[a] - first) % CellsOfBlock + CellsOfBlock, this->Grid.Domain().Upper[a]);
      if (cell[a] < first || cell[a] >= end || upper[a] > this->Grid.Coordinates(a)[end])
      {
        return false;
      }
    }
    return true;
  }

  void AddElement(const Mesh& mesh, Index e)
  {
    std::array<Vector3, 8> x;
    Vector3 lower = mesh.PointAt(mesh.Elements[mesh.Corners * e]), upper = lower;
    for (int c = 0; c < mesh.Corners; ++c)
    {
      x[c] = mesh.PointAt(mesh.Elements[mesh.Corners * e + c]);
      for (int a = 0; a < 3; ++a)
      {
        lower[a] = std::min(lower[a], x[c][a]);
        upper[a] = std::max(upper[a], x[c][a]);
      }
    }
    const int material = mesh.Material[e];
    const double volume = this->Unit * VolumeOfElement(mesh, e);
    const auto subtract = [&](const Vector3& point, double part)
    {
      ExactSum sum;
      sum.Add(part);
      this->Lack[this->KeyOf(this->Grid.CellAt(point), material)].Subtract(sum);
    };
    if (this->IsInOneBlock(this->Grid.CellAt(lower), upper))
    {
      subtract(lower, volume);
      return;
    }
    mesh.HasHexes() ? ForPartsOfHex(x, volume, subtract) : ForPartsOfTet(x, volume, subtract);
  }

  const CartesianGrid& Grid;
  const int Materials; // with void
  std::vector<ExactSum> Totals;
  const double Unit;
  Index3 Blocks; // number along each axis
  std::unordered_map<Index, ExactSum> Lack;
};

std::vector<double> BlockVolumes::Finish(Ranks& ranks)
{
  std::vector<SentLack> sent;
  for (const auto& [key, lack] : this->Lack)
  {
    sent.push_back({ key, lack.Parts() });
  }
  this->Lack.clear();
  const auto rankOf = [&](const SentLack& lack)
  { return static_cast<int>(lack.Key / this->Materials % ranks.Count()); };
  for (const Bytes& message : SendItems(sent, rankOf, ranks))
  {
    for (const SentLack& item : FromBytes<SentLack>(message))
    {
      ExactSum lack;
      lack.Set(item.Parts.data());
      this->Lack[item.Key].Add(lack);
    }
  }
  std::vector<ExactSum> lacking(this->Materials), exceeding(this->Materials);
  for (const auto& [key, lack] : this->Lack)
  {
    const double value = lack.Value();
    (value > 0.0 ? lacking : exceeding)[key % this->Materials].Add(std::abs(value));
  }
  const std::vector<double> lacks = SumOverRanks(lacking, ranks),
                            excesses = SumOverRanks(exceeding, ranks),
                            totals = SumOverRanks(this->Totals, ranks);
  std::vector<double> shares;
  for (int m = 0; m < this->Materials; ++m)
  {
    shares.push_back(totals[m] > 0.0 ? std::max(lacks[m], excesses[m]) / totals[m] : 0.0);
  }
  return shares;
}

} // namespace

std::vector<double> FindDisplacedVolumes(
  const CartesianGrid& grid, const FractionField& fractions, const Mesh& mesh, Ranks& ranks)
{
  BlockVolumes volumes(grid, fractions);
  volumes.AddMesh(mesh);
  return volumes.Finish(ranks);
}

} // namespace vfm
