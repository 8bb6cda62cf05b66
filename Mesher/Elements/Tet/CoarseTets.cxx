#include "Elements/Tet/CoarseTets.h"

#include "Base/HexNumbering.h"
#include "Base/Sorted.h"
#include "Base/Vector3.h"
#include "Elements/EqualFaces.h"
#include "Elements/GridCoordinates.h"
#include "Elements/PeriodicIds.h"
#include "Octree/LevelIds.h"

namespace vfm
{
namespace
{

constexpr double SmallestGain = 1e-6; // relative gain required to change the way of a face

} // namespace

CoarseTets::CoarseTets(CoarseHexes& hexes, Ranks& ranks) : Grid(hexes.Levels())
{
  if (this->Grid.IsUniform())
  {
    return;
  }
  // Keys of hexes of all levels, per finest cell.
  constexpr Index hexKeys = OctreeKeys::HexSlots * 8 / 7;
  CheckIds(this->Grid.Finest(), TetIds.ElementSlots + TetsOfHex * hexKeys);
  this->TakeHexes(hexes);
  CheckNumberOfPoints(this->NumberOfPoints(), ranks);
  this->AddFinePoints();
  this->AddCentres();
  this->FindFaces();
}

/// Stores the hexes near the owned cells. A corner that is a vertex of a fine cell is stored as
/// ~(linear index), until AddCentres replaces it by a point.
void CoarseTets::TakeHexes(CoarseHexes& hexes)
{
  this->Local.Levels = this->Grid.shared_from_this();
  this->Local.Ids = TetIds;
  this->Local.Points = Buffer<double>(3 * hexes.NumberOfPoints());
  std::vector<Index> ids;
  hexes.Visit(
    [&](Index key, const Vector3& x)
    {
      std::copy(x.begin(), x.end(), this->Local.Points.data() + 3 * ids.size());
      ids.push_back(CoarsePointId(this->Grid, key, TetIds.PointSlots));
    },
    [&](
      Index key, const OctreeKeys::LevelIndex& cell, int label, const std::array<Index, 8>& corners)
    {
      if (this->Grid.IsNear(cell.Level, cell.At))
      {
        const bool isWhole = !this->Grid.Families().IsTouched(cell.Level, cell.At);
        this->Hexes.push_back({ key, cell, label, isWhole, corners });
      }
    });
  this->HexPoints = static_cast<int>(ids.size());
  for (const Hex& hex : this->Hexes)
  {
    ids.push_back(CentreId(this->Grid, hex.Key, TetIds.PointSlots));
  }
  this->Local.PointIds = Buffer<Index>(ids.size());
  std::copy(ids.begin(), ids.end(), this->Local.PointIds.begin());
}

Vector3 CoarseTets::PointAt(int point) const
{
  return ToGrid(this->Grid.Finest(), this->Local.Points.data() + 3 * point);
}

int CoarseTets::FindFine(Index code) const
{
  const Index at = FindSorted(this->FineCodes, code);
  return at < 0 ? -1 : static_cast<int>(this->NumberOfPoints() + at);
}

/// Adds the vertices of fine cells that are corners of coarse hexes, and the centres of the fine
/// cells around them.
void CoarseTets::AddFinePoints()
{
  const CartesianGrid& grid = this->Grid.Finest();
  const IndexBox box = grid.HexBox();
  for (const Hex& hex : this->Hexes)
  {
    for (Index corner : hex.Corners)
    {
      if (corner < 0)
      {
        this->FineCodes.push_back(2 * ~corner + VertexSlot);
      }
    }
  }
  SortUnique(this->FineCodes);
  const std::size_t vertices = this->FineCodes.size();
  for (std::size_t v = 0; v < vertices; ++v)
  {
    const Index node = this->FineCodes[v] / 2;
    for (int c = 0; c < 8; ++c)
    {
      const Index cell = grid.CellOfNode(node, c);
      const Index3 at = grid.Position(cell);
      if (box.Contains(at) && this->Grid.IsFine(at))
      {
        this->FineCodes.push_back(2 * cell + CentreSlot);
      }
    }
  }
  SortUnique(this->FineCodes);
  const Index known = this->NumberOfPoints();
  Buffer<double> points(3 * (known + this->FineCodes.size()));
  std::copy(this->Local.Points.begin(), this->Local.Points.end(), points.begin());
  this->Local.Points = std::move(points);
  for (std::size_t f = 0; f < this->FineCodes.size(); ++f)
  {
    const Index3 at = grid.Position(this->FineCodes[f] / 2);
    Vector3 x = grid.NodePoint(at);
    for (int a = 0; this->FineCodes[f] % 2 == CentreSlot && a < 3; ++a)
    {
      x[a] = 0.5 * (x[a] + grid.Coordinates(a)[at[a] + 1]);
    }
    std::copy(x.begin(), x.end(), this->Local.Points.data() + 3 * (known + f));
  }
}

void CoarseTets::AddCentres()
{
  for (std::size_t h = 0; h < this->Hexes.size(); ++h)
  {
    Vector3 sum{ { 0.0, 0.0, 0.0 } };
    for (Index& corner : this->Hexes[h].Corners)
    {
      corner = corner < 0 ? this->FindFine(2 * ~corner + VertexSlot) : corner;
      sum = sum + this->Local.PointAt(corner);
    }
    const Vector3 centre = 0.125 * sum;
    this->Hexes[h].Centre = this->HexPoints + static_cast<int>(h);
    std::copy(centre.begin(), centre.end(), this->Local.Points.data() + 3 * this->Hexes[h].Centre);
  }
}

std::vector<CoarseTets::CoarseFace> CoarseTets::ListFaces() const
{
  std::vector<CoarseFace> faces;
  faces.reserve(6 * this->Hexes.size());
  for (std::size_t h = 0; h < this->Hexes.size(); ++h)
  {
    for (int side = 0; side < 6; ++side)
    {
      CoarseFace face{ static_cast<int>(h), side, -1, {}, this->Hexes[h].IsWhole, 0 };
      for (int c = 0; c < 4; ++c)
      {
        face.Corners[c] = static_cast<int>(this->Hexes[h].Corners[FaceCorners[side][c]]);
      }
      faces.push_back(face);
    }
  }
  return faces;
}

/// Pairs the faces of hexes. Omits faces at the rim whose other side is unknown.
void CoarseTets::FindFaces()
{
  std::vector<CoarseFace> faces = this->ListFaces();
  std::vector<unsigned char> isSecond(faces.size(), 0);
  const auto pointsOf = [&faces](Index f)
  {
    FaceIds points;
    std::copy(faces[f].Corners.begin(), faces[f].Corners.end(), points.begin());
    std::sort(points.begin(), points.end());
    return points;
  };
  ForEqualFaces(faces.size(), pointsOf,
    [&](std::span<const NumberedFace> same)
    {
      if (same.size() < 2)
      {
        return;
      }
      const int first = static_cast<int>(same[0].Number), second = static_cast<int>(same[1].Number);
      CoarseFace &face = faces[first], &other = faces[second];
      face.IsPlain = other.IsPlain = face.IsPlain && other.IsPlain;
      if (this->SeamOf(face) >= 0)
      {
        face.Partner = second;
        other.Partner = first;
        return;
      }
      face.Centre = this->Hexes[other.Hex].Centre;
      isSecond[second] = 1;
    });
  std::vector<int> positions(faces.size(), -1);
  std::vector<FineHalf> fineHalves;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (!isSecond[f] && this->AddFace(faces[f], fineHalves))
    {
      positions[f] = static_cast<int>(this->Faces.size()) - 1;
    }
  }
  for (CoarseFace& face : this->Faces)
  {
    face.Partner = face.Partner < 0 ? -1 : positions[face.Partner];
  }
  this->AddFineHalves(fineHalves);
}

