#include "Tet/TetFragments.h"

#include "Base/DisjointSets.h"
#include "Base/ExactSum.h"
#include "Base/Sorted.h"
#include "Base/Vector3.h"
#include "Mesh/LevelIds.h"

namespace vfm
{
namespace
{

bool IsCentrePoint(const Mesh& mesh, Index point)
{
  return IsCentre(mesh, mesh.PointIds[point]);
}

/// Whether the point is a node of the lattice inside a material: all tets at it are of one fragment.
bool IsAnchor(const TetTopology& topology, Index point)
{
  return topology.Positions[point] != PointPosition::OnInterface;
}

/// The first of a tet's points that are anchors; -1: it has none.
Index AnchorOf(const TetTopology& topology, Index tet)
{
  const Index* points = topology.Tets.Elements.data() + 4 * tet;
  const Index* anchor =
    std::find_if(points, points + 4, [&](Index p) { return IsAnchor(topology, p); });
  return anchor < points + 4 ? *anchor : -1;
}

/// Calls visit(cells, point) for the anchored centres that have tets: the cells of HexBox that the centre stands for. pieces: of
/// each point.
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
  const Index offset = OffsetOfPieces(ranks, static_cast<Index>(pieces.size()));
  const std::vector<int> fragments =
    NumberFragments(pieces, this->FindSame(topology, offset), offset, ranks, this->MaterialOf);
  mesh.Fragment = Buffer<int>(mesh.ElementIds.size());
  for (std::size_t t = 0; t < this->PieceOf.size(); ++t)
  {
    mesh.Fragment[t] = fragments[this->PieceOf[t]];
  }
  this->FindLocations(topology, fragments);
}

/// Tets are joined by the anchors that they share, and those that have none by faces. So the sets are of points, and of such tets behind them.
std::vector<Piece> TetFragments::FindPieces(const TetTopology& topology, const TetFaces& faces)
{
  const Mesh& mesh = topology.Tets;
  const Index tets = static_cast<Index>(mesh.ElementIds.size()),
              points = static_cast<Index>(mesh.PointIds.size());
  std::vector<Index> bare; // tets without anchors
  for (Index t = 0; t < tets; ++t)
  {
    if (AnchorOf(topology, t) < 0)
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
  std::vector<int> pieceOf(parent.size(), -1); // of the roots
  std::vector<Piece> pieces;
  this->PieceOf.reserve(tets);
  for (Index t = 0; t < tets; ++t)
  {
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

/// Pairs of pieces of different ranks that hold the same centre or, where a tet has none, the same tet.
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

/// Asks the owners of tets without an anchored centre for their pieces.
PiecePairs TetFragments::FindSameTets(const TetTopology& topology, Index offset) const
{
  const Mesh& mesh = topology.Tets;
  std::vector<std::vector<Index>> ids(this->Parts.Peers().size()), tets(ids.size());
  for (std::size_t t = 0; t < this->PieceOf.size(); ++t)
  {
    const Index* points = mesh.Elements.data() + 4 * t;
    const Index3 cell = CellOfElement(this->Grid, mesh, mesh.ElementIds[t]);
    if (!this->Parts.OwnsCell(cell) &&
      std::none_of(points, points + 4,
        [&](Index p) { return IsCentrePoint(mesh, p) && IsAnchor(topology, p); }))
    {
      const int peer = this->Parts.PeerOfCell(cell);
      ids[peer].push_back(mesh.ElementIds[t]);
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

/// fragments: of the pieces.
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
    if (!std::all_of(points, points + 4, [&](Index p) { return IsAnchor(topology, p); }))
    {
      this->AddLocations(mesh, static_cast<Index>(t));
    }
  }
  std::sort(this->Locations.begin(), this->Locations.end());
}

/// In the cells beside its face.
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

/// In the cell itself, else around the nearest centre.
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
      return fragment > 0 && this->MaterialOf[fragment] == material ? fragment : 0;
    });
}

} // namespace vfm
