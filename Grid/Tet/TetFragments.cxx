#include "Tet/TetFragments.h"

#include "Base/DisjointSets.h"
#include "Base/ExactSum.h"
#include "Base/Sorted.h"
#include "Base/Vector3.h"
#include "Octree/RefinedGrid.h"

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

/// Calls visit(cells, tet) for the anchored centres: the cells of HexBox that the centre stands for, and a tet at it.
template <class Visitor>
void ForCentres(const TetTopology& topology, const CartesianGrid& grid, const Visitor& visit)
{
  const Mesh& mesh = topology.Tets;
  std::vector<Index> tetOf(mesh.PointIds.size(), -1);
  for (std::size_t at = 0; at < mesh.Elements.size(); ++at)
  {
    tetOf[mesh.Elements[at]] = static_cast<Index>(at / 4);
  }
  for (std::size_t p = 0; p < tetOf.size(); ++p)
  {
    const Index id = mesh.PointIds[p];
    if (tetOf[p] < 0 || !IsCentre(mesh, id) || !IsAnchor(topology, static_cast<Index>(p)))
    {
      continue;
    }
    const Index3 cell = NodeOfPoint(grid, mesh, id);
    IndexBox cells = BoxOfCell(cell);
    if (mesh.Levels->IsCoarsePoint(id, mesh.Ids.PointSlots))
    {
      const OctreeKeys::LevelIndex leaf = mesh.Levels->CellOfCoarseCentre(id, mesh.Ids.PointSlots);
      cells = Intersect(mesh.Levels->FinestCells(leaf.Level, leaf.At), grid.HexBox());
    }
    visit(cells, tetOf[p]);
  }
}

} // namespace

TetFragments::TetFragments(TetTopology& topology, const TetFaces& faces, const CartesianGrid& grid,
  const Partition& partition) :
  Grid(grid), Parts(partition)
{
  Mesh& mesh = topology.Tets;
  const std::vector<Piece> pieces = this->FindPieces(mesh, this->JoinTets(topology, faces));
  Ranks& ranks = partition.Group();
  const Index offset = OffsetOfPieces(ranks, static_cast<Index>(pieces.size()));
  const std::vector<int> fragments =
    NumberFragments(pieces, this->FindSame(topology, offset), offset, ranks, this->MaterialOf);
  mesh.Fragment = Buffer<int>(mesh.ElementIds.size());
  for (std::size_t t = 0; t < this->PieceOf.size(); ++t)
  {
    mesh.Fragment[t] = fragments[this->PieceOf[t]];
  }
  this->FindLocations(topology);
}

/// The forest of tets: joined by the anchors that they share, else by faces.
std::vector<Index> TetFragments::JoinTets(const TetTopology& topology, const TetFaces& faces) const
{
  const Mesh& mesh = topology.Tets;
  std::vector<Index> parent = MakeSets(mesh.ElementIds.size());
  std::vector<Index> tetOf(mesh.PointIds.size(), -1);
  for (std::size_t t = 0; t < parent.size(); ++t)
  {
    for (int c = 0; c < 4; ++c)
    {
      const Index point = mesh.Elements[4 * t + c];
      if (!IsAnchor(topology, point))
      {
        continue;
      }
      if (tetOf[point] < 0)
      {
        tetOf[point] = static_cast<Index>(t);
      }
      Join(parent, tetOf[point], static_cast<Index>(t));
    }
  }
  for (const auto& pair : faces.Joined)
  {
    Join(parent, pair[0], pair[1]);
  }
  return parent;
}

std::vector<Piece> TetFragments::FindPieces(const Mesh& mesh, std::vector<Index> parent)
{
  std::vector<Piece> pieces;
  for (std::size_t t = 0; t < parent.size(); ++t)
  {
    const Index root = FindRoot(parent, static_cast<Index>(t));
    if (root == static_cast<Index>(t))
    {
      this->PieceOf.push_back(static_cast<int>(pieces.size()));
      pieces.push_back({ mesh.ElementIds[t], mesh.Material[t] });
    }
    else
    {
      this->PieceOf.push_back(this->PieceOf[root]);
    }
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
  ForCentres(topology, this->Grid,
    [&](const IndexBox& cells, Index tet)
    {
      this->Parts.ForRows(cells,
        [&](Index first, Index last) { pieceOf.Fill(first, last, offset + this->PieceOf[tet]); });
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
  std::vector<Bytes> answers;
  for (const std::vector<Index>& asked : this->Parts.Request(ids))
  {
    std::vector<Index> pieces;
    for (Index id : asked)
    {
      pieces.push_back(offset + this->PieceOf[FindSorted(mesh.ElementIds, id)]);
    }
    answers.push_back(ToBytes(pieces));
  }
  answers = this->Parts.Group().Exchange(this->Parts.Peers(), answers);
  PiecePairs same;
  for (std::size_t peer = 0; peer < answers.size(); ++peer)
  {
    const std::vector<Index> pieces = FromBytes<Index>(answers[peer]);
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
      same.push_back({ { offset + this->PieceOf[tets[peer][i]], pieces[i] } });
    }
  }
  return same;
}

void TetFragments::FindLocations(const TetTopology& topology)
{
  const Mesh& mesh = topology.Tets;
  this->FragmentOfCentre = PagedArray<int>(this->Grid, 0);
  ForCentres(topology, this->Grid,
    [&](const IndexBox& cells, Index tet)
    {
      this->Parts.ForRows(cells,
        [&](Index first, Index last)
        { this->FragmentOfCentre.Fill(first, last, mesh.Fragment[tet]); });
    });
  for (std::size_t t = 0; t < mesh.ElementIds.size(); ++t)
  {
    bool cut = false;
    for (int c = 0; c < 4; ++c)
    {
      cut = cut || !IsAnchor(topology, mesh.Elements[4 * t + c]);
    }
    if (cut)
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
