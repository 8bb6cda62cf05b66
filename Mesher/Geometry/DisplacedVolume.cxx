#include "Geometry/DisplacedVolume.h"

#include "Base/HexVolume.h"
#include "Base/PortableMath.h"
#include "Base/Vector3.h"
#include "Elements/MeasureFragments.h"
#include "Geometry/ElementParts.h"
#include "Ranks/KeyMerge.h"

#include <cmath>
#include <functional>
#include <mutex>
#include <unordered_map>

namespace vfm
{
namespace
{

// Volumes are summed as integers, so sums do not depend on the order. Their unit, in mean cells.
constexpr double Quantum = 0x1p-40;
// Elements that leave a block by less, in block widths, count as inside.
constexpr double Slack = 0.05 / CellsOfBlock;
// Times that elements in several blocks are halved along each axis, before their parts are placed
// by 8 points.
constexpr int Divisions = 1;

/// Volumes in the fractions minus those in elements, by block and material.
class BlockVolumes
{
public:
  BlockVolumes(const CartesianGrid& grid, int materials) :
    Grid(grid),
    Materials(materials + 1),
    Totals(this->Materials, 0),
    Unit(1.0 / Cube(grid.MeanWidth()))
  {
    for (int a = 0; a < 3; ++a)
    {
      this->Blocks[a] = (grid.Domain().Size(a) + CellsOfBlock - 1) / CellsOfBlock;
    }
  }

  /// Adds row (j, k) of the owned cells.
  void AddRow(const FractionField& fractions, Index j, Index k)
  {
    const IndexBox& box = this->Grid.Owned();
    const Index row = this->Grid.Linear({ { 0, j, k } });
    fractions.Visit(
      row + box.Lower[0], row + box.Upper[0],
      [&](Index begin, Index end, int label)
      {
        for (Index i = begin - row; i < end - row;)
        {
          const Index next = std::min(this->EndOfBlock(0, i), end - row);
          this->AddCells({ { i, j, k } }, next, label);
          i = next;
        }
      },
      [&](Index begin, Index end)
      {
        for (Index cell = begin; cell < end; ++cell)
        {
          const Index3 p{ { cell - row, j, k } };
          this->Select(p);
          fractions.ForParts(cell,
            [&](int material, double fraction)
            { this->AddFraction(material, this->Rounded(this->Grid.CellVolume(p) * fraction)); });
        }
      });
  }

  /// Subtracts far material from its cell.
  void AddFar(const FarMatter& far)
  {
    this->Select(this->Grid.CellOfKey(far.Cell));
    this->AddLack(far.Material, -this->Rounded(far.Volume));
  }

  void AddElement(const Mesh& mesh, Index e)
  {
    std::array<Vector3, 8> x;
    for (int c = 0; c < mesh.Corners; ++c)
    {
      x[c] = mesh.PointAt(mesh.Elements[mesh.Corners * e + c]);
    }
    this->AddPart(x, mesh.Corners, mesh.Material[e], VolumeOfElement(mesh, e), Divisions);
  }

  void Add(const BlockVolumes& other)
  {
    for (const auto& [key, volume] : other.Lack)
    {
      this->Lack[key] += volume;
    }
    std::transform(this->Totals.begin(), this->Totals.end(), other.Totals.begin(),
      this->Totals.begin(), std::plus<>());
  }

  /// Collective.
  std::vector<double> Finish(Ranks& ranks);

private:
  std::int64_t Rounded(double volume) const { return std::llround(volume * this->Unit / Quantum); }
  /// Returns the first cell along an axis after the block of a cell.
  Index EndOfBlock(int axis, Index i) const
  {
    const Index lower = this->Grid.Domain().Lower[axis], upper = this->Grid.Domain().Upper[axis];
    return i < lower ? lower : std::min(i - (i - lower) % CellsOfBlock + CellsOfBlock, upper);
  }

  /// Selects the block of a cell, or of its copy in the domain.
  void Select(const Index3& at)
  {
    const Index3 cell = this->Grid.Global().Nearest(at), inside = this->Grid.Canonical(cell);
    Index3 block;
    for (int a = 0; a < 3; ++a)
    {
      const std::vector<double>& x = this->Grid.Coordinates(a);
      const Index first = this->Grid.Domain().Lower[a];
      block[a] = (inside[a] - first) / CellsOfBlock;
      // Copies of adjacent cells outside of the domain can be in different blocks.
      const bool isOutside = cell[a] < first || cell[a] >= this->Grid.Domain().Upper[a];
      this->Lower[a] = x[isOutside ? cell[a] : cell[a] - (cell[a] - first) % CellsOfBlock];
      this->Upper[a] = x[isOutside ? cell[a] + 1 : this->EndOfBlock(a, cell[a])];
    }
    this->Block = (block[2] * this->Blocks[1] + block[1]) * this->Blocks[0] + block[0];
  }

  /// Returns whether a point is in the selected block, or closer to it than slack, in block widths.
  bool HasSelected(const Vector3& x, double slack) const
  {
    bool isInside = true;
    for (int a = 0; a < 3; ++a)
    {
      const double margin = slack * (this->Upper[a] - this->Lower[a]);
      isInside = isInside & (x[a] >= this->Lower[a] - margin) & (x[a] < this->Upper[a] + margin);
    }
    return isInside;
  }
  /// Selects the block of a point.
  void SelectAt(const Vector3& x)
  {
    if (!this->HasSelected(x, 0.0))
    {
      this->Select(this->Grid.CellAt(x));
    }
  }

