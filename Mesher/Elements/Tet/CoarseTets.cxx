#include "Elements/Tet/CoarseTets.h"

#include "Base/HexNumbering.h"
#include "Base/Sorted.h"
#include "Elements/Tet/LeafNodes.h"
#include "Octree/LevelIds.h"

namespace vfm
{
namespace
{

Index3 Plus(Index3 p, int axis, Index step)
{
  p[axis] += step;
  return p;
}

Index3 Mean(const Index3& p, const Index3& q)
{
  return { { (p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2 } };
}

/// Returns a corner of a cell as a node of the next level.
Index3 FinerCorner(const Index3& cell, int corner)
{
  const Index3 node = CornerOfCell(cell, corner);
  return { { 2 * node[0], 2 * node[1], 2 * node[2] } };
}

/// Returns the midpoint of two opposite corners of a face, as a node of the next level.
Index3 FinerFaceCentre(const Index3& cell, int side)
{
  return Mean(FinerCorner(cell, FaceCorners[side][0]), FinerCorner(cell, FaceCorners[side][2]));
}

/// Returns the corner of a face (FaceCorners) that is the centre of the face of the coarser leaf
/// beyond it.
int HubOf(const Index3& cell, int side)
{
  int hub = 0;
  for (int k = 0; k < 4; ++k)
  {
    const Index3 node = CornerOfCell(cell, FaceCorners[side][k]);
    const int u = (side / 2 + 1) % 3, v = (side / 2 + 2) % 3;
    hub = node[u] & node[v] & 1 ? k : hub;
  }
  return hub;
}

} // namespace

CoarseTets::CoarseTets(const RefinedGrid& grid, const LabelArray& labels, bool meshVoid,
  const NarrowVoid& narrow, Ranks& ranks) :
  Grid(grid), Labels(labels), MeshVoid(meshVoid), Narrow(&narrow)
{
  if (grid.IsUniform())
  {
    return;
  }
  // The coarser cells add a seventh to the finest ones.
  CheckIds(grid.Finest(), TetIds.ElementSlots + TetsOfCell * 8 / 7 + 1);
  const IndexBox region = grid.Finest().HexBox();
  ForCells(ChangeLevel(region, -grid.NumberOfRefinements()),
    [&](const Index3& cell) {
      this->AddLeaves({ 0, cell, 0 }, region);
    });
  this->Narrow = nullptr;
  std::sort(
    this->Tets.begin(), this->Tets.end(), [](const Tet& a, const Tet& b) { return a.Id < b.Id; });
  for (const Tet& tet : this->Tets)
  {
    std::copy_if(tet.Points.begin(), tet.Points.end(), std::back_inserter(this->Ids),
      [](Index point) { return point > 0; });
  }
  SortUnique(this->Ids);
  CheckNumberOfPoints(this->NumberOfPoints(), ranks);
}

/// Adds the tets of the coarse leaves in a cell that have finest cells in a region.
void CoarseTets::AddLeaves(const Cell& cell, const IndexBox& region)
{
  if (!IsRefined(this->Grid, cell))
  {
    this->AddTetsOf(cell);
    return;
  }
  if (cell.Level + 1 == this->Grid.NumberOfRefinements())
  {
    return;
  }
  ForCells(ChangeLevel(BoxOfCell(cell.At), 1),
    [&](const Index3& child)
    {
      const IndexBox cells = Intersect(this->Grid.FinestCells(cell.Level + 1, child), region);
      if (cells.NumberOfCells() > 0)
      {
        this->AddLeaves({ cell.Level + 1, child, 0 }, region);
      }
    });
}

void CoarseTets::AddTetsOf(const Cell& leaf)
{
  const int label = this->LabelOf(this->KnownCell(leaf));
  for (int side = 0; side < 6; ++side)
  {
    const Face face = this->FaceOf(leaf, side);
    if (label != NoTets)
    {
      this->AddTetsOfFace(face, label);
    }
    this->AddFinestBeyond(face);
  }
}

/// Returns a finest cell of a leaf in HexBox, or -1 if there is none.
Index CoarseTets::KnownCell(const Cell& leaf) const
{
  const CartesianGrid& finest = this->Grid.Finest();
  const IndexBox known = Intersect(this->Grid.FinestCells(leaf.Level, leaf.At), finest.HexBox());
  return known.NumberOfCells() > 0 ? finest.Linear(known.Lower) : -1;
}

/// Returns the label of a finest cell, or NoTets if its leaf gets no tets.
int CoarseTets::LabelOf(Index cell) const
{
  const int label = this->Labels[cell];
  const bool hasTets = IsMeshed(label, this->MeshVoid) || (label == 0 && this->Narrow->Has(cell));
  return hasTets ? label : NoTets;
}

void CoarseTets::AddTetsOfFace(const Face& face, int label)
{
  const Cell& leaf = face.Leaf;
  const bool isUpper = face.Side % 2 == 1;
  const Index3 at = Plus(leaf.At, face.Side / 2, isUpper ? 1 : -1);
  const Cell beyond{ leaf.Level, at, 0 };
  const bool isInside = this->Grid.Lattice().HasCell(leaf.Level, at);
  if (isInside && IsRefined(this->Grid, beyond))
  {
    this->AddAroundCentre(face, label);
  }
  else if (isInside && leaf.Level > 0 &&
    !IsRefined(this->Grid, { leaf.Level - 1, ParentOfCell(at), 0 }))
  {
    this->AddHalves(face, HubOf(leaf.At, face.Side), label);
  }
  else if (!isInside || this->IsOnFlatSeam(leaf, face.Side))
  {
    this->AddOneSided(face, label);
  }
  else
  {
    this->AddBetween(face, beyond, label);
  }
}

/// Adds the tets at a face between two leaves of one level, unless this rank does not know both.
void CoarseTets::AddBetween(const Face& face, const Cell& beyond, int label)
{
  const Index cell = this->KnownCell(beyond);
  if (cell >= 0 && this->Labels[cell] != this->Labels[this->KnownCell(face.Leaf)])
  {
    this->AddOneSided(face, label);
  }
  else if (cell >= 0 && face.Side % 2 == 1 && this->LabelOf(cell) != NoTets)
  {
    this->AddInner(face, this->CentreOf(beyond), label);
  }
}

/// Adds the tets between the centre of a leaf and a face that another cell of its size, if there is
/// one, divides in the same way.
void CoarseTets::AddOneSided(const Face& face, int label)
{
  const bool isHalved = std::any_of(face.Midpoints.begin(), face.Midpoints.end(),
    [](Index midpoint) { return midpoint != NoPoint; });
  if (isHalved)
  {
    this->AddAroundCentre(face, label);
  }
  else
  {
    this->AddHalves(face, this->BoundaryDiagonal(face.Leaf, face.Side), label);
  }
}

/// Adds the tets around the edge between the centres of two leaves of one level.
void CoarseTets::AddInner(const Face& face, Index beyond, int label)
{
  for (int k = 0; k < 4; ++k)
  {
    const Index from = face.Corners[k], to = face.Corners[(k + 1) % 4], middle = face.Midpoints[k];
    this->AddTet(
      face, 2 * k, { { face.Centre, beyond, from, middle == NoPoint ? to : middle } }, label);
    if (middle != NoPoint)
    {
      this->AddTet(face, 2 * k + 1, { { face.Centre, beyond, middle, to } }, label);
    }
  }
}

/// Adds the tets between the centre of a leaf and the triangles around the centre of a face.
void CoarseTets::AddAroundCentre(const Face& face, int label)
{
  const Index hub = this->PointOf(face.Leaf.Level + 1, FinerFaceCentre(face.Leaf.At, face.Side));
  for (int k = 0; k < 4; ++k)
  {
    const Index from = face.Corners[k], to = face.Corners[(k + 1) % 4], middle = face.Midpoints[k];
    this->AddTet(
      face, 2 * k, { { hub, middle == NoPoint ? to : middle, from, face.Centre } }, label);
    if (middle != NoPoint)
    {
      this->AddTet(face, 2 * k + 1, { { hub, to, middle, face.Centre } }, label);
    }
  }
}

/// Adds the tets between the centre of a leaf and the halves of a face.
/// @param first  corner at which the diagonal begins
void CoarseTets::AddHalves(const Face& face, int first, int label)
{
  std::array<Index, 4> q = face.Corners;
  std::rotate(q.begin(), q.begin() + first, q.end());
  this->AddTet(face, 0, { { q[0], q[2], q[1], face.Centre } }, label);
  this->AddTet(face, 1, { { q[0], q[3], q[2], face.Centre } }, label);
}

/// Adds the tets of finest cells beyond a face, which the methods of finest tets do not make.
void CoarseTets::AddFinestBeyond(const Face& face)
{
  const int level = face.Leaf.Level + 1, axis = face.Side / 2, isUpper = face.Side % 2;
  const Index3 beyond = Plus(face.Leaf.At, axis, isUpper ? 1 : -1);
  if (level < this->Grid.NumberOfRefinements() ||
    !this->Grid.Lattice().HasCell(level - 1, beyond) ||
    !IsRefined(this->Grid, { level - 1, beyond, 0 }))
  {
    return;
  }
  for (int c = 0; c < 8; ++c)
  {
    if ((c >> axis & 1) != isUpper)
    {
      const Face finest = this->FaceOf({ level, ChildOfCell(beyond, c), 0 }, face.Side ^ 1);
      const Index cell = this->KnownCell(finest.Leaf);
      const int label = cell < 0 ? NoTets : this->LabelOf(cell);
      if (label != NoTets)
      {
        this->AddHalves(finest, HubOf(finest.Leaf.At, finest.Side), label);
      }
    }
  }
}

/// Adds a tet, unless a point of it is unknown on this rank.
void CoarseTets::AddTet(const Face& face, int number, const std::array<Index, 4>& points, int label)
{
  if (std::find(points.begin(), points.end(), Unknown) == points.end())
  {
    const Index key = this->Grid.Lattice().HexKey(face.Leaf.Level, face.Leaf.At, 0);
    this->Tets.push_back(
      { TetId(this->Grid, key, 8 * face.Side + number, TetIds.ElementSlots), label, points });
  }
}

CoarseTets::Face CoarseTets::FaceOf(const Cell& leaf, int side) const
{
  Face face{ leaf, side, this->CentreOf(leaf), {}, {} };
  for (int k = 0; k < 4; ++k)
  {
    const int corner = FaceCorners[side][k], next = FaceCorners[side][(k + 1) % 4];
    face.Corners[k] = this->PointOf(leaf.Level, CornerOfCell(leaf.At, corner));
    face.Midpoints[k] = HasMidpoint(this->Grid, leaf, corner, next)
      ? this->PointOf(
          leaf.Level + 1, Mean(FinerCorner(leaf.At, corner), FinerCorner(leaf.At, next)))
      : NoPoint;
  }
  return face;
}

bool CoarseTets::IsOnFlatSeam(const Cell& leaf, int side) const
{
  const Index3 node = CornerOfCell(leaf.At, FaceCorners[side][0]);
  return this->Grid.Finest().IsPeriodic() &&
    this->Grid.Finest().IsOnFlatSeam(this->Grid.FinestNode(leaf.Level, node), side / 2);
}

/// Returns the corner at which the diagonal of a face on the domain boundary begins, equal for
/// copies.
int CoarseTets::BoundaryDiagonal(const Cell& leaf, int side) const
{
  const Index3 node = CornerOfCell(leaf.At, FaceCorners[side][0]);
  const Index3 finest = this->Grid.Finest().Canonical(this->Grid.FinestNode(leaf.Level, node));
  const int shift = this->Grid.NumberOfRefinements() - leaf.Level;
  return static_cast<int>(((finest[0] >> shift) + (finest[1] >> shift) + (finest[2] >> shift)) & 1);
}

/// Returns the point at a node of a level.
Index CoarseTets::PointOf(int level, const Index3& node) const
{
  const CartesianGrid& finest = this->Grid.Finest();
  const Index3 at = this->Grid.FinestNode(level, node);
  if (!IsFineVertex(this->Grid, at))
  {
    return CoarsePointId(
      this->Grid, this->Grid.Lattice().LatticeKey(level, node), TetIds.PointSlots);
  }
  return finest.HexBox().Touches(at) ? ~(2 * finest.Linear(at) + VertexSlot) : Unknown;
}

Index CoarseTets::CentreOf(const Cell& cell) const
{
  const CartesianGrid& finest = this->Grid.Finest();
  const IndexBox known = Intersect(this->Grid.FinestCells(cell.Level, cell.At), finest.HexBox());
  if (known.NumberOfCells() == 0)
  {
    return Unknown;
  }
  return cell.Level == this->Grid.NumberOfRefinements()
    ? ~(2 * finest.Linear(cell.At) + CentreSlot)
    : CentreId(this->Grid, this->Grid.Lattice().HexKey(cell.Level, cell.At, 0), TetIds.PointSlots);
}

Vector3 CoarseTets::PositionOf(Index id) const
{
  const OctreeKeys& lattice = this->Grid.Lattice();
  if (!IsCoarseCentre(this->Grid, id, TetIds.PointSlots))
  {
    const Cell node = lattice.NodeOfKey(KeyOfPoint(this->Grid, id, TetIds.PointSlots));
    return lattice.NodePoint(node.Level, node.At);
  }
  const Cell cell = CellOfCoarseCentre(this->Grid, id, TetIds.PointSlots);
  const Vector3 lower = lattice.NodePoint(cell.Level, cell.At),
                upper = lattice.NodePoint(cell.Level, CornerOfCell(cell.At, 7));
  return { { 0.5 * (lower[0] + upper[0]), 0.5 * (lower[1] + upper[1]),
    0.5 * (lower[2] + upper[2]) } };
}

PointPosition CoarseTets::KindOf(Index id) const
{
  if (IsCoarseCentre(this->Grid, id, TetIds.PointSlots))
  {
    return PointPosition::Inside;
  }
  const Cell node = this->Grid.Lattice().NodeOfKey(KeyOfPoint(this->Grid, id, TetIds.PointSlots));
  const CartesianGrid& finest = this->Grid.Finest();
  const Index3 at = this->Grid.FinestNode(node.Level, node.At);
  if (!this->Grid.HasFineInterfaces() &&
    IsMixedStar(StarOfNode(finest, this->Labels, finest.Linear(at))))
  {
    return PointPosition::OnInterface;
  }
  return this->Grid.Lattice().DomainSides(node.Level, node.At) != 0 ? PointPosition::OnDomain
                                                                    : PointPosition::Inside;
}

void CoarseTets::Fill(
  TetTopology& topology, Index firstPoint, Index firstTet, const FinePoint& finePoint) const
{
  Mesh& mesh = topology.Tets;
  for (std::size_t p = 0; p < this->Ids.size(); ++p)
  {
    const Index point = firstPoint + static_cast<Index>(p);
    mesh.SetPoint(point, this->PositionOf(this->Ids[p]), this->Ids[p]);
    topology.Positions[point] = this->KindOf(this->Ids[p]);
  }
  const auto pointOf = [&](Index point)
  {
    return point > 0 ? firstPoint + FindSorted(this->Ids, point)
                     : finePoint(~point / 2, ~point % 2);
  };
  for (const Tet& tet : this->Tets)
  {
    const auto& [a, b, c, d] = tet.Points;
    mesh.SetElement(firstTet++,
      std::array<Index, 4>{ { pointOf(a), pointOf(b), pointOf(c), pointOf(d) } }, tet.Id,
      tet.Material);
  }
}

} // namespace vfm
