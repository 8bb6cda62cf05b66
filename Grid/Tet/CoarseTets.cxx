#include "Tet/CoarseTets.h"

#include "Base/HexNumbering.h"
#include "Base/Sorted.h"
#include "Base/Vector3.h"
#include "Hex/TransitionSmoothing.h"
#include "Octree/LevelIds.h"
#include "Tet/CoarseTetsImprove.h"
#include "Tet/TetImprove.h"

namespace vfm
{
namespace
{

constexpr double SmallestGain = 1e-6; // relative gain required to change the way of a face

} // namespace

CoarseTets::CoarseTets(CoarseHexes& hexes, const TetEnergy& energy, Runtime& runtime) :
  Grid(hexes.Levels()), Energy(energy)
{
  if (this->Grid.IsUniform())
  {
    return;
  }
  // Keys of hexes of all levels, per finest cell.
  constexpr Index hexKeys = OctreeKeys::HexSlots * 8 / 7;
  CheckIds(this->Grid.Finest(), TetIds.ElementSlots + TetsOfHex * hexKeys);
  this->TakeHexes(hexes);
  CheckNumberOfPoints(this->NumberOfPoints(), runtime.Group());
  this->AddFinePoints();
  this->AddCentres();
  this->FindFaces();
  this->ChooseWays(runtime);
  this->FindBadFamilies();
  if (runtime.Group().Any(std::any_of(this->Bad.begin(), this->Bad.end(),
        [](const std::vector<Index>& families) { return !families.empty(); })))
  {
    return;
  }
  this->Improve(runtime);
  this->ChooseWays(runtime);
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
    std::copy(centre.begin(), centre.end(), this->Local.Points.data() + 3 * (this->HexPoints + h));
  }
}

