#include "Volumes/TetFragments.h"

#include "Base/DisjointSets.h"
#include "Base/ExactSum.h"
#include "Base/Sorted.h"
#include "Base/Vector3.h"
#include "Octree/LevelIds.h"

namespace vfm
{
namespace
{

bool IsCentrePoint(const Mesh& mesh, Index point)
{
  return IsCentre(mesh, mesh.PointIds[point]);
}

/// Returns whether a point is a node of the lattice inside a material. All tets at an anchor belong
/// to one fragment.
bool IsAnchor(const TetTopology& topology, Index point)
{
  return topology.Positions[point] != PointPosition::OnInterface;
}

/// Returns the first anchor of a tet, or -1 if it has none.
Index AnchorOf(const TetTopology& topology, Index tet)
{
  const Index* points = topology.Tets.Elements.data() + 4 * tet;
  const Index* anchor =
    std::find_if(points, points + 4, [&](Index p) { return IsAnchor(topology, p); });
  return anchor < points + 4 ? *anchor : -1;
}

/// Calls visit(cells, point) for the centres that are anchors.
/// @param pieces  local component of each point, -1 if it is not an anchor
/// @param visit  gets the cells of HexBox in the cell of the centre
template <class Visitor>
void ForCentres(const TetTopology& topology, const CartesianGrid& grid,
  const std::vector<int>& pieces, const Visitor& visit)
{
  const Mesh& mesh = topology.Tets;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    const Index id = mesh.PointIds[p];
    if (pieces[p] < 0 || !IsCentre(mesh, id))
    {
      continue;
    }
    const Index3 cell = NodeOfPoint(grid, mesh, id);
    IndexBox cells = BoxOfCell(cell);
    if (IsCoarsePoint(*mesh.Levels, id, mesh.Ids.PointSlots))
    {
      const OctreeKeys::LevelIndex leaf = CellOfCoarseCentre(*mesh.Levels, id, mesh.Ids.PointSlots);
      cells = Intersect(mesh.Levels->FinestCells(leaf.Level, leaf.At), grid.HexBox());
    }
    visit(cells, p);
  }
}

} // namespace

TetFragments::TetFragments(TetTopology& topology, const TetFaces& faces, const CartesianGrid& grid,
  const Partition& partition) :
  Grid(grid), Parts(partition)
{
  Mesh& mesh = topology.Tets;
  const std::vector<Piece> pieces = this->FindPieces(topology, faces);
  Ranks& ranks = partition.Group();
  JoinedPieces joined =
    JoinPieces(pieces, this->FindSame(topology, OffsetOfRank(ranks)), partition.Peers(), ranks);
  this->Own = std::move(joined.Share);
  const std::vector<int>& fragments = joined.Fragments;
  mesh.Fragment = Buffer<int>(mesh.ElementIds.size());
  for (std::size_t t = 0; t < this->PieceOf.size(); ++t)
  {
    mesh.Fragment[t] = this->PieceOf[t] < 0 ? 0 : fragments[this->PieceOf[t]];
  }
  this->FindLocations(topology, fragments);
}

/// Joins tets that share an anchor, and joins tets without anchors by faces. The items of the
/// disjoint sets are all points, followed by the tets without anchors.
std::vector<Piece> TetFragments::FindPieces(const TetTopology& topology, const TetFaces& faces)
{
  const Mesh& mesh = topology.Tets;
  const Index tets = static_cast<Index>(mesh.ElementIds.size()),
              points = static_cast<Index>(mesh.PointIds.size());
  std::vector<Index> bare; // tets without an anchor
  for (Index t = 0; t < tets; ++t)
  {
    if (AnchorOf(topology, t) < 0 && !topology.Barrier.Contain(mesh, t))
    {
      bare.push_back(t);
    }
  }
  const auto itemOf = [&](Index t)
  {
    const Index anchor = AnchorOf(topology, t);
    return anchor >= 0 ? anchor : points + FindSorted(bare, t);
  };
  std::vector<Index> parent = MakeSets(points + bare.size());
  for (Index t = 0; t < tets; ++t)
  {
    if (topology.Barrier.Contain(mesh, t))
    {
      continue;
    }
    const Index* corners = mesh.Elements.data() + 4 * t;
    const Index anchor = AnchorOf(topology, t);
    for (int c = 0; c < 4; ++c)
    {
      if (corners[c] != anchor && IsAnchor(topology, corners[c]))
      {
        Join(parent, anchor, corners[c]);
      }
    }
  }
  for (const auto& pair : faces.Joined)
  {
    Join(parent, itemOf(pair[0]), itemOf(pair[1]));
  }
  std::vector<int> pieceOf(parent.size(), -1); // component of each root
  std::vector<Piece> pieces;
  this->PieceOf.reserve(tets);
  for (Index t = 0; t < tets; ++t)
  {
    if (topology.Barrier.Contain(mesh, t))
    {
      this->PieceOf.push_back(-1);
      continue;
    }
    int& piece = pieceOf[FindRoot(parent, itemOf(t))];
    if (piece < 0)
    {
      piece = static_cast<int>(pieces.size());
      pieces.push_back({ mesh.ElementIds[t], mesh.Material[t] });
    }
    this->PieceOf.push_back(piece);
  }
  this->PieceAt.resize(points);
  for (Index p = 0; p < points; ++p)
  {
    this->PieceAt[p] = IsAnchor(topology, p) ? pieceOf[FindRoot(parent, p)] : -1;
  }
  return pieces;
}