/// Returns the axis across which a face lies on a flat seam, or -1.
int CoarseTets::SeamOf(const CoarseFace& face) const
{
  int axes = this->Grid.Finest().IsPeriodic() ? 7 : 0;
  for (int p : face.Corners)
  {
    axes &= axes == 0 ? 0 : this->Grid.Finest().FlatSeams(this->Local.PointAt(p));
  }
  return axes == 0 ? -1 : axes & 1 ? 0 : axes & 2 ? 1 : 2;
}

/// Adds the faces of finest cells that are on flat seams, and opposite to faces of coarse hexes.
void CoarseTets::AddFineHalves(const std::vector<FineHalf>& fineHalves)
{
  const CartesianGrid& grid = this->Grid.Finest();
  const int level = this->Grid.NumberOfRefinements();
  struct Half
  {
    Index Key;
    int Side;
    const FineHalf* Of;
    bool operator<(const Half& other) const
    {
      return this->Key != other.Key ? this->Key < other.Key : this->Side < other.Side;
    }
  };
  std::vector<Half> halves;
  for (const FineHalf& half : fineHalves)
  {
    const Index3 cell = grid.Position(this->FineCodes[half.Centre - this->NumberOfPoints()] / 2);
    const bool isBelow = !grid.IsOnFlatSeam(cell, half.Axis);
    halves.push_back(
      { this->Grid.Lattice().HexKey(level, cell, 0), 2 * half.Axis + isBelow, &half });
  }
  std::sort(halves.begin(), halves.end());
  for (const Half& half : halves)
  {
    const int face = half.Of->Face;
    CoarseFace own = this->Faces[face];
    std::reverse(own.Corners.begin(), own.Corners.end());
    this->Faces[face].Partner = static_cast<int>(this->Faces.size());
    this->Hexes.push_back({ half.Key, this->Grid.Lattice().HexOfKey(half.Key),
      this->Hexes[own.Hex].Material, true, {}, half.Of->Centre });
    own.Hex = static_cast<int>(this->Hexes.size()) - 1;
    own.Side = half.Side;
    own.Partner = face;
    this->Faces.push_back(own);
  }
}

