#include "Volumes/LocalVolumes.h"

#include "Base/HexNumbering.h"
#include "Base/HexVolume.h"
#include "Base/PortableMath.h"
#include "Geometry/ElementParts.h"

#include <unordered_set>

namespace vfm
{
namespace
{

constexpr double Quantum = 0x1p-40; // unit of volumes and areas, of a mean cell
// Cells whose volumes count are this near to thin cells; elements may fill others by moving.
constexpr Index RegionLayers = 3;
constexpr double LargestShift = 0.2; // per correction, in mean cells
// Smallest area of the interfaces around a point by which its lack is divided, in mean cells.
constexpr double SmallestArea = 0.3;

std::int64_t Rounded(double value)
{
  return std::llround(value / Quantum);
}

/// Calls visit(cell, weight) for the 4^3 cells around a node. Along each axis, the weights of the
/// two inner cells are 2: the sum is that of the 3^3 cells around each of the 8 cells at the node.
template <class Visit>
void ForCellsAround(const CartesianGrid& grid, const Index3& node, const Visit& visit)
{
  const IndexBox around{ { { node[0] - 2, node[1] - 2, node[2] - 2 } },
    { { node[0] + 2, node[1] + 2, node[2] + 2 } } };
  ForCells(around,
    [&](const Index3& cell)
    {
      if (grid.Local().Contains(cell))
      {
        int weight = 1;
        for (int a = 0; a < 3; ++a)
        {
          weight *= cell[a] == node[a] || cell[a] == node[a] - 1 ? 2 : 1;
        }
        visit(grid.Linear(cell), weight);
      }
    });
}

/// Returns the corners of an active hex, in VTK's order and length units.
std::array<Vector3, 8> CornersOf(const ActiveMesh& mesh, int hex)
{
  std::array<Vector3, 8> x;
  for (int c = 0; c < 8; ++c)
  {
    x[VtkCorner[c]] = mesh.Origin + mesh.Scale * mesh.X[mesh.Elements[8 * hex + c]];
  }
  return x;
}

} // namespace

struct LocalVolumes::Item
{
  Index Cell; // its key, or its number in a box
  Amounts Values;
  int Material;
};

LocalVolumes::LocalVolumes(const MeshCells& cells, const std::vector<Index>& thin, const Mesh& mesh,
  const ActiveMesh& active, const FragmentVolumes& volumes, const MeshRun& run) :
  Grid(cells.Grid),
  Parts(run.Parts),
  Materials(cells.Fractions.NumberOfMaterials() + 1),
  Region(cells.Grid.NumberOfEntries(), 0)
{
  this->MarkRegion(thin);
  this->MaterialOf.assign(volumes.FragmentTargets().size(), 0);
  for (std::size_t e = 0; e < mesh.Material.size(); ++e)
  {
    const int fragment = mesh.Fragment[e];
    this->MaterialOf[fragment] = fragment > 0 && !volumes.IsSmall(fragment) ? mesh.Material[e] : 0;
  }
  this->AddFractions(cells.Fractions, mesh);
  this->AddInactive(mesh, active);
  this->ListPoints(mesh, active);
}

/// Marks thin cells with 2, the cells near them with 1.
void LocalVolumes::MarkRegion(const std::vector<Index>& thin)
{
  for (Index cell : thin)
  {
    ForCells(Grow(BoxOfCell(this->Grid.Position(cell)), RegionLayers, this->Grid.Local()),
      [&](const Index3& q) { this->Region[this->Grid.Linear(q)] = 1; });
  }
  for (Index cell : thin)
  {
    this->Region[cell] = 2;
  }
}

/// Adds the fractions of owned cells, except those without an element of their material around.
void LocalVolumes::AddFractions(const FractionField& fractions, const Mesh& mesh)
{
  std::unordered_set<Index> hasElement;
  for (std::size_t e = 0; e < mesh.Material.size(); ++e)
  {
    const Index cell = this->Grid.Linear(CellOfElement(this->Grid, mesh, mesh.ElementIds[e]));
    if (this->Region[cell] && mesh.Material[e] > 0)
    {
      hasElement.insert(this->KeyOf(cell, mesh.Material[e]));
    }
  }
  const double unit = 1.0 / Cube(this->Grid.MeanWidth());
  const auto add = [&](const Index3& p, int material, double fraction)
  {
    bool isNear = false;
    ForCells(Grow(BoxOfCell(p), 1, this->Grid.Local()),
      [&](const Index3& q)
      { isNear = isNear || hasElement.count(this->KeyOf(this->Grid.Linear(q), material)) > 0; });
    if (material > 0 && isNear)
    {
      const std::int64_t volume = Rounded(unit * this->Grid.CellVolume(p) * fraction);
      this->Start[this->KeyOf(this->Grid.Linear(p), material)] = { volume, volume, 0 };
    }
  };
  ForCells(this->Grid.Owned(),
    [&](const Index3& p)
    {
      const Index cell = this->Grid.Linear(p);
      if (this->Region[cell])
      {
        fractions.ForParts(
          cell, [&](int material, double fraction) { add(p, material, fraction); });
      }
    });
}

/// Subtracts the owned hexes that do not move, and lists those that move.
void LocalVolumes::AddInactive(const Mesh& mesh, const ActiveMesh& active)
{
  std::vector<int> activeOf(mesh.Material.size(), -1);
  for (std::size_t a = 0; a < active.MeshElement.size(); ++a)
  {
    const Index element = active.MeshElement[a];
    activeOf[element] = static_cast<int>(a);
    const Index cell = this->Grid.Linear(CellOfElement(this->Grid, mesh, mesh.ElementIds[element]));
    bool isNear = false;
    ForCells(Grow(BoxOfCell(this->Grid.Position(cell)), 1, this->Grid.Local()),
      [&](const Index3& q) { isNear = isNear || this->Region[this->Grid.Linear(q)] == 2; });
    this->CellOf.push_back(isNear ? cell : -1);
  }
  for (std::size_t e = 0; e < mesh.Material.size(); ++e)
  {
    const Index3 cell = CellOfElement(this->Grid, mesh, mesh.ElementIds[e]);
    bool counts = false;
    ForCells(Grow(BoxOfCell(cell), 1, this->Grid.Local()),
      [&](const Index3& q) { counts = counts || this->Region[this->Grid.Linear(q)]; });
    if (!counts || mesh.Fragment[e] == 0 || mesh.Material[e] == 0 || !this->Parts.OwnsCell(cell))
    {
      continue;
    }
    if (activeOf[e] >= 0)
    {
      this->Elements.push_back({ activeOf[e], mesh.Material[e] });
      continue;
    }
    if (this->Region[this->Grid.Linear(cell)]) // it is the whole cell
    {
      this->Start[this->KeyOf(this->Grid.Linear(cell), mesh.Material[e])].Lack -=
        Rounded(this->Grid.CellVolume(cell) / Cube(this->Grid.MeanWidth()));
    }
  }
}

void LocalVolumes::ListPoints(const Mesh& mesh, const ActiveMesh& active)
{
  this->NodeOf.assign(active.X.size(), -1);
  for (std::size_t p = 0; p < active.X.size(); ++p)
  {
    const Index3 node = NodeOfPoint(this->Grid, mesh, mesh.PointIds[active.MeshPoint[p]]);
    bool isNear = false;
    ForCellsAround(
      this->Grid, node, [&](Index cell, int) { isNear = isNear || this->Region[cell] == 2; });
    this->NodeOf[p] = isNear ? this->Grid.Linear(node) : -1;
  }
}

/// Subtracts the hexes that move from the cells of the region that they fill.
void LocalVolumes::AddElements(const ActiveMesh& mesh, Sums& sums) const
{
  const double unit = 1.0 / Cube(this->Grid.MeanWidth());
  for (const Element& element : this->Elements)
  {
    const std::array<Vector3, 8> corners = CornersOf(mesh, element.Active);
    ForPartsOfHex(corners, VolumeOfHex(corners),
      [&](const Vector3& centre, double volume)
      {
        const Index3 cell = this->Grid.CellAt(centre);
        if (this->Grid.Local().Contains(cell) && this->Region[this->Grid.Linear(cell)])
        {
          sums[this->KeyOf(this->Grid.Linear(cell), element.Material)].Lack -=
            Rounded(unit * volume);
        }
      });
  }
}

/// Adds the areas of facets, except those that stay on a side of the domain.
void LocalVolumes::AddFacets(const ActiveMesh& mesh, Sums& sums) const
{
  for (const ActiveFacet& facet : mesh.Facets)
  {
    const auto& [p, q, r, s] = facet.Points;
    const Vector3 centre = 0.25 * (mesh.X[p] + mesh.X[q] + mesh.X[r] + mesh.X[s]);
    const Index3 cell = this->Grid.CellAt(mesh.Origin + mesh.Scale * centre);
    const bool isOnSide = (mesh.Fixed[p] & mesh.Fixed[q] & mesh.Fixed[r] & mesh.Fixed[s]) != 0;
    if (isOnSide || !this->Grid.Local().Contains(cell) || !this->Region[this->Grid.Linear(cell)])
    {
      continue;
    }
    const double area = 0.5 * Norm(Cross(mesh.X[r] - mesh.X[p], mesh.X[s] - mesh.X[q]));
    for (int fragment : facet.Fragments)
    {
      const int material = fragment > 0 ? this->MaterialOf[fragment] : 0;
      if (material > 0)
      {
        sums[this->KeyOf(this->Grid.Linear(cell), material)].Area += Rounded(area);
      }
    }
  }
}

/// Adds the sums of other ranks, so that those of all cells of the region are complete.
void LocalVolumes::Complete(Sums& sums) const
{
  if (!this->Parts.Peers().empty())
  {
    this->SendToOwners(sums);
    this->SendToGhosts(sums);
  }
}

void LocalVolumes::SendToOwners(Sums& sums) const
{
  std::vector<std::vector<Item>> sent(this->Parts.Peers().size());
  for (auto at = sums.begin(); at != sums.end();)
  {
    const auto& [key, amounts] = *at;
    const Index3 cell = this->Grid.Position(key / this->Materials);
    if (this->Parts.OwnsCell(cell))
    {
      ++at;
      continue;
    }
    const int peer = this->Parts.PeerOfCell(cell);
    sent[peer].push_back(
      { this->Parts.CellKeyAtPeer(peer, cell), amounts, static_cast<int>(key % this->Materials) });
    at = sums.erase(at);
  }
  for (const std::vector<Item>& items : this->Parts.Exchange(sent))
  {
    for (const Item& item : items)
    {
      const Index cell = this->Grid.Linear(this->Grid.CellOfKey(item.Cell));
      Amounts& amounts = sums[this->KeyOf(cell, item.Material)];
      amounts.Lack += item.Values.Lack;
      amounts.Filled += item.Values.Filled;
      amounts.Area += item.Values.Area;
    }
  }
}

void LocalVolumes::SendToGhosts(Sums& sums) const
{
  this->Parts.ExchangeBoxes(
    [&](const IndexBox& box)
    {
      std::vector<Item> items;
      Index number = 0;
      this->Parts.ForCells(box,
        [&](Index cell)
        {
          for (int m = 1; m < this->Materials && this->Region[cell]; ++m)
          {
            const auto at = sums.find(this->KeyOf(cell, m));
            if (at != sums.end())
            {
              items.push_back({ number, at->second, m });
            }
          }
          ++number;
        });
      return ToBytes(items);
    },
    [&](const IndexBox& box, const Bytes& bytes)
    {
      const std::vector<Item> items = FromBytes<Item>(bytes);
      auto next = items.begin();
      Index number = 0;
      this->Parts.ForCells(box,
        [&](Index cell)
        {
          for (; next != items.end() && next->Cell == number; ++next)
          {
            sums[this->KeyOf(cell, next->Material)] = next->Values;
          }
          ++number;
        });
    });
}

/// Returns the shift outwards of the interfaces of a material that makes up for what it lacks.
double LocalVolumes::ShiftOf(const Sums& sums, Index node, int material) const
{
  std::int64_t lack = 0, area = 0;
  ForCellsAround(this->Grid, this->Grid.Position(node),
    [&](Index cell, int weight)
    {
      const auto at = sums.find(this->KeyOf(cell, material));
      if (at != sums.end())
      {
        lack += weight * at->second.Lack;
        area += weight * at->second.Area;
      }
    });
  const std::int64_t smallest = Rounded(8.0 * SmallestArea);
  return static_cast<double>(lack) / static_cast<double>(std::max(area, smallest));
}

/// Returns the sums at the present positions, complete in the region.
LocalVolumes::Sums LocalVolumes::Measure(const ActiveMesh& mesh) const
{
  Sums sums = this->Start;
  this->AddElements(mesh, sums);
  this->AddFacets(mesh, sums);
  this->Complete(sums);
  return sums;
}

std::vector<unsigned char> LocalVolumes::FindExcess(const ActiveMesh& mesh, double share) const
{
  const Sums sums = this->Measure(mesh);
  std::vector<unsigned char> exceeds(this->CellOf.size(), 0);
  for (std::size_t e = 0; e < this->CellOf.size(); ++e)
  {
    const int material = this->CellOf[e] >= 0 ? this->MaterialOf[mesh.YieldingFragments[e]] : 0;
    if (material == 0)
    {
      continue;
    }
    std::int64_t lack = 0, filled = 0;
    ForCells(Grow(BoxOfCell(this->Grid.Position(this->CellOf[e])), 1, this->Grid.Local()),
      [&](const Index3& q)
      {
        const auto at = sums.find(this->KeyOf(this->Grid.Linear(q), material));
        if (at != sums.end())
        {
          lack += at->second.Lack;
          filled += at->second.Filled;
        }
      });
    exceeds[e] = static_cast<double>(-lack) > share * static_cast<double>(filled);
  }
  return exceeds;
}

void LocalVolumes::ReplaceShifts(const ActiveMesh& mesh, std::vector<double>& shifts) const
{
  const Sums sums = this->Measure(mesh);
  for (std::size_t p = 0; p < this->NodeOf.size() && p + 1 < mesh.AttachmentOffset.size(); ++p)
  {
    if (this->NodeOf[p] < 0)
    {
      continue;
    }
    for (Index i = mesh.AttachmentOffset[p]; i < mesh.AttachmentOffset[p + 1]; ++i)
    {
      const auto& [first, second] = mesh.Attachments[i].Fragments;
      const int before = this->MaterialOf[first], behind = this->MaterialOf[second];
      if (before == 0 && behind == 0)
      {
        continue;
      }
      const double share = before > 0 && behind > 0 ? 0.5 : 1.0;
      const double shift = share *
        ((before > 0 ? this->ShiftOf(sums, this->NodeOf[p], before) : 0.0) -
          (behind > 0 ? this->ShiftOf(sums, this->NodeOf[p], behind) : 0.0));
      shifts[i] = std::clamp(shift, -LargestShift, LargestShift);
    }
  }
}

} // namespace vfm