/// Returns the pairs of local components of different ranks that have the same centre, or the same
/// tet if it has no centre that is an anchor.
PiecePairs TetFragments::FindSame(const TetTopology& topology, Index offset) const
{
  PiecePairs same;
  if (this->Parts.Peers().empty())
  {
    return same;
  }
  PagedArray<Index> pieceOf(this->Grid, -1);
  ForCentres(topology, this->Grid, this->PieceAt,
    [&](const IndexBox& cells, std::size_t point)
    {
      this->Parts.ForRows(cells,
        [&](Index first, Index last) { pieceOf.Fill(first, last, offset + this->PieceAt[point]); });
    });
  const PagedArray<Index> mine = pieceOf;
  this->Parts.ExchangeCells(pieceOf,
    [&](Index cell)
    {
      if (mine[cell] >= 0)
      {
        same.push_back({ { mine[cell], pieceOf[cell] } });
      }
    });
  const PiecePairs tets = this->FindSameTets(topology, offset);
  same.insert(same.end(), tets.begin(), tets.end());
  SortUnique(same);
  return same;
}

/// Requests the local component of each tet without an anchored centre from its owner.
PiecePairs TetFragments::FindSameTets(const TetTopology& topology, Index offset) const
{
  const Mesh& mesh = topology.Tets;
  std::vector<std::vector<Index>> ids(this->Parts.Peers().size()), tets(ids.size());
  for (std::size_t t = 0; t < this->PieceOf.size(); ++t)
  {
    const Index* points = mesh.Elements.data() + 4 * t;
    const Index3 cell = CellOfElement(this->Grid, mesh, mesh.ElementIds[t]);
    if (this->PieceOf[t] >= 0 && !this->Parts.OwnsCell(cell) &&
      std::none_of(points, points + 4,
        [&](Index p) { return IsCentrePoint(mesh, p) && IsAnchor(topology, p); }))
    {
      const int peer = this->Parts.PeerOfCell(cell);
      ids[peer].push_back(
        mesh.ElementIds[t] - TetIds.ElementSlots * this->Parts.NodeKeyShift(peer));
      tets[peer].push_back(static_cast<Index>(t));
    }
  }
  const std::vector<std::vector<Index>> pieces = this->Parts.Query(
    ids, [&](Index id) { return offset + this->PieceOf[FindSorted(mesh.ElementIds, id)]; });
  PiecePairs same;
  for (std::size_t peer = 0; peer < pieces.size(); ++peer)
  {
    for (std::size_t i = 0; i < pieces[peer].size(); ++i)
    {
      same.push_back({ { offset + this->PieceOf[tets[peer][i]], pieces[peer][i] } });
    }
  }
  return same;
}

/// Finds the fragments in each cell.
/// @param fragments  fragment of each local component
void TetFragments::FindLocations(const TetTopology& topology, const std::vector<int>& fragments)
{
  const Mesh& mesh = topology.Tets;
  this->FragmentOfCentre = PagedArray<int>(this->Grid, 0);
  ForCentres(topology, this->Grid, this->PieceAt,
    [&](const IndexBox& cells, std::size_t point)
    {
      this->Parts.ForRows(cells,
        [&](Index first, Index last)
        { this->FragmentOfCentre.Fill(first, last, fragments[this->PieceAt[point]]); });
    });
  std::vector<int>().swap(this->PieceAt);
  for (std::size_t t = 0; t < mesh.ElementIds.size(); ++t)
  {
    const Index* points = mesh.Elements.data() + 4 * t;
    if (this->PieceOf[t] >= 0 &&
      !std::all_of(points, points + 4, [&](Index p) { return IsAnchor(topology, p); }))
    {
      this->AddLocations(mesh, static_cast<Index>(t));
    }
  }
  std::sort(this->Locations.begin(), this->Locations.end());
}

/// Adds the fragment of a tet to the cells on both sides of its face.
void TetFragments::AddLocations(const Mesh& mesh, Index tet)
{
  const Index id = mesh.ElementIds[tet] - 1;
  Index3 cell = this->Grid.NodeOfKey(id / TetIds.ElementSlots);
  for (int side = 0; side < 2; ++side, --cell[id % TetIds.ElementSlots / (4 * PiecesPerTet)])
  {
    if (this->Grid.InDomain(cell))
    {
      this->Locations.push_back(
        { this->Grid.Linear(cell), mesh.Material[tet], mesh.Fragment[tet] });
    }
  }
}

void TetFragments::ForRuns(Index j, Index k, const Body& body) const
{
  const IndexBox box = this->Grid.HexBox();
  const Index row = this->Grid.Linear({ { 0, j, k } });
  for (Index i = box.Lower[0], last = i; i < box.Upper[0]; i = last)
  {
    const int fragment = this->FragmentOfCentre[row + i];
    while (last < box.Upper[0] && this->FragmentOfCentre[row + last] == fragment)
    {
      ++last;
    }
    body(i, last, fragment);
  }
}

/// Searches the cell first, then the nearest centre of the material.
int TetFragments::FindNear(const Index3& cell, int material) const
{
  const auto location = std::lower_bound(this->Locations.begin(), this->Locations.end(),
    Location{ this->Grid.Linear(cell), material, 0 });
  if (location != this->Locations.end() && location->Cell == this->Grid.Linear(cell) &&
    location->Material == material)
  {
    return location->Fragment;
  }
  return FindNearestCell(this->Grid, cell,
    [&](const Index3& q)
    {
      const int fragment = this->FragmentOfCentre[this->Grid.Linear(q)];
      return fragment > 0 && this->Own.Materials[fragment] == material ? fragment : 0;
    });
}

} // namespace vfm
