#include "Elements/Hex/CoarseHexes.h"

#include "Elements/Hex/HexTopology.h"
#include "Octree/LevelIds.h"

#include <limits>

namespace vfm
{

CoarseHexes::CoarseHexes(const RefinedGrid& grid, const LabelArray& labels, const Options& options,
  RefinedMesh refined, const std::vector<OctreeKeys::LevelIndex>& badCells) :
  Grid(grid),
  Labels(labels),
  MeshVoid(options.MeshVoid),
  Narrow(options.Narrow),
  HasBuffers(options.HasBuffers),
  TheRefined(std::move(refined))
{
  if (grid.IsUniform())
  {
    return;
  }
  this->Region = RegionOf(grid);
  this->NodeNumber = Buffer<int>(grid.Base().NumberOfEntries(), Unused);
  if (!grid.HasFineInterfaces())
  {
    this->TheSplits = FindSplitNodes(grid, this->TheRefined, this->Region, labels,
      [this](const OctreeKeys::LevelIndex& cell) { return this->HasHexes(cell); });
  }
  this->FindBadFamilies(badCells);
  for (Index key : this->TheRefined.HexKeys)
  {
    this->Requested.push_back(this->IsRequested(grid.Lattice().HexOfKey(key)));
  }
  this->MarkPoints();
  this->NumberPoints();
}

/// Sets Bad to the bad families of split nodes, if there are buffers, and of transitions.
void CoarseHexes::FindBadFamilies(const std::vector<OctreeKeys::LevelIndex>& badCells)
{
  if (this->HasBuffers)
  {
    this->Bad = this->TheSplits.BadFamilies;
  }
  this->Bad.resize(this->Grid.NumberOfRefinements());
  for (const OctreeKeys::LevelIndex& cell : badCells)
  {
    this->Bad[cell.Level].push_back(this->Grid.Lattice().FamilyKeyOf(cell));
  }
}

/// Returns whether a cell is meshed or gets hexes as a barrier. The label of a cell beyond the
/// local box is unknown; it counts as void.
bool CoarseHexes::HasHexes(const OctreeKeys::LevelIndex& cell) const
{
  const int label = LabelOfLeaf(this->Grid, this->Labels, cell);
  return IsMeshed(label, this->MeshVoid) ||
    (label == 0 && this->Narrow &&
      this->Narrow->Has(this->Grid.Finest().Linear(this->Grid.NearestCell(cell.Level, cell.At))));
}

/// Returns whether the hexes of a cell are made. The position of a point on or in an owned cell
/// depends on all hexes around it. These are in cells of its level around the cell of the
/// previous level in which the point was made, so a cell is needed if its parent is near. Void is
/// needed only if it is meshed or narrow. The label of a cell beyond the local box is unknown, and
/// its hexes are made.
bool CoarseHexes::IsRequested(const OctreeKeys::LevelIndex& cell) const
{
  const bool isNear = cell.Level == 0 ? this->Grid.IsNear(0, cell.At)
                                      : this->Grid.IsNear(cell.Level - 1, ParentOfCell(cell.At));
  return isNear &&
    (LabelOfLeaf(this->Grid, this->Labels, cell) == UnknownLabel || this->HasHexes(cell));
}

/// Calls visit(key, cell, corners) for all requested hexes, by key.
template <class Visitor>
void CoarseHexes::ForHexes(const Visitor& visit)
{
  const OctreeKeys& lattice = this->Grid.Lattice();
  const CartesianGrid& base = this->Grid.Base();
  std::array<Corner, 8> corners;
  Index hex = 0;
  const auto visitUpTo = [&](Index end)
  {
    for (; hex < this->TheRefined.NumberOfHexes() && this->TheRefined.HexKeys[hex] < end; ++hex)
    {
      for (int c = 0; this->Requested[hex] && c < 8; ++c)
      {
        const Index point = this->TheRefined.Hexes[8 * hex + VtkCorner[c]];
        const Index key = this->TheRefined.PointKeys[point];
        const OctreeKeys::LevelIndex node = lattice.NodeOfKey(key);
        corners[c] = { &this->NumberOf(point, node), node, key };
      }
      if (this->Requested[hex])
      {
        const Index key = this->TheRefined.HexKeys[hex];
        visit(key, lattice.HexOfKey(key), corners);
      }
    }
  };
  ForUntouchedCells(base, this->Region, this->TheRefined,
    [&](const Index3& cell)
    {
      const Index key = lattice.HexKey(0, cell, 0);
      visitUpTo(key);
      if (!this->IsRequested({ 0, cell, 0 }))
      {
        return;
      }
      for (int c = 0; c < 8; ++c)
      {
        const Index3 node = CornerOfCell(cell, c);
        corners[c] = { &this->NodeNumber[base.Linear(node)], { 0, node, 0 },
          lattice.NodeKey(0, node, 0) };
      }
      visit(key, OctreeKeys::LevelIndex{ 0, cell, 0 }, corners);
    });
  visitUpTo(std::numeric_limits<Index>::max());
}

/// Returns the number of a point of TheRefined.
int& CoarseHexes::NumberOf(Index point, const OctreeKeys::LevelIndex& index)
{
  return index.Level == 0 && index.Slot == 0 ? this->NodeNumber[this->Grid.Base().Linear(index.At)]
                                             : this->PointNumber[point];
}

/// Returns whether a point is a lattice node that finest cells also have.
bool CoarseHexes::IsPointOfFine(const OctreeKeys::LevelIndex& node) const
{
  const Index3 finest = this->Grid.FinestNode(node.Level, node.At);
  return node.Slot == 0 && this->Grid.Finest().HexBox().Touches(finest) &&
    this->Grid.TouchesFine(finest);
}

/// Returns the number of points of a node.
int CoarseHexes::CountPoints(Index key) const
{
  const Index n = this->HasBuffers ? this->FindSplit(key) : -1;
  return n < 0 ? 1 : 1 + this->TheSplits.CountInner(n);
}

void CoarseHexes::MarkPoints()
{
  this->PointNumber.assign(this->TheRefined.PointKeys.size(), Unused);
  this->ForHexes(
    [this](Index key, const OctreeKeys::LevelIndex&, const std::array<Corner, 8>& corners)
    {
      ++this->HexCount;
      const int faces = this->BufferFaces(key);
      for (int face = 0; face < 6; ++face)
      {
        this->HexCount += faces >> face & 1;
      }
      for (const Corner& corner : corners)
      {
        if (*corner.Number == Unused)
        {
          *corner.Number = this->IsPointOfFine(corner.Node) ? Fine : Used;
        }
      }
    });
}

/// Calls visit(number, key, position) for all points that are used, by key.
template <class Visitor>
void CoarseHexes::ForPoints(const Visitor& visit)
{
  const CartesianGrid& base = this->Grid.Base();
  const std::vector<Index>& keys = this->TheRefined.PointKeys;
  Index point = 0;
  const auto visitPoint = [&](int& number)
  {
    const double* x = this->TheRefined.Points.data() + 3 * point;
    if (number != Unused)
    {
      visit(number, keys[point], Vector3{ { x[0], x[1], x[2] } });
    }
  };
  const auto visitUpTo = [&](Index key)
  {
    for (; point < this->TheRefined.NumberOfPoints() && keys[point] < key; ++point)
    {
      visitPoint(this->PointNumber[point]);
    }
  };
  const auto visitNode = [&](const Index3& p)
  {
    const Index key = this->Grid.Lattice().NodeKey(0, p, 0);
    int& number = this->NodeNumber[base.Linear(p)];
    visitUpTo(key);
    if (point < this->TheRefined.NumberOfPoints() && keys[point] == key)
    {
      visitPoint(number);
      ++point;
    }
    else if (number != Unused)
    {
      visit(number, key, base.NodePoint(p));
    }
  };
  ForCells(NodesOf(this->Region), visitNode);
  visitUpTo(std::numeric_limits<Index>::max());
}

void CoarseHexes::NumberPoints()
{
  this->ForPoints(
    [this](int& number, Index key, const Vector3&)
    {
      if (number != Fine)
      {
        number = static_cast<int>(this->PointCount);
        this->PointCount += this->CountPoints(key);
      }
    });
}

OctreeKeys::LevelIndex CoarseHexes::AnchorOf(const Mesh& mesh, Index pointId) const
{
  const bool isCoarse = IsCoarsePoint(this->Grid, pointId, mesh.Ids.PointSlots);
  const OctreeKeys::LevelIndex finest{ this->Grid.NumberOfRefinements(),
    NodeOfPoint(this->Grid.Finest(), mesh, pointId), 0 };
  if (!isCoarse && this->Grid.IsFineAround(finest.At))
  {
    return finest;
  }
  const Index key = KeyOfPoint(this->Grid, pointId, mesh.Ids.PointSlots);
  const Index anchor = AnchorOfPoint(this->Grid.Families(), this->TheRefined, key);
  if (anchor >= 0)
  {
    return this->Grid.Lattice().NodeOfKey(anchor);
  }
  return isCoarse ? this->Grid.Lattice().NodeOfKey(key) : finest;
}

/// Frees all data except the parts that Refined promises.
void CoarseHexes::DropParts()
{
  RefinedMesh kept;
  kept.PointKeys.swap(this->TheRefined.PointKeys);
  kept.Anchors.swap(this->TheRefined.Anchors);
  kept.TouchedCells.swap(this->TheRefined.TouchedCells);
  this->TheRefined = std::move(kept);
  this->NodeNumber = Buffer<int>();
  std::vector<int>().swap(this->PointNumber);
  std::vector<unsigned char>().swap(this->Requested);
}

/// Writes points and hexes one after another.
class CoarseHexes::Writer
{
public:
  Writer(CoarseHexes& coarse, Mesh& mesh, Index firstPoint, Index firstHex,
    const FinePoints& finePoints) :
    Coarse(coarse), Result(mesh), FirstPoint(firstPoint), Hex(firstHex), Finest(finePoints)
  {
  }