  /// Subtracts an element or a part of it.
  void AddPart(
    const std::array<Vector3, 8>& x, int corners, int material, double volume, int divisions)
  {
    Vector3 lower = x[0], upper = lower;
    for (int c = 1; c < corners; ++c)
    {
      for (int a = 0; a < 3; ++a)
      {
        lower[a] = std::min(lower[a], x[c][a]);
        upper[a] = std::max(upper[a], x[c][a]);
      }
    }
    this->SelectAt(0.5 * (lower + upper));
    if (this->HasSelected(lower, Slack) && this->HasSelected(upper, Slack))
    {
      this->AddLack(material, -this->Rounded(volume));
      return;
    }
    if (divisions == 0)
    {
      const auto subtract = [&](const Vector3& point, double share)
      {
        this->SelectAt(point);
        this->AddLack(material, -this->Rounded(share));
      };
      corners == 8 ? ForPartsOfHex(x, volume, subtract) : ForPartsOfTet(x, volume, subtract);
      return;
    }
    for (const std::array<Vector3, 8>& part : corners == 8 ? DivideHex(x) : DivideTet(x))
    {
      this->AddPart(
        part, corners, material, corners == 8 ? VolumeOfHex(part) : volume / 8.0, divisions - 1);
    }
  }

  /// Adds pure cells along x, which lie in one block.
  void AddCells(Index3 cell, Index end, int label)
  {
    this->Select(cell);
    std::int64_t volume = 0;
    for (; cell[0] < end; ++cell[0])
    {
      volume += this->Rounded(this->Grid.CellVolume(cell));
    }
    this->AddFraction(label, volume);
  }
  void AddFraction(int material, std::int64_t volume)
  {
    this->Totals[material] += volume;
    this->AddLack(material, volume);
  }
  /// Adds to the lack of the selected block.
  void AddLack(int material, std::int64_t volume)
  {
    const Index key = this->Block * this->Materials + material;
    if (key != this->LastKey)
    {
      this->LastKey = key;
      this->LastLack = &this->Lack[key];
    }
    *this->LastLack += volume;
  }

  const CartesianGrid& Grid;
  const int Materials;              // with void
  std::vector<std::int64_t> Totals; // in the fractions, of each material
  const double Unit;                // inverse volume of a mean cell
  Index3 Blocks;                    // number along each axis
  Index Block = 0;                  // selected
  Vector3 Lower{}, Upper{};         // corners of the selected block
  std::unordered_map<Index, std::int64_t> Lack;
  Index LastKey = -1; // the last item of Lack that was used
  std::int64_t* LastLack = nullptr;
};

std::vector<double> BlockVolumes::Finish(Ranks& ranks)
{
  std::vector<Index> keys;
  for (const auto& entry : this->Lack)
  {
    keys.push_back(entry.first);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::int64_t> volumes;
  for (Index key : keys)
  {
    volumes.push_back(this->Lack.at(key));
  }
  const KeyMerge<Index> ways(std::move(keys), ranks);
  volumes = ways.ToHome(std::move(volumes), 1, [](std::int64_t& a, std::int64_t b) { a += b; });
  // Sums of what blocks lack, of what they have too much, and of the fractions.
  std::vector<std::int64_t> sums(3 * this->Materials, 0);
  for (std::size_t k = 0; k < volumes.size(); ++k)
  {
    const Index material = ways.HomeKeys()[k] % this->Materials;
    sums[(volumes[k] > 0 ? 0 : this->Materials) + material] += std::abs(volumes[k]);
  }
  std::copy(this->Totals.begin(), this->Totals.end(), sums.begin() + 2 * this->Materials);
  ranks.Sum(sums);
  std::vector<double> shares;
  for (int m = 0; m < this->Materials; ++m)
  {
    const auto total = static_cast<double>(sums[2 * this->Materials + m]);
    const std::int64_t displaced = std::max(sums[m], sums[this->Materials + m]);
    shares.push_back(total > 0.0 ? static_cast<double>(displaced) / total : 0.0);
  }
  return shares;
}

} // namespace

std::vector<double> FindDisplacedVolumes(
  const CartesianGrid& grid, const FractionField& fractions, const Mesh& mesh, Runtime& runtime)
{
  const IndexBox& owned = grid.Owned();
  const Index rows = owned.NumberOfCells() > 0 ? owned.Size(1) * owned.Size(2) : 0;
  BlockVolumes all(grid, fractions.NumberOfMaterials());
  std::mutex lock;
  const auto add = [&](Index count, const auto& addItem)
  {
    runtime.For(0, count,
      [&](Index first, Index last)
      {
        BlockVolumes own(grid, fractions.NumberOfMaterials());
        for (Index i = first; i < last; ++i)
        {
          addItem(own, i);
        }
        const std::lock_guard<std::mutex> guard(lock);
        all.Add(own);
      });
  };
  add(rows,
    [&](BlockVolumes& own, Index row)
    {
      own.AddRow(
        fractions, owned.Lower[1] + row % owned.Size(1), owned.Lower[2] + row / owned.Size(1));
    });
  add(static_cast<Index>(mesh.Material.size()),
    [&](BlockVolumes& own, Index e) { own.AddElement(mesh, e); });
  for (const FarMatter& far : mesh.Far)
  {
    all.AddFar(far);
  }
  return all.Finish(runtime.Group());
}

} // namespace vfm
