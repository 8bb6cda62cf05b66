#include "Hex/CoarseHexes.h"

#include "Hex/HexTopology.h"
#include "Hex/TransitionSmoothing.h"

#include <limits>

namespace vfm
{

CoarseHexes::CoarseHexes(
  const RefinedGrid& grid, const LabelArray& labels, const Options& options, Runtime& runtime) :
  Grid(grid), Labels(labels), MeshVoid(options.MeshVoid), HasBuffers(options.HasBuffers)
{
  if (grid.IsUniform())
  {
    return;
  }
  this->Region = grid.Base().Extended(grid.HasFineInterfaces() ? 1 : 2);
  this->TheRefined = MakeRefinedMesh(grid.Families(), this->Region, false);
  this->NodeNumber = Buffer<int>(grid.Base().NumberOfEntries(), Unused);
  SmoothTransitions(grid.Lattice(), this->TheRefined, runtime, true, options.AsCubes);
  if (!grid.HasFineInterfaces())
  {
    this->TheSplits = SplitNodes(grid, this->TheRefined, this->Region, labels, options.MeshVoid);
  }
  for (Index key : this->TheRefined.HexKeys)
  {
    this->Wanted.push_back(this->IsWanted(grid.Lattice().HexOfKey(key)));
  }
  this->MarkPoints();
  this->NumberPoints();
}

/// A point on or in an owned cell is placed by all hexes around it. These lie in cells of its level around the cell of the level
/// before that it was made in, so a cell is wanted where its parent is near. Void is not wanted unless it is meshed; the label of a
/// cell that lies beyond the local box is not known, and its hexes are made.
bool CoarseHexes::IsWanted(const OctreeKeys::LevelIndex& cell) const
{
  const bool isNear = cell.Level == 0
    ? this->Grid.IsNear(0, cell.At)
    : this->Grid.IsNear(cell.Level - 1, { { cell.At[0] >> 1, cell.At[1] >> 1, cell.At[2] >> 1 } });
  return isNear && (this->MeshVoid || LabelOfLeaf(this->Grid, this->Labels, cell) != 0);
}

/// Calls onCell(base cell) and onHex(hex of Refined) for all wanted hexes, by key.
template <class OnCell, class OnHex>
void CoarseHexes::ForHexes(const OnCell& onCell, const OnHex& onHex) const
{
  const OctreeKeys& lattice = this->Grid.Lattice();
  const CartesianGrid& base = this->Grid.Base();
  Index hex = 0;
  const auto visitUpTo = [&](Index key)
  {
    for (; hex < this->TheRefined.NumberOfHexes() && this->TheRefined.HexKeys[hex] < key; ++hex)
    {
      if (this->Wanted[hex])
      {
        onHex(hex);
      }
    }
  };
  ForUntouchedCells(base, this->Region, this->TheRefined,
    [&](const Index3& cell)
    {
      visitUpTo(lattice.HexKey(0, cell, 0));
      if (this->IsWanted({ 0, cell, 0 }))
      {
        onCell(cell);
      }
    });
  visitUpTo(std::numeric_limits<Index>::max());
}

/// Of a point of Refined.
int& CoarseHexes::NumberOf(Index point, const OctreeKeys::LevelIndex& index)
{
  return index.Level == 0 && index.Slot == 0 ? this->NodeNumber[this->Grid.Base().Linear(index.At)]
                                             : this->PointNumber[point];
}

/// Whether a node of the lattice is a point of the finest cells.
bool CoarseHexes::IsPointOfFine(int level, const Index3& node) const
{
  const Index3 finest = this->Grid.FinestNode(level, node);
  return this->Grid.Finest().HexBox().Touches(finest) && this->Grid.TouchesFine(finest);
}

/// How many points a node has.
int CoarseHexes::CountPoints(Index key) const
{
  const Index n = this->HasBuffers ? this->FindSplit(key) : -1;
  return n < 0 ? 1
               : 1 +
      static_cast<int>(std::count_if(this->TheSplits.LabelsBegin(n), this->TheSplits.LabelsEnd(n),
        [this](int label) { return label > 0 || this->MeshVoid; }));
}

void CoarseHexes::MarkPoints()
{
  const OctreeKeys& lattice = this->Grid.Lattice();
  this->PointNumber.assign(this->TheRefined.PointKeys.size(), Unused);
  const auto countHexes = [&](Index key)
  {
    ++this->HexCount;
    const int faces = this->BufferFaces(key);
    for (int face = 0; face < 6; ++face)
    {
      this->HexCount += faces >> face & 1;
    }
  };
  const auto markCell = [&](const Index3& cell)
  {
    countHexes(lattice.HexKey(0, cell, 0));
    for (int c = 0; c < 8; ++c)
    {
      const Index3 node = CornerOfCell(cell, c);
      int& number = this->NodeNumber[this->Grid.Base().Linear(node)];
      number = number == Unused ? this->Sort(0, node) : number;
    }
  };
  const auto markHex = [&](Index hex)
  {
    countHexes(this->TheRefined.HexKeys[hex]);
    for (Index at = 8 * hex; at < 8 * hex + 8; ++at)
    {
      const Index point = this->TheRefined.Hexes[at];
      const OctreeKeys::LevelIndex index = lattice.NodeOfKey(this->TheRefined.PointKeys[point]);
      int& number = this->NumberOf(point, index);
      number = index.Slot > 0 ? Used
        : number == Unused    ? this->Sort(index.Level, index.At)
                              : number;
    }
  };
  this->ForHexes(markCell, markHex);
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
  IndexBox nodes = this->Region;
  for (Index& upper : nodes.Upper)
  {
    upper += nodes.NumberOfCells() > 0;
  }
  ForCells(nodes, visitNode);
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
  const bool isCoarse = this->Grid.IsCoarsePoint(pointId, mesh.Ids.PointSlots);
  const OctreeKeys::LevelIndex finest{ this->Grid.NumberOfRefinements(),
    NodeOfPoint(this->Grid.Finest(), mesh, pointId), 0 };
  if (!isCoarse && this->Grid.IsFineAround(finest.At))
  {
    return finest;
  }
  const Index key = this->Grid.KeyOfPoint(pointId, mesh.Ids.PointSlots);
  const Index anchor = AnchorOfPoint(this->Grid.Families(), this->TheRefined, key);
  if (anchor >= 0)
  {
    return this->Grid.Lattice().NodeOfKey(anchor);
  }
  return isCoarse ? this->Grid.Lattice().NodeOfKey(key) : finest;
}

/// Leaves only what Refined tells of.
void CoarseHexes::DropParts()
{
  RefinedMesh kept;
  kept.PointKeys.swap(this->TheRefined.PointKeys);
  kept.Anchors.swap(this->TheRefined.Anchors);
  kept.TouchedCells.swap(this->TheRefined.TouchedCells);
  this->TheRefined = std::move(kept);
  this->NodeNumber = Buffer<int>();
  std::vector<int>().swap(this->PointNumber);
  std::vector<unsigned char>().swap(this->Wanted);
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

  /// The points of a node that no finest cell has; number: of the first.
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
      if (this->Coarse.HasBuffers && this->IsMeshed(*label))
      {
        this->SetPoint(point++, key, 1 + rank, splits.InnerPoint(n, rank));
      }
    }
  }

  void AddCell(const Index3& cell)
  {
    const OctreeKeys& lattice = this->Coarse.Grid.Lattice();
    this->Start({ 0, cell, 0 });
    for (int c = 0; c < 8; ++c)
    {
      const Index3 node = CornerOfCell(cell, c);
      this->SetCorner(c, this->Coarse.NodeNumber[this->Coarse.Grid.Base().Linear(node)],
        { 0, node, 0 }, lattice.NodeKey(0, node, 0));
    }
    this->Finish(lattice.HexKey(0, cell, 0));
  }

  void AddHex(Index hex)
  {
    const RefinedMesh& refined = this->Coarse.TheRefined;
    const OctreeKeys& lattice = this->Coarse.Grid.Lattice();
    this->Start(lattice.HexOfKey(refined.HexKeys[hex]));
    for (int c = 0; c < 8; ++c)
    {
      const Index point = refined.Hexes[8 * hex + VtkCorner[c]];
      const OctreeKeys::LevelIndex index = lattice.NodeOfKey(refined.PointKeys[point]);
      this->SetCorner(c, this->Coarse.NumberOf(point, index), index, refined.PointKeys[point]);
    }
    this->Finish(refined.HexKeys[hex]);
  }