/// Adds a face, unless its other side is unknown. Returns whether it is added.
bool CoarseTets::AddFace(CoarseFace face, std::vector<FineHalf>& fineHalves)
{
  const Index3& at = this->Hexes[face.Hex].Cell.At;
  const int diagonal = 1 + static_cast<int>((at[0] + at[1] + at[2]) & 1);
  if (face.Partner >= 0)
  {
    face.Way = diagonal;
  }
  else if (face.Centre < 0)
  {
    int sides = 63;
    for (int p : face.Corners)
    {
      sides &= FindDomainSides(this->Grid.Finest(), this->Local.Points.data() + 3 * p);
    }
    if (sides == 0)
    {
      const int centre = this->FineCentreBeyond(face), seam = centre < 0 ? -1 : this->SeamOf(face);
      if (centre < 0)
      {
        return false;
      }
      if (seam >= 0)
      {
        face.Way = diagonal;
        fineHalves.push_back({ static_cast<int>(this->Faces.size()), seam, centre });
      }
      else
      {
        face.Centre = centre;
      }
    }
    else
    {
      face.Way = diagonal;
    }
  }
  this->Faces.push_back(face);
  return true;
}

/// Returns the centre of the fine cell on the other side of a face of a coarse hex, or -1 if there
/// is none.
int CoarseTets::FineCentreBeyond(const CoarseFace& face) const
{
  const CartesianGrid& grid = this->Grid.Finest();
  IndexBox quad;
  for (int c = 0; c < 4; ++c)
  {
    const Index at = face.Corners[c] - this->NumberOfPoints();
    if (at < 0)
    {
      return -1;
    }
    const Index3 node = grid.Position(this->FineCodes[at] / 2);
    for (int a = 0; a < 3; ++a)
    {
      quad.Lower[a] = c == 0 ? node[a] : std::min(quad.Lower[a], node[a]);
      quad.Upper[a] = c == 0 ? node[a] : std::max(quad.Upper[a], node[a]);
    }
  }
  const OctreeKeys::LevelIndex& leaf = this->Hexes[face.Hex].Cell;
  const IndexBox own = this->Grid.FinestCells(leaf.Level, leaf.At);
  Index3 cell = quad.Lower;
  int across = 0;
  for (int a = 0; a < 3; ++a)
  {
    const bool isFlat = quad.Size(a) == 0;
    if (quad.Size(a) > 1 ||
      (isFlat && quad.Lower[a] > own.Lower[a] && quad.Lower[a] < own.Upper[a]))
    {
      return -1;
    }
    across += isFlat;
    cell[a] -= isFlat && quad.Lower[a] == own.Lower[a];
  }
  return across == 1 && grid.InDomain(cell) ? this->FindFine(2 * grid.Linear(cell) + CentreSlot)
                                            : -1;
}

/// Writes the tets of a face that is divided in one way. Returns their number: 4, or 2 on the
/// domain boundary and flat seams.
int CoarseTets::TetsOf(const CoarseFace& face, int way, Tet tets[4]) const
{
  std::array<int, 4> q = face.Corners;
  const int centre = this->Hexes[face.Hex].Centre;
  if (way == 0)
  {
    for (int t = 0; t < 4; ++t)
    {
      tets[t] = { { centre, face.Centre, q[t], q[(t + 1) % 4] } };
    }
    return 4;
  }
  std::rotate(q.begin(), q.begin() + way - 1, q.end());
  tets[0] = { { q[0], q[3], q[2], centre } };
  tets[1] = { { q[0], q[2], q[1], centre } };
  if (face.Centre < 0)
  {
    return 2;
  }
  tets[2] = { { q[0], q[1], q[2], face.Centre } };
  tets[3] = { { q[0], q[2], q[3], face.Centre } };
  return 4;
}