  /// Adds the points of a node that no finest cell has.
  /// @param number  number of the first point
  void AddPoints(int number, Index key, const Vector3& x)
  {
    Index point = this->FirstPoint + number;
    this->SetPoint(point++, key, 0, x);
    const Index n = this->Coarse.FindSplit(key);
    if (n < 0)
    {
      return;
    }
    this->Coarse.SplitPoint[n] = this->FirstPoint + number;
    const SplitNodes& splits = this->Coarse.TheSplits;
    int rank = 0;
    for (const int* label = splits.LabelsBegin(n); label != splits.LabelsEnd(n); ++label, ++rank)
    {
      if (this->Coarse.HasBuffers && splits.HasInner(n, rank))
      {
        this->SetPoint(point++, key, 1 + rank, splits.InnerPoint(n, rank));
      }
    }
  }

  void AddHex(Index key, const OctreeKeys::LevelIndex& cell, const std::array<Corner, 8>& corners)
  {
    this->Label = LabelOfLeaf(this->Coarse.Grid, this->Coarse.Labels, cell);
    for (int c = 0; c < 8; ++c)
    {
      this->SetCorner(c, corners[c]);
    }
    this->SetHex(key, 0, this->Inner);
    const int faces = this->Coarse.BufferFaces(key);
    for (int face = 0; face < 6; ++face)
    {
      if (faces >> face & 1)
      {
        this->SetHex(key, 1 + face, BufferHex(this->First, this->Inner, face));
      }
    }
  }

private:
  void SetPoint(Index point, Index key, int slot, const Vector3& x)
  {
    this->Result.SetPoint(
      point, x, PointId(this->Coarse.Grid, key, this->Result.Ids.PointSlots, slot));
  }

