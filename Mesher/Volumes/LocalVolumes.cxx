#include "Volumes/LocalVolumes.h"

#include "Base/Groups.h"
#include "Base/HexNumbering.h"
#include "Base/HexVolume.h"
#include "Base/PortableMath.h"
#include "Geometry/ElementParts.h"

#include <unordered_set>

namespace vfm
{
namespace
{

// Cells whose volumes count are this near to thin cells; elements may fill others by moving.
constexpr Index RegionLayers = 3;
constexpr double LargestShift = 0.2; // per correction, in mean cells
// Smallest area of the interfaces around a point by which its lack is divided, in mean cells.
constexpr double SmallestArea = 0.3;
// Along each axis, of the 4 cells around a node. The sum is that of the 3^3 cells around each of
// the 8 cells at the node.
constexpr int WeightAround[4] = { 1, 2, 2, 1 };
constexpr Index ElementsOfBlock = 256; // elements per task

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

LocalVolumes::LocalVolumes(const MeshCells& cells, const std::vector<Index>& thin, const Mesh& mesh,
  const ActiveMesh& active, const FragmentVolumes& volumes, const MeshRun& run) :
  Grid(cells.Grid),
  Parts(run.Parts),
  TheRuntime(run.TheRuntime),
  Region(cells.Grid.NumberOfEntries(), 0),
  Start(cells.Grid, cells.Fractions.NumberOfMaterials() + 1)
{
  this->MarkRegion(thin);
  this->MaterialOf.assign(volumes.Share().Size(), 0);
  for (std::size_t e = 0; e < mesh.Material.size(); ++e)
  {
    const int fragment = mesh.Fragment[e];
    this->MaterialOf[fragment] = fragment > 0 && !volumes.IsSmall(fragment) ? mesh.Material[e] : 0;
  }
  this->AddFractions(cells.Fractions, mesh);
  this->AddInactive(mesh, active);
  this->Start.Unite();
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
      hasElement.insert(this->Start.KeyOf(cell, mesh.Material[e]));
    }
  }
  const double unit = 1.0 / Cube(this->Grid.MeanWidth());
  const auto add = [&](const Index3& p, int material, double fraction)
  {
    bool isNear = false;
    ForCells(Grow(BoxOfCell(p), 1, this->Grid.Local()),
      [&](const Index3& q) {
        isNear = isNear || hasElement.count(this->Start.KeyOf(this->Grid.Linear(q), material)) > 0;
      });
    if (material > 0 && isNear)
    {
      const std::int64_t volume = CellVolumes::Rounded(unit * this->Grid.CellVolume(p) * fraction);
      this->Start.Add(this->Grid.Linear(p), material, { volume, volume, 0 });
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
      this->Elements.push_back({ activeOf[e], mesh.Material[e], cell });
      continue;
    }
    if (this->Region[this->Grid.Linear(cell)]) // it is the whole cell
    {
      const std::int64_t volume =
        CellVolumes::Rounded(this->Grid.CellVolume(cell) / Cube(this->Grid.MeanWidth()));
      this->Start.Add(this->Grid.Linear(cell), mesh.Material[e], { -volume, 0, 0 });
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
    const IndexBox around{ { { node[0] - 2, node[1] - 2, node[2] - 2 } },
      { { node[0] + 2, node[1] + 2, node[2] + 2 } } };
    ForCells(Intersect(around, this->Grid.Local()),
      [&](const Index3& cell) { isNear = isNear || this->Region[this->Grid.Linear(cell)] == 2; });
    this->NodeOf[p] = isNear ? this->Grid.Linear(node) : -1;
  }
}

/// Subtracts the hexes that move from the cells of the region that they fill.
void LocalVolumes::AddElements(const ActiveMesh& mesh, CellVolumes& volumes) const
{
  const double unit = 1.0 / Cube(this->Grid.MeanWidth());
  using Entries = std::vector<CellVolumes::Entry>;
  const auto add = [&](Index e, Entries& entries)
  {
    const auto& [active, material, near] = this->Elements[e];
    const std::array<Vector3, 8> corners = CornersOf(mesh, active);
    ForPartsOfHex(corners, VolumeOfHex(corners),
      [&, material = material, near = near](const Vector3& centre, double volume)
      {
        const Index3 cell = this->Grid.CellAt(centre, near);
        if (this->Grid.Local().Contains(cell) && this->Region[this->Grid.Linear(cell)])
        {
          const std::int64_t part = CellVolumes::Rounded(unit * volume);
          CellVolumes::Append(
            { volumes.KeyOf(this->Grid.Linear(cell), material), { -part, 0, 0 } }, entries);
        }
      });
  };
  volumes.Add(CollectItems<CellVolumes::Entry>(
    this->TheRuntime, this->Elements.size(), ElementsOfBlock, add));
}

/// Adds the areas of facets, except those that stay on a side of the domain.
void LocalVolumes::AddFacets(const ActiveMesh& mesh, CellVolumes& volumes) const
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
        volumes.Add(this->Grid.Linear(cell), material, { 0, 0, CellVolumes::Rounded(area) });
      }
    }
  }
}