private:
  bool IsMeshed(int label) const { return label > 0 || this->Coarse.MeshVoid; }

  void SetPoint(Index point, Index key, int slot, const Vector3& x)
  {
    std::copy(x.begin(), x.end(), this->Result.Points.data() + 3 * point);
    this->Result.PointIds[point] =
      this->Coarse.Grid.PointId(key, this->Result.Ids.PointSlots, slot);
  }

  void Start(const OctreeKeys::LevelIndex& cell)
  {
    this->Label = LabelOfLeaf(this->Coarse.Grid, this->Coarse.Labels, cell);
  }

  void SetCorner(int corner, int number, const OctreeKeys::LevelIndex& node, Index key)
  {
    Index &first = this->First[corner], &inner = this->Inner[corner];
    if (number == Fine)
    {
      const CartesianGrid& finest = this->Coarse.Grid.Finest();
      const Index p = finest.Linear(this->Coarse.Grid.FinestNode(node.Level, node.At));
      first = this->Finest.First(p);
      inner = this->Finest.Inner(p, this->Label);
      return;
    }
    first = inner = this->FirstPoint + number;
    const Index n = this->Coarse.HasBuffers ? this->Coarse.FindSplit(key) : -1;
    if (n >= 0)
    {
      const SplitNodes& splits = this->Coarse.TheSplits;
      inner += 1 + splits.RankOf(n, this->Label) - (this->IsMeshed(*splits.LabelsBegin(n)) ? 0 : 1);
    }
  }

  void Finish(Index key)
  {
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

  void SetHex(Index key, int slot, const std::array<Index, 8>& corners)
  {
    for (int c = 0; c < 8; ++c)
    {
      this->Result.Elements[8 * this->Hex + VtkCorner[c]] = corners[c];
    }
    this->Result.ElementIds[this->Hex] =
      this->Coarse.Grid.ElementId(key, this->Result.Ids.ElementSlots, slot);
    this->Result.Material[this->Hex] = this->Label;
    ++this->Hex;
  }

  CoarseHexes& Coarse;
  Mesh& Result;
  Index FirstPoint, Hex;
  const FinePoints& Finest;
  int Label = UnknownLabel;              // of the hex at work
  std::array<Index, 8> First{}, Inner{}; // its points, numbered by bits
};

/// The inner points of finest cells beside these hexes: they must be inside their labels here, too.
void CoarseHexes::SetFinePoints(Mesh& mesh, const FinePoints& finePoints)
{
  const OctreeKeys& lattice = this->Grid.Lattice();
  for (Index n = 0; n < this->TheSplits.Count(); ++n)
  {
    const OctreeKeys::LevelIndex node = lattice.NodeOfKey(this->TheSplits.Key(n));
    if (node.Slot != 0 || !this->IsPointOfFine(node.Level, node.At))
    {
      continue;
    }
    const Index p = this->Grid.Finest().Linear(this->Grid.FinestNode(node.Level, node.At));
    this->SplitPoint[n] = finePoints.First(p);
    int rank = 0;
    for (const int* label = this->TheSplits.LabelsBegin(n); label != this->TheSplits.LabelsEnd(n);
         ++label, ++rank)
    {
      if (this->HasBuffers && (*label > 0 || this->MeshVoid))
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
  this->ForHexes(
    [&](const Index3& cell) { writer.AddCell(cell); }, [&](Index hex) { writer.AddHex(hex); });
  this->SetFinePoints(mesh, finePoints);
  this->DropParts();
}

} // namespace vfm
