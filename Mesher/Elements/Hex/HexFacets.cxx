#include "Elements/Hex/HexFacets.h"

#include "Base/Groups.h"
#include "Elements/GridCoordinates.h"
#include "Labels/InterfaceFaces.h"
#include "Octree/LevelIds.h"

namespace vfm
{
namespace
{

constexpr Index RowsOfBlock = 64, NodesOfBlock = 1024; // per task

/// Calls visit(hex, cell) for the coarse hexes with a cell in HexBox. The cell is the finest cell
/// in the hex that is nearest to the owned ones.
template <class Visitor>
void ForCoarseHexes(const HexTopology& topology, const Visitor& visit)
{
  const Mesh& mesh = topology.Hexes;
  const RefinedGrid& levels = *mesh.Levels;
  for (Index h = topology.RowOffset.back(); h < static_cast<Index>(mesh.ElementIds.size()); ++h)
  {
    const OctreeKeys::LevelIndex leaf =
      CellOfCoarseElement(levels, mesh.ElementIds[h], mesh.Ids.ElementSlots);
    const Index3 cell = levels.NearestCell(leaf.Level, leaf.At);
    if (levels.Finest().HexBox().Contains(cell)) // the others are needed only for smoothing
    {
      visit(h, cell);
    }
  }
}

/// Fills a row whose hexes are its meshed cells. Each point inside a fragment is the lowest corner
/// of one hex.
void FillRowOfCells(const CartesianGrid& grid, const PointNumbering& numbering,
  const Fragments& fragments, Index j, Index k, Index firstHex, Mesh& mesh)
{
  Index hex = firstHex;
  fragments.ForRuns(j, k,
    [&](Index begin, Index end, int fragment)
    {
      if (fragment > 0)
      {
        const Index point = numbering.FirstPoint(grid.Linear({ { begin, j, k } }));
        std::fill_n(mesh.Fragment.data() + hex, end - begin, fragment);
        std::fill_n(mesh.GeometryId.data() + point, end - begin, fragment);
        hex += end - begin;
      }
    });
}

/// @param hasAllCells  whether each point G inside a fragment is the lowest corner of a hex
void FillRow(const CartesianGrid& grid, const Fragments& fragments, Index j, Index k, Index first,
  Index last, bool hasAllCells, Mesh& mesh)
{
  const Index key = grid.CellKey({ { 0, j, k } });
  const int corners = hasAllCells ? 1 : 8;
  Index runEnd = -1;
  int fragment = 0;
  for (Index h = first; h < last; ++h)
  {
    const Index place = mesh.ElementIds[h] - 1;
    const Index i = place / HexIds.ElementSlots - key;
    if (i >= runEnd)
    {
      fragment = fragments.FragmentOfCell({ { i, j, k } }, runEnd);
    }
    mesh.Fragment[h] = fragment;
    if (place % HexIds.ElementSlots == 0) // only core hexes have a lowest corner of their own
    {
      const Index* points = mesh.Elements.data() + 8 * h;
      for (int c = 0; c < corners; ++c) // threads may write equal values at the same time
      {
        __atomic_store_n(&mesh.GeometryId[points[c]], fragment, __ATOMIC_RELAXED);
      }
    }
  }
}

/// Sets the fragments of the points I.
void FillInnerPoints(const LabelledGrid& labelled, const PointNumbering& numbering,
  const Fragments& fragments, Runtime& runtime, Mesh& mesh)
{
  const CartesianGrid& grid = mesh.Levels->Finest();
  const IndexBox box = grid.HexBox();
  ForEach(runtime, labelled.Mixed.size(),
    [&](Index n)
    {
      const Index node = labelled.Mixed[n];
      const Index3 p = grid.Position(node);
      // Nodes without a cell in the box have no numbers.
      const bool isSplit = box.Touches(p) && numbering.IsSplit(node);
      const std::array<int, 8> star = StarOfNode(grid, labelled.Labels, node);
      for (int c = 0; isSplit && c < 8; ++c)
      {
        const Index3 cell = CellOfStar(p, c);
        if (numbering.IsMeshed(star[c]) && box.Contains(cell))
        {
          mesh.GeometryId[numbering.InnerPoint(node, star[c])] = fragments.FragmentOfCell(cell);
        }
      }
    });
}

using Facets = std::vector<Facet>;

/// Finds the facets on sides of the domain.
class DomainFacets
{
public:
  DomainFacets(const Mesh& mesh, const BarrierElements& barrier, const Partition& partition) :
    Grid(mesh.Levels->Finest()), Parts(partition), Input(mesh), Barrier(barrier)
  {
  }

  /// Adds the facets of hexes `first` to `last` of a row of finest cells.
  void AddRow(Index j, Index k, Index first, Index last, Facets& found) const;
  /// Adds the facets of a coarse hex, which may have any orientation in its cell.
  void AddCoarse(Index hex, const Index3& cell, Facets& found) const;

private:
  void Add(Index hex, int face, int side, const Index3& cell, Facets& found) const;
  void AddFine(Index hex, int slot, const Index3& cell, Facets& found) const;