/// Writes the tets of a face, on a flat seam those on both sides. Returns their number.
int CoarseTets::TetsOnBothSides(const CoarseFace& face, int way, Tet tets[4]) const
{
  const int count = this->TetsOf(face, way, tets);
  return face.Partner < 0
    ? count
    : count + this->TetsOf(this->Faces[face.Partner], this->WayOfPartner(face, way), tets + count);
}

/// Returns the way in which the partner of a face has the same diagonal.
int CoarseTets::WayOfPartner(const CoarseFace& face, int way) const
{
  const std::array<int, 4>& corners = this->Faces[face.Partner].Corners;
  return 1 + (corners[0] == face.Corners[way - 1] || corners[2] == face.Corners[way - 1] ? 0 : 1);
}

Vector3 CoarseTets::WidthsOf(const CoarseFace& face) const
{
  const OctreeKeys::LevelIndex& cell = this->Hexes[face.Hex].Cell;
  return (1.0 / this->Grid.Finest().MeanWidth()) *
    this->Grid.Lattice().CellWidths(cell.Level, cell.At);
}

double CoarseTets::EnergyOf(const CoarseFace& face, int way, const WayEnergy& energy) const
{
  Tet tets[4];
  const int count = this->TetsOnBothSides(face, way, tets);
  FourTets corners;
  for (int t = 0; t < 4; ++t)
  {
    for (int c = 0; c < 4; ++c)
    {
      corners[t][c] = this->PointAt(tets[t % count][c]); // repeats the tets if there are two
    }
  }
  return energy(corners, this->WidthsOf(face));
}

/// Returns the best way to divide a face, which is the present way unless another is better.
int CoarseTets::BestWay(const CoarseFace& face, const WayEnergy& energyOf) const
{
  if (face.IsPlain)
  {
    return face.Way;
  }
  int best = face.Way;
  double lowest = this->EnergyOf(face, best, energyOf);
  for (int way = face.Centre < 0; way < 3; ++way)
  {
    const double energy = way == face.Way ? lowest : this->EnergyOf(face, way, energyOf);
    if (energy < lowest - SmallestGain * std::fabs(lowest))
    {
      lowest = energy;
      best = way;
    }
  }
  return best;
}

/// Returns whether the way of a face is chosen for it, not for its partner.
bool CoarseTets::Decides(const CoarseFace& face) const
{
  return face.Partner < 0 || face.Hex < this->Faces[face.Partner].Hex;
}

void CoarseTets::ChooseWays(const WayEnergy& energy, Runtime& runtime)
{
  ForEach(runtime, this->Faces.size(),
    [&](Index f)
    {
      if (this->Decides(this->Faces[f]))
      {
        this->Faces[f].Way = this->BestWay(this->Faces[f], energy);
      }
    });
  if (this->Grid.Finest().IsPeriodic())
  {
    this->TakeWays(runtime.Group());
  }
  for (const CoarseFace& face : this->Faces)
  {
    if (face.Partner >= 0 && this->Decides(face))
    {
      this->Faces[face.Partner].Way = this->WayOfPartner(face, face.Way);
    }
  }
}

/// Replaces the ways of faces that this rank does not own by those of their owners: the positions
/// of copies are rounded, which may change a choice. Collective.
void CoarseTets::TakeWays(Ranks& ranks)
{
  const Partition partition(this->Grid.Base(), ranks);
  const auto codeOf = [](Index hexKey, int side) { return 8 * hexKey + side; };
  std::vector<std::vector<Index>> faces(partition.Peers().size()), codes(faces.size());
  std::vector<Index> own;
  for (std::size_t f = 0; f < this->Faces.size(); ++f)
  {
    const CoarseFace& face = this->Faces[f];
    const Hex& hex = this->Hexes[face.Hex];
    const Index3 cell = BaseCellOf(hex.Cell);
    own.push_back(codeOf(hex.Key, face.Side));
    if (!face.IsPlain && this->Decides(face) && !partition.OwnsCell(cell))
    {
      const int peer = partition.PeerOfCell(cell);
      const OctreeKeys::LevelIndex there = Below(hex.Cell, partition.ShiftOf(peer), 0);
      faces[peer].push_back(static_cast<Index>(f));
      codes[peer].push_back(
        codeOf(this->Grid.Lattice().HexKey(there.Level, there.At, there.Slot), face.Side));
    }
  }
  const std::vector<std::vector<int>> ways =
    partition.Query(codes, [&](Index code) { return this->Faces[FindSorted(own, code)].Way; });
  for (std::size_t peer = 0; peer < ways.size(); ++peer)
  {
    for (std::size_t i = 0; i < ways[peer].size(); ++i)
    {
      this->Faces[faces[peer][i]].Way = ways[peer][i];
    }
  }
}