/// Returns the shift outwards of the interfaces of a material that makes up for what it lacks.
double LocalVolumes::ShiftOf(const CellVolumes& volumes, Index node, int material) const
{
  std::int64_t lack = 0, area = 0;
  const Index3 p = this->Grid.Position(node);
  for (int j = 0; j < 4; ++j)
  {
    for (int k = 0; k < 4; ++k)
    {
      volumes.ForRow({ { p[0] - 2, p[1] + j - 2, p[2] + k - 2 } }, 4, material,
        [&](Index i, const CellVolumes::Amounts& amounts)
        {
          const int weight = WeightAround[i] * WeightAround[j] * WeightAround[k];
          lack += weight * amounts.Lack;
          area += weight * amounts.Area;
        });
    }
  }
  const std::int64_t smallest = CellVolumes::Rounded(8.0 * SmallestArea);
  return static_cast<double>(lack) / static_cast<double>(std::max(area, smallest));
}

CellVolumes LocalVolumes::Measure(const ActiveMesh& mesh) const
{
  CellVolumes volumes = this->Start;
  this->AddElements(mesh, volumes);
  this->AddFacets(mesh, volumes);
  volumes.Unite();
  volumes.Complete(this->Parts);
  return volumes;
}

std::vector<unsigned char> LocalVolumes::FindExcess(
  const CellVolumes& volumes, const ActiveMesh& mesh, double share) const
{
  std::vector<unsigned char> exceeds(this->CellOf.size(), 0);
  for (std::size_t e = 0; e < this->CellOf.size(); ++e)
  {
    const int material = this->CellOf[e] >= 0 ? this->MaterialOf[mesh.YieldingFragments[e]] : 0;
    if (material == 0)
    {
      continue;
    }
    std::int64_t lack = 0, filled = 0;
    const Index3 p = this->Grid.Position(this->CellOf[e]);
    for (int side = 0; side < 9; ++side)
    {
      volumes.ForRow({ { p[0] - 1, p[1] + side % 3 - 1, p[2] + side / 3 - 1 } }, 3, material,
        [&](Index, const CellVolumes::Amounts& amounts)
        {
          lack += amounts.Lack;
          filled += amounts.Filled;
        });
    }
    exceeds[e] = static_cast<double>(-lack) > share * static_cast<double>(filled);
  }
  return exceeds;
}

void LocalVolumes::ReplaceShifts(
  const CellVolumes& volumes, const ActiveMesh& mesh, std::vector<double>& shifts) const
{
  ForEach(this->TheRuntime, this->NodeOf.size(),
    [&](Index p)
    {
      for (Index i = mesh.AttachmentOffset[p];
           this->NodeOf[p] >= 0 && i < mesh.AttachmentOffset[p + 1]; ++i)
      {
        const auto& [first, second] = mesh.Attachments[i].Fragments;
        const int before = this->MaterialOf[first], behind = this->MaterialOf[second];
        if (before == 0 && behind == 0)
        {
          continue;
        }
        const double share = before > 0 && behind > 0 ? 0.5 : 1.0;
        const double shift = share *
          ((before > 0 ? this->ShiftOf(volumes, this->NodeOf[p], before) : 0.0) -
            (behind > 0 ? this->ShiftOf(volumes, this->NodeOf[p], behind) : 0.0));
        shifts[i] = std::clamp(shift, -LargestShift, LargestShift);
      }
    });
}

} // namespace vfm