std::vector<CoarseTets::Face> CoarseTets::ListFaces() const
{
  std::vector<Face> faces;
  faces.reserve(6 * this->Hexes.size());
  for (std::size_t h = 0; h < this->Hexes.size(); ++h)
  {
    for (int side = 0; side < 6; ++side)
    {
      Face face{ static_cast<int>(h), side, -1, {}, this->Hexes[h].IsWhole, 0 };
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
  struct Half
  {
    std::array<int, 4> Key; // the corners, ascending
    int Face;
    bool operator<(const Half& other) const
    {
      return this->Key != other.Key ? this->Key < other.Key : this->Face < other.Face;
    }
  };
  std::vector<Face> faces = this->ListFaces();
  std::vector<Half> halves;
  halves.reserve(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    halves.push_back({ faces[f].Corners, static_cast<int>(f) });
    std::sort(halves.back().Key.begin(), halves.back().Key.end());
  }
  std::sort(halves.begin(), halves.end());
  std::vector<unsigned char> isSecond(faces.size(), 0);
  for (std::size_t h = 1; h < halves.size(); ++h)
  {
    if (halves[h].Key == halves[h - 1].Key)
    {
      Face& face = faces[halves[h - 1].Face];
      const Face& other = faces[halves[h].Face];
      face.Centre = this->HexPoints + other.Hex;
      face.IsPlain = face.IsPlain && other.IsPlain;
      isSecond[halves[h].Face] = 1;
    }
  }
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (!isSecond[f])
    {
      this->AddFace(faces[f]);
    }
  }
}

void CoarseTets::AddFace(Face face)
{
  if (face.Centre < 0)
  {
    int sides = 63;
    for (int p : face.Corners)
    {
      sides &= FindDomainSides(this->Grid.Finest(), this->Local.Points.data() + 3 * p);
    }
    if (sides == 0)
    {
      face.Centre = this->FineCentreBeyond(face);
      if (face.Centre < 0)
      {
        return;
      }
    }
    else
    {
      const Index3& at = this->Hexes[face.Hex].Cell.At;
      face.Way = 1 + static_cast<int>((at[0] + at[1] + at[2]) & 1);
    }
  }
  this->Faces.push_back(face);
}

/// Returns the centre of the fine cell on the other side of a face of a coarse hex, or -1 if there
/// is none.
int CoarseTets::FineCentreBeyond(const Face& face) const
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
/// domain boundary.
int CoarseTets::TetsOf(const Face& face, int way, Tet tets[4]) const
{
  std::array<int, 4> q = face.Corners;
  const int centre = this->HexPoints + face.Hex;
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

Vector3 CoarseTets::WidthsOf(const Face& face) const
{
  const OctreeKeys::LevelIndex& cell = this->Hexes[face.Hex].Cell;
  return (1.0 / this->Grid.Finest().MeanWidth()) *
    this->Grid.Lattice().CellWidths(cell.Level, cell.At);
}

double CoarseTets::EnergyOf(const Face& face, int way) const
{
  Tet tets[4];
  const int count = this->TetsOf(face, way, tets);
  Vector3 corners[4][4];
  for (int t = 0; t < 4; ++t)
  {
    for (int c = 0; c < 4; ++c)
    {
      corners[t][c] = this->PointAt(tets[t % count][c]); // repeats the tets if there are two
    }
  }
  const std::array<double, 4> e =
    this->Energy.OfTets(corners, this->WidthsOf(face), TetRamp().back());
  return std::max({ e[0], e[1], e[2], e[3] }) >= InvalidEnergy ? InvalidEnergy
                                                               : (e[0] + e[1]) + (e[2] + e[3]);
}

/// Returns the best way to divide a face, which is the present way unless another is better.
int CoarseTets::BestWay(const Face& face) const
{
  if (face.IsPlain)
  {
    return face.Way;
  }
  int best = face.Way;
  double lowest = this->EnergyOf(face, best);
  for (int way = face.Centre < 0; way < 3; ++way)
  {
    const double energy = way == face.Way ? lowest : this->EnergyOf(face, way);
    if (energy < lowest - SmallestGain * std::fabs(lowest))
    {
      lowest = energy;
      best = way;
    }
  }
  return best;
}

void CoarseTets::ChooseWays(Runtime& runtime)
{
  ForEach(runtime, this->Faces.size(),
    [this](Index f) { this->Faces[f].Way = this->BestWay(this->Faces[f]); });
}

/// Finds the families of transition hexes that have tets of invalid energy. The owner of the tets
/// checks a face.
void CoarseTets::FindBadFamilies()
{
  this->Bad.resize(this->Grid.NumberOfRefinements());
  const auto add = [this](const Hex& hex)
  {
    if (!hex.IsWhole)
    {
      this->Bad[hex.Cell.Level].push_back(this->Grid.Lattice().FamilyKeyOf(hex.Cell));
    }
  };
  for (const Face& face : this->Faces)
  {
    const Hex& hex = this->Hexes[face.Hex];
    if (!this->Grid.Base().Owned().Contains(BaseCellOf(hex.Cell)) ||
      this->EnergyOf(face, face.Way) < InvalidEnergy)
    {
      continue;
    }
    add(hex);
    const std::size_t beyond = face.Centre - this->HexPoints;
    if (face.Centre >= this->HexPoints && beyond < this->Hexes.size())
    {
      add(this->Hexes[beyond]);
    }
  }
}

Index CoarseTets::NumberOfTets() const
{
  Index count = 0;
  for (const Face& face : this->Faces)
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
  for (const Face& face : this->Faces)
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

/// Returns the points of a level that may move. A copy of a lattice node moves with this node, the
/// centre of a transition hex with the upper node of its cell. So points of one colour share a tet
/// only if they move with one node, and the owner of a cell has all tets at its points.
std::vector<Mover> CoarseTets::FindMovers(int level) const
{
  const OctreeKeys& lattice = this->Grid.Lattice();
  std::vector<Mover> movers;
  const auto add = [&](int point, const OctreeKeys::LevelIndex& node)
  {
    movers.push_back({ point, this->Local.PointIds[point], lattice.NodeKey(level, node.At, 0),
      OwnerNode(node), CartesianGrid::Parities(node.At) });
  };
  for (int p = 0; p < this->HexPoints; ++p)
  {
    const OctreeKeys::LevelIndex node =
      lattice.NodeOfKey(KeyOfPoint(this->Grid, this->Local.PointIds[p], TetIds.PointSlots));
    if (node.Level == level && node.Slot > 0)
    {
      add(p, node);
    }
  }
  for (std::size_t h = 0; h < this->Hexes.size(); ++h)
  {
    OctreeKeys::LevelIndex cell = this->Hexes[h].Cell;
    if (cell.Level == level && !this->Hexes[h].IsWhole)
    {
      cell.At = { { cell.At[0] + 1, cell.At[1] + 1, cell.At[2] + 1 } };
      add(this->HexPoints + static_cast<int>(h), cell);
    }
  }
  return movers;
}

/// Moves points of poor tets, one level after another because points of one colour but different
/// levels might share a tet. Collective.
void CoarseTets::Improve(Runtime& runtime)
{
  const TetList tets = [this](const auto& visit)
  {
    for (const Face& face : this->Faces)
    {
      Tet of[4];
      const int count = face.IsPlain ? 0 : this->TetsOf(face, face.Way, of);
      std::for_each(of, of + count, [&](const Tet& tet) { visit(tet, this->WidthsOf(face)); });
    }
  };
  const Partition partition(this->Grid.Base(), runtime.Group());
  for (int level = 0; level < this->Grid.NumberOfRefinements(); ++level)
  {
    ImproveCoarseTets(this->FindMovers(level), tets, this->Grid.Finest(), partition, this->Energy,
      runtime, this->Local);
  }
}

} // namespace vfm