  void SetCorner(int c, const Corner& corner)
  {
    Index &first = this->First[c], &inner = this->Inner[c];
    if (*corner.Number == Fine)
    {
      const Index p = this->Coarse.FinestNode(corner.Node);
      first = this->Finest.First(p);
      inner = this->Finest.Inner(p, this->Label);
      return;
    }
    first = inner = this->FirstPoint + *corner.Number;
    const Index n = this->Coarse.HasBuffers ? this->Coarse.FindSplit(corner.Key) : -1;
    if (n >= 0)
    {
      const SplitNodes& splits = this->Coarse.TheSplits;
      inner += 1 + splits.NumberOfInner(n, this->Label);
    }
  }

  void SetHex(Index key, int slot, const std::array<Index, 8>& corners)
  {
    this->Result.SetElement(this->Hex++, InVtkOrder(corners),
      ElementId(this->Coarse.Grid, key, this->Result.Ids.ElementSlots, slot), this->Label);
  }

  CoarseHexes& Coarse;
  Mesh& Result;
  Index FirstPoint, Hex;
  const FinePoints& Finest;
  int Label = UnknownLabel;              // label of the current hex
  std::array<Index, 8> First{}, Inner{}; // points of the current hex, numbered by bits
};

/// Moves the inner points that finest cells share with these hexes, because they must also be
/// inside their labels here.
void CoarseHexes::SetFinePoints(Mesh& mesh, const FinePoints& finePoints)
{
  const OctreeKeys& lattice = this->Grid.Lattice();
  for (Index n = 0; n < this->TheSplits.Count(); ++n)
  {
    const OctreeKeys::LevelIndex node = lattice.NodeOfKey(this->TheSplits.Keys[n]);
    if (!this->IsPointOfFine(node))
    {
      continue;
    }
    const Index p = this->FinestNode(node);
    this->SplitPoint[n] = finePoints.First(p);
    int rank = 0;
    for (const int* label = this->TheSplits.LabelsBegin(n); label != this->TheSplits.LabelsEnd(n);
         ++label, ++rank)
    {
      if (this->HasBuffers && this->TheSplits.HasInner(n, rank))
      {
        const Vector3& x = this->TheSplits.InnerPoint(n, rank);
        std::copy(x.begin(), x.end(), mesh.Points.data() + 3 * finePoints.Inner(p, *label));
      }
    }
  }
}

void CoarseHexes::Fill(Mesh& mesh, Index firstPoint, Index firstHex, const FinePoints& finePoints)
{
  this->SplitPoint.assign(this->TheSplits.Count(), -1);
  Writer writer(*this, mesh, firstPoint, firstHex, finePoints);
  this->ForPoints(
    [&](int number, Index key, const Vector3& x)
    {
      if (number != Fine)
      {
        writer.AddPoints(number, key, x);
      }
    });
  this->ForHexes([&](Index key, const OctreeKeys::LevelIndex& cell,
                   const std::array<Corner, 8>& corners) { writer.AddHex(key, cell, corners); });
  this->SetFinePoints(mesh, finePoints);
  this->DropParts();
}

} // namespace vfm