  const CartesianGrid& Grid;
  const Partition& Parts;
  const Mesh& Input;
  const BarrierElements Barrier;
};

void DomainFacets::Add(Index hex, int face, int side, const Index3& cell, Facets& found) const
{
  if (this->Barrier.Contain(this->Input, hex))
  {
    return;
  }
  Facet facet{ {}, { { this->Input.Material[hex], 0 } }, { { this->Input.Fragment[hex], 0 } }, side,
    this->Parts.OwnsCell(cell) };
  for (int c = 0; c < 4; ++c)
  {
    facet.Points[c] = this->Input.Elements[8 * hex + VtkCorner[FaceCorners[face][c]]];
  }
  found.push_back(facet);
}

/// Adds the facets of a hex of a finest cell. Faces of a buffer hex along its own axis are not on a
/// side.
/// @param slot  0: core hex; 1 + face: buffer hex
void DomainFacets::AddFine(Index hex, int slot, const Index3& cell, Facets& found) const
{
  for (int a = 0; a < 3; ++a)
  {
    if (slot > 0 && (slot - 1) / 2 == a)
    {
      continue;
    }
    if (cell[a] == 0)
    {
      this->Add(hex, 2 * a, 2 * a, cell, found);
    }
    if (cell[a] == this->Grid.Global().Upper[a] - 1)
    {
      this->Add(hex, 2 * a + 1, 2 * a + 1, cell, found);
    }
  }
}

void DomainFacets::AddRow(Index j, Index k, Index first, Index last, Facets& found) const
{
  const Index* ids = this->Input.ElementIds.data();
  const Index start = HexIds.ElementSlots * this->Grid.CellKey({ { 0, j, k } }) + 1;
  const Index3& n = this->Grid.Global().Upper;
  Index begin = last, end = last; // hexes between the first and the last cell
  if (j > 0 && k > 0 && j < n[1] - 1 && k < n[2] - 1)
  {
    begin = std::lower_bound(ids + first, ids + last, start + HexIds.ElementSlots) - ids;
    end = std::lower_bound(ids + begin, ids + last, start + HexIds.ElementSlots * (n[0] - 1)) - ids;
  }
  for (Index h = first; h < last; ++h)
  {
    if (h == begin)
    {
      h = end;
    }
    if (h < last)
    {
      const Index place = ids[h] - start;
      this->AddFine(h, static_cast<int>(place % HexIds.ElementSlots),
        { { place / HexIds.ElementSlots, j, k } }, found);
    }
  }
}

void DomainFacets::AddCoarse(Index hex, const Index3& cell, Facets& found) const
{
  std::array<int, 8> sides;
  for (int c = 0; c < 8; ++c)
  {
    const Index point = this->Input.Elements[8 * hex + VtkCorner[c]];
    sides[c] = FindDomainSides(this->Grid, this->Input.Points.data() + 3 * point);
  }
  for (int f = 0; f < 6; ++f)
  {
    const std::array<int, 4>& face = FaceCorners[f];
    const int common = sides[face[0]] & sides[face[1]] & sides[face[2]] & sides[face[3]];
    for (int side = 0; common != 0 && side < 6; ++side)
    {
      if (common >> side & 1)
      {
        this->Add(hex, f, side, cell, found);
      }
    }
  }
}

/// Finds the facets of interfaces.
class InterfaceFacets
{
public:
  InterfaceFacets(const RefinedGrid& levels, const PointNumbering& numbering,
    const Fragments& fragments, const Partition& partition) :
    Levels(levels), Numbering(numbering), Pieces(fragments), Parts(partition)
  {
  }