/// The owner of the tets checks a face.
std::vector<std::vector<Index>> CoarseTets::FindBadFamilies(const WayEnergy& energy) const
{
  std::vector<std::vector<Index>> bad(this->Grid.NumberOfRefinements());
  const auto add = [&](const Hex& hex)
  {
    if (!hex.IsWhole)
    {
      bad[hex.Cell.Level].push_back(this->Grid.Lattice().FamilyKeyOf(hex.Cell));
    }
  };
  for (const CoarseFace& face : this->Faces)
  {
    const Hex& hex = this->Hexes[face.Hex];
    if (!this->Grid.Base().Owned().Contains(BaseCellOf(hex.Cell)) ||
      this->EnergyOf(face, face.Way, energy) < InvalidWay)
    {
      continue;
    }
    add(hex);
    if (face.Centre >= this->HexPoints && face.Centre < this->NumberOfPoints())
    {
      add(this->Hexes[face.Centre - this->HexPoints]);
    }
  }
  return bad;
}

Index CoarseTets::NumberOfTets() const
{
  Index count = 0;
  for (const CoarseFace& face : this->Faces)
  {
    count += face.Centre < 0 ? 2 : 4;
  }
  return count;
}

void CoarseTets::Fill(
  TetTopology& topology, Index firstPoint, Index firstTet, const FinePoint& finePoint) const
{
  Mesh& mesh = topology.Tets;
  const Index own = this->NumberOfPoints();
  std::copy_n(this->Local.Points.begin(), 3 * own, mesh.Points.data() + 3 * firstPoint);
  std::copy_n(this->Local.PointIds.begin(), own, mesh.PointIds.data() + firstPoint);
  for (Index p = 0; p < own; ++p)
  {
    const bool onDomain =
      FindDomainSides(this->Grid.Finest(), this->Local.Points.data() + 3 * p) != 0;
    topology.Positions[firstPoint + p] = onDomain ? PointPosition::OnDomain : PointPosition::Inside;
  }
  Index at = firstTet;
  for (const CoarseFace& face : this->Faces)
  {
    Tet tets[4];
    const int count = this->TetsOf(face, face.Way, tets);
    for (int t = 0; t < count; ++t, ++at)
    {
      for (int c = 0; c < 4; ++c)
      {
        const int point = tets[t][c];
        const Index code = point < own ? 0 : this->FineCodes[point - own];
        mesh.Elements[4 * at + c] =
          point < own ? firstPoint + point : finePoint(code / 2, code % 2);
      }
      mesh.ElementIds[at] =
        TetId(this->Grid, this->Hexes[face.Hex].Key, 4 * face.Side + t, mesh.Ids.ElementSlots);
      mesh.Material[at] = this->Hexes[face.Hex].Material;
    }
  }
}

void CoarseTets::ForFreePoints(
  int level, const std::function<void(int point, const OctreeKeys::LevelIndex& node)>& visit) const
{
  for (int p = 0; p < this->HexPoints; ++p)
  {
    const OctreeKeys::LevelIndex node = this->Grid.Lattice().NodeOfKey(
      KeyOfPoint(this->Grid, this->Local.PointIds[p], TetIds.PointSlots));
    if (node.Level == level && node.Slot > 0)
    {
      visit(p, node);
    }
  }
  for (std::size_t h = 0; h < this->Hexes.size(); ++h)
  {
    OctreeKeys::LevelIndex cell = this->Hexes[h].Cell;
    if (cell.Level == level && !this->Hexes[h].IsWhole)
    {
      cell.At = { { cell.At[0] + 1, cell.At[1] + 1, cell.At[2] + 1 } };
      visit(this->HexPoints + static_cast<int>(h), cell);
    }
  }
}

void CoarseTets::ForFreeTets(
  const std::function<void(const Tet& tet, const Vector3& widths)>& visit) const
{
  for (const CoarseFace& face : this->Faces)
  {
    Tet tets[4];
    const int count = face.IsPlain ? 0 : this->TetsOf(face, face.Way, tets);
    std::for_each(tets, tets + count, [&](const Tet& tet) { visit(tet, this->WidthsOf(face)); });
  }
}

} // namespace vfm