  /// Adds the facet of a face if a finest cell is on a side of it.
  void AddFine(
    const InterfaceFace& face, const Index3& lower, const Index3& upper, Facets& found) const;
  /// Adds the facet of a face between two coarse hexes.
  /// @param points  point of each split node, or -1
  void AddCoarse(
    const SplitNodes::InterfaceQuad& face, const std::vector<Index>& points, Facets& found) const;

private:
  const RefinedGrid& Levels;
  const PointNumbering& Numbering;
  const Fragments& Pieces;
  const Partition& Parts;
};

void InterfaceFacets::AddFine(
  const InterfaceFace& face, const Index3& lower, const Index3& upper, Facets& found) const
{
  if (!this->Levels.IsFine(lower) && !this->Levels.IsFine(upper))
  {
    return;
  }
  Facet facet{ {}, { { face.LowerLabel, face.UpperLabel } },
    { { this->Pieces.FragmentOfCell(lower), this->Pieces.FragmentOfCell(upper) } }, -1,
    this->Parts.OwnsCell(this->Numbering.IsMeshed(face.LowerLabel) ? lower : upper) };
  const std::array<Index, 4> nodes = NodesOfFace(this->Levels.Finest(), face);
  std::transform(nodes.begin(), nodes.end(), facet.Points.begin(),
    [this](Index node) { return this->Numbering.FirstPoint(node); });
  found.push_back(facet);
}

void InterfaceFacets::AddCoarse(
  const SplitNodes::InterfaceQuad& face, const std::vector<Index>& points, Facets& found) const
{
  const IndexBox box = this->Levels.Finest().HexBox();
  Facet facet{ {}, {}, {}, -1, false };
  for (int c = 0; c < 4; ++c)
  {
    facet.Points[c] = points[face.Nodes[c]];
    if (facet.Points[c] < 0)
    {
      return;
    }
  }
  for (int side = 0; side < 2; ++side)
  {
    const OctreeKeys::LevelIndex& leaf = face.Sides[side].Cell;
    const Index3 cell = this->Levels.NearestCell(leaf.Level, leaf.At);
    if (leaf.Level == this->Levels.NumberOfRefinements() || !box.Contains(cell))
    {
      return;
    }
    facet.Materials[side] = face.Sides[side].Label;
    facet.Fragments[side] = this->Pieces.FragmentOfCell(cell);
  }
  const int writer = this->Numbering.IsMeshed(facet.Materials[0]) ? 0 : 1;
  const OctreeKeys::LevelIndex& leaf = face.Sides[writer].Cell;
  facet.IsOwned = this->Parts.OwnsCell(this->Levels.FinestNode(leaf.Level, leaf.At));
  found.push_back(facet);
}

} // namespace

void FillFragments(const LabelledGrid& labelled, const PointNumbering& numbering,
  const Fragments& fragments, Runtime& runtime, HexTopology& topology)
{
  Mesh& mesh = topology.Hexes;
  const std::vector<Index>& rowOffset = topology.RowOffset;
  const CartesianGrid& grid = mesh.Levels->Finest();
  const bool areCells =
    mesh.Levels->IsUniform() && topology.WholeCells == static_cast<Index>(mesh.ElementIds.size());
  mesh.Fragment = Buffer<int>(mesh.ElementIds.size());
  std::fill(mesh.Fragment.begin() + rowOffset.back(), mesh.Fragment.end(), 0);
  mesh.GeometryId = Buffer<int>(mesh.PointIds.size());
  std::fill(mesh.GeometryId.begin(), mesh.GeometryId.end(), 0);
  ForRows(runtime, grid.HexBox(),
    [&](Index j, Index k, Index row)
    {
      const Index first = rowOffset[row], last = rowOffset[row + 1];
      if (areCells)
      {
        FillRowOfCells(grid, numbering, fragments, j, k, first, mesh);
        return;
      }
      FillRow(grid, fragments, j, k, first, last, topology.HasAllCells, mesh);
    });
  ForCoarseHexes(topology,
    [&](Index hex, const Index3& cell)
    {
      mesh.Fragment[hex] = fragments.FragmentOfCell(cell);
      std::for_each(mesh.Elements.data() + 8 * hex, mesh.Elements.data() + 8 * hex + 8,
        [&](Index point) { mesh.GeometryId[point] = mesh.Fragment[hex]; });
    });
  FillInnerPoints(labelled, numbering, fragments, runtime, mesh);
}

std::vector<Facet> FindHexFacets(const LabelledGrid& labelled, const PointNumbering& numbering,
  const Fragments& fragments, const Partition& partition, Runtime& runtime,
  const HexTopology& topology)
{
  const Mesh& mesh = topology.Hexes;
  const std::vector<Index>& rowOffset = topology.RowOffset;
  const RefinedGrid& levels = *labelled.Levels.Grid;
  const CoarseHexes& coarse = *labelled.Levels.Coarse;
  const IndexBox box = levels.Finest().HexBox();
  const DomainFacets onDomain(mesh, labelled.Barrier(), partition);
  const InterfaceFacets onInterfaces(levels, numbering, fragments, partition);
  std::vector<Facets> parts(4); // in their order
  const Index rowsPerLayer = box.Size(1);
  parts[0] = CollectItems<Facet>(runtime, rowOffset.size() - 1, RowsOfBlock,
    [&](Index row, Facets& found)
    {
      onDomain.AddRow(box.Lower[1] + row % rowsPerLayer, box.Lower[2] + row / rowsPerLayer,
        rowOffset[row], rowOffset[row + 1], found);
    });
  ForCoarseHexes(
    topology, [&](Index hex, const Index3& cell) { onDomain.AddCoarse(hex, cell, parts[1]); });
  parts[2] = CollectItems<Facet>(runtime, labelled.Mixed.size(), NodesOfBlock,
    [&](Index n, Facets& found)
    {
      ForFacesOfNode(levels.Finest(), labelled.Labels, labelled.Mixed[n], box,
        [&](const InterfaceFace& face, const Index3& lower, const Index3& upper)
        { onInterfaces.AddFine(face, lower, upper, found); });
    });
  for (const SplitNodes::InterfaceQuad& face : coarse.Splits().Faces)
  {
    onInterfaces.AddCoarse(face, coarse.SplitPoints(), parts[3]);
  }
  return Joined(parts);
}

} // namespace vfm
