#include "Tet/LatticeTopology.h"

#include "Tet/CoarseTets.h"
#include "Tet/LatticeSnappedTets.h"
#include "Tet/LatticeStencils.h"
#include "Tet/NonManifoldNodes.h"

#include <atomic>
#include <bitset>
#include <utility>

namespace vfm
{
namespace
{

class LatticeTetBuilder
{
public:
  LatticeTetBuilder(const CartesianGrid& grid, const LatticeNodes& nodes, bool meshVoid,
    const Partition& partition, Runtime& runtime, const CoarseTets& coarse) :
    Grid(grid),
    Box(grid.HexBox()),
    MeshVoid(meshVoid),
    Parts(partition),
    Run(runtime),
    Coarse(coarse),
    Levels(coarse.Levels()),
    Tables(LatticeTables::Get()),
    Nodes(nodes),
    Slots(grid.NumberOfEntries()),
    FirstPoint(grid.NumberOfEntries())
  {
    this->PlaceShapes();
  }

  TetTopology Build()
  {
    ForRows(NodesOf(this->Box), [this](Index j, Index k) { this->Rows.emplace_back(j, k); });
    if (!this->Levels.IsUniform())
    {
      this->OverRows([this](Row& row) { this->MarkBesideCoarse(row); });
    }
    this->OverRows([this](Row& row) { this->Count(row); });
    this->SettleSnappedTets();
    this->MakePoints();
    this->MakeTets();
    return std::move(this->Result);
  }

private:
  /// The blocks of one row along x.
  struct Row
  {
    Row(Index j, Index k) : J(j), K(k) {}
    Index J, K;
    Index Points = 0, Tets = 0; // how many; then the first
    std::vector<SnappedTet> Snapped;
    std::vector<SnappedFace> Faces;
  };

  /// A shape on this grid.
  struct PlacedShape
  {
    std::array<const int*, 4> Labels; // of its nodes, at the block
    std::array<Index, 16> Block;      // of the point of each set, from the block
    std::array<Index, 16> Key;        // the same in node keys
    std::array<int, 16> Slot;
  };

  void PlaceShapes()
  {
    const Index3& n = this->Grid.Global().Upper;
    for (int s = 0; s < LatticeTables::Shapes; ++s)
    {
      const LatticeTet& tet = this->Tables.Shape(s);
      PlacedShape& shape = this->Shapes[s];
      shape.Slot = tet.Slot;
      for (int set = 1; set < 16; ++set)
      {
        const HalfPoint& b = tet.Block[set];
        shape.Block[set] = b[0] + b[1] * this->Grid.Stride(1) + b[2] * this->Grid.Stride(2);
        shape.Key[set] = b[0] + (n[0] + 1) * (b[1] + (n[1] + 1) * b[2]);
      }
      for (int i = 0; i < 4; ++i)
      {
        shape.Labels[i] =
          this->Nodes.Labels(LatticeNodes::Kind(tet.Slot[1 << i])) + shape.Block[1 << i];
      }
    }
  }

  template <class Body>
  void OverRows(const Body& body)
  {
    ForEach(this->Run, this->Rows.size(), [&](Index row) { body(this->Rows[row]); });
  }

  /// Whether all lattice tets around a block's three faces have one label.
  bool IsUniform(Index n, const Index3& block) const
  {
    const int* vertices = this->Nodes.Labels(LatticeNodes::Vertex) + n;
    const int* centres = this->Nodes.Labels(LatticeNodes::Centre) + n;
    const int label = *centres;
    int differs = label < 0;
    for (int c = 0; c < 8; ++c)
    {
      differs |= vertices[this->Grid.CornerOffset(c)] ^ label;
    }
    for (int a = 0; a < 3; ++a)
    {
      differs |= (centres[-this->Grid.Stride(a)] ^ label) | (block[a] == this->Box.Lower[a]) |
        (block[a] == this->Box.Upper[a]);
    }
    return !differs && this->HasFineFaces(block);
  }

  /// Whether the cells at the face along an axis are fine.
  bool IsFineFace(const Index3& block, int axis) const
  {
    Index3 below = block;
    --below[axis];
    return this->Levels.IsFine(block) && this->Levels.IsFine(below); // beyond the domain as inside
  }

  bool HasFineFaces(const Index3& block) const
  {
    return this->Levels.IsUniform() ||
      (this->IsFineFace(block, 0) && this->IsFineFace(block, 1) && this->IsFineFace(block, 2));
  }

  /// Points that coarse tets have in common with fine cells: at the rim no other tets may have them.
  void MarkBesideCoarse(const Row& row)
  {
    Index3 p{ { this->Box.Lower[0], row.J, row.K } };
    Index n = this->Grid.Linear(p);
    for (; p[0] <= this->Box.Upper[0]; ++p[0], ++n)
    {
      if (this->Levels.IsFineAround(p) || !this->Levels.TouchesFine(p) ||
        !IsMeshed(this->Nodes.Labels(LatticeNodes::Vertex)[n], this->MeshVoid))
      {
        continue;
      }
      this->Mark(n, 1);
      for (int c = 0; c < 8; ++c)
      {
        const Index3 cell = CellOfStar(p, c);
        if (this->Box.Contains(cell) && this->Levels.IsFine(cell))
        {
          this->Mark(this->Grid.Linear(cell), 2);
        }
      }
    }
  }

  /// Calls whole(block, n) where all tets of a block have one label, else cut(block, n, shape, t, labels) for every lattice
  /// tet of the block.
  template <class Whole, class Cut>
  void OverTets(const Row& row, const Whole& whole, const Cut& cut) const
  {
    Index3 block{ { this->Box.Lower[0], row.J, row.K } };
    Index n = this->Grid.Linear(block);
    for (; block[0] <= this->Box.Upper[0]; ++block[0], ++n)
    {
      if (this->IsUniform(n, block))
      {
        whole(block, n);
        continue;
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        int count = 0;
        const int first = this->FirstShape(block, axis, count);
        for (int t = 0; t < count; ++t)
        {
          const PlacedShape& shape = this->Shapes[first + t];
          cut(block, n, first + t, 4 * axis + t,
            std::array<int, 4>{
              { shape.Labels[0][n], shape.Labels[1][n], shape.Labels[2][n], shape.Labels[3][n] } });
        }
      }
    }
  }

  /// The first shape of a face and how many lattice tets it has: 4, 2 on the domain, 0 outside the box.
  int FirstShape(const Index3& block, int axis, int& count) const
  {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const bool isFace = block[u] < this->Box.Upper[u] && block[v] < this->Box.Upper[v] &&
      this->IsFineFace(block, axis);
    const bool atLower = block[axis] == 0, atUpper = block[axis] == this->Grid.Global().Upper[axis];
    if (atLower || atUpper)
    {
      count = isFace ? 2 : 0;
      return LatticeTables::DomainShape(axis, atUpper, LatticeTables::Diagonal(block));
    }
    const bool isInside =
      block[axis] > this->Box.Lower[axis] && block[axis] < this->Box.Upper[axis];
    count = isFace && isInside ? 4 : 0;
    return LatticeTables::InnerShape(axis);
  }

  /// The points of a block that are used; other rows may add to them meanwhile.
  void Mark(Index block, std::uint64_t slots)
  {
    if (slots & ~this->Slots[block].load(std::memory_order_relaxed))
    {
      this->Slots[block].fetch_or(slots, std::memory_order_relaxed);
    }
  }

  void MarkSets(const PlacedShape& shape, Index n, std::uint32_t sets)
  {
    for (int set = 1; set < 16; ++set)
    {
      if (sets >> set & 1)
      {
        this->Mark(n + shape.Block[set], std::uint64_t(1) << shape.Slot[set]);
      }
    }
  }

  void Count(Row& row)
  {
    const int* centres = this->Nodes.Labels(LatticeNodes::Centre);
    this->OverTets(
      row,
      [&](const Index3&, Index n)
      {
        if (IsMeshed(centres[n], this->MeshVoid))
        {
          row.Tets += 12;
          for (int c = 0; c < 8; ++c)
          {
            this->Mark(n + this->Grid.CornerOffset(c), 1);
          }
          this->Mark(n, 2);
          for (int a = 0; a < 3; ++a)
          {
            this->Mark(n - this->Grid.Stride(a), 2);
          }
        }
      },
      [&](const Index3& block, Index n, int shape, int tet, const std::array<int, 4>& labels)
      { this->CountTet(row, block, n, shape, tet, labels); });
  }

  void CountTet(
    Row& row, const Index3& block, Index n, int shape, int tet, const std::array<int, 4>& labels)
  {
    const PlacedShape& placed = this->Shapes[shape];
    const int snapped =
      (labels[0] < 0) | (labels[1] < 0) << 1 | (labels[2] < 0) << 2 | (labels[3] < 0) << 3;
    const Index key = this->Grid.NodeKey(block);
    const auto faceId = [&](int set)
    { return TetIds.PointSlots * (key + placed.Key[set]) + placed.Slot[set] + 1; };
    if (snapped == 15)
    {
      row.Snapped.push_back({ key * TetIds.ElementSlots + tet * PiecesPerTet + 1, block, shape,
        this->LabelOfMean(block, shape), { { faceId(14), faceId(13), faceId(11), faceId(7) } } });
      return;
    }
    const LatticeStencil& stencil = this->Tables.Stencil(shape, labels);
    for (int r = 0; r < stencil.Count; ++r)
    {
      const LatticeStencil::Region& region = stencil.List[r];
      if (IsMeshed(labels[region.Node], this->MeshVoid))
      {
        row.Tets += region.Last - region.First;
        this->MarkSets(placed, n, region.Points);
      }
    }
    if (snapped == 14 || snapped == 13 || snapped == 11 || snapped == 7)
    {
      row.Faces.push_back({ faceId(snapped), labels[stencil.List[0].Node] });
    }
  }

  int LabelOfMean(const Index3& block, int shape) const
  {
    const LatticeTet& tet = this->Tables.Shape(shape);
    std::array<LatticeNodes::Node, 4> nodes;
    for (int i = 0; i < 4; ++i)
    {
      nodes[i] = { LatticeNodes::Kind(tet.Slot[1 << i]), block };
      for (int a = 0; a < 3; ++a)
      {
        nodes[i].Position[a] += tet.Block[1 << i][a];
      }
    }
    return this->Nodes.LabelOfMean(nodes);
  }

  /// Collective.
  void SettleSnappedTets()
  {
    std::vector<SnappedTet> tets;
    std::vector<SnappedFace> faces;
    for (Row& row : this->Rows)
    {
      tets.insert(tets.end(), row.Snapped.begin(), row.Snapped.end());
      faces.insert(faces.end(), row.Faces.begin(), row.Faces.end());
      row.Faces = {};
    }
    vfm::SettleSnappedTets(tets, faces, this->Grid, this->Parts);
    auto next = tets.begin();
    for (Row& row : this->Rows)
    {
      for (SnappedTet& tet : row.Snapped)
      {
        tet.Label = (next++)->Label;
        if (IsMeshed(tet.Label, this->MeshVoid))
        {
          ++row.Tets;
          this->MarkSets(this->Shapes[tet.Shape], this->Grid.Linear(tet.Block),
            1 << 1 | 1 << 2 | 1 << 4 | 1 << 8);
        }
      }
    }
  }

  void MakePoints()
  {
    this->OverRows(
      [this](Row& row)
      {
        const Index n = this->Grid.Linear({ { this->Box.Lower[0], row.J, row.K } });
        for (Index i = 0; i <= this->Box.Size(0); ++i)
        {
          row.Points += CountBits(this->Slots[n + i]);
        }
      });
    Index total = 0;
    for (Row& row : this->Rows)
    {
      row.Points = std::exchange(total, total + row.Points);
    }
    this->FinePoints = total;
    total += this->Coarse.NumberOfPoints();
    CheckNumberOfPoints(total, this->Run.Group());
    Mesh& mesh = this->Result.Tets;
    mesh.Corners = 4;
    mesh.Ids = TetIds;
    mesh.Levels = this->Levels.shared_from_this();
    mesh.Points = Buffer<double>(3 * total);
    mesh.PointIds = Buffer<Index>(total);
    this->Result.Positions.resize(total);
    this->OverRows([this](Row& row) { this->FillPoints(row); });
  }

  static int CountBits(std::uint64_t slots)
  {
    return static_cast<int>(
      slots < 4 ? (slots & 1) + (slots >> 1) : std::bitset<64>(slots).count());
  }

  void FillPoints(const Row& row)
  {
    Mesh& mesh = this->Result.Tets;
    Index point = row.Points;
    Index3 block{ { this->Box.Lower[0], row.J, row.K } };
    Index n = this->Grid.Linear(block);
    for (; block[0] <= this->Box.Upper[0]; ++block[0], ++n)
    {
      this->FirstPoint[n] = static_cast<int>(point);
      const Index id = this->Grid.NodeKey(block) * TetIds.PointSlots + 1;
      int slot = 0;
      for (std::uint64_t rest = this->Slots[n]; rest != 0; rest >>= 1, ++slot)
      {
        if (rest & 1)
        {
          const Vector3 x = this->Tables.StartOf(this->Grid, block, slot);
          std::copy(x.begin(), x.end(), mesh.Points.data() + 3 * point);
          mesh.PointIds[point] = id + slot;
          this->Result.Positions[point] = this->PositionOf(block, n, slot);
          ++point;
        }
      }
    }
  }

  PointPosition PositionOf(const Index3& block, Index n, int slot) const
  {
    if (slot > 1 || this->Nodes.Labels(LatticeNodes::Kind(slot))[n] == LatticeNodes::Snapped)
    {
      return PointPosition::OnInterface;
    }
    return slot == LatticeNodes::Vertex && this->Grid.DomainSides(block) != 0
      ? PointPosition::OnDomain
      : PointPosition::Inside;
  }

  void MakeTets()
  {
    Index total = 0;
    for (Row& row : this->Rows)
    {
      row.Tets = std::exchange(total, total + row.Tets);
    }
    const Index fineTets = total;
    total += this->Coarse.NumberOfTets();
    Mesh& mesh = this->Result.Tets;
    mesh.Elements = Buffer<Index>(4 * total);
    mesh.ElementIds = Buffer<Index>(total);
    mesh.Material = Buffer<int>(total);
    this->OverRows([this](Row& row) { this->FillTets(row); });
    this->Coarse.Fill(this->Result, this->FinePoints, fineTets,
      [this](Index block, Index slot) { return this->PointAt(block, static_cast<int>(slot)); });
  }

  Index PointAt(Index block, int slot) const
  {
    const std::uint64_t below =
      this->Slots[block].load(std::memory_order_relaxed) & ((std::uint64_t(1) << slot) - 1);
    return this->FirstPoint[block] + CountBits(below);
  }

  void FillTets(const Row& row)
  {
    const int* centres = this->Nodes.Labels(LatticeNodes::Centre);
    Index tet = row.Tets;
    auto snapped = row.Snapped.begin();
    this->OverTets(
      row,
      [&](const Index3& block, Index n)
      {
        if (IsMeshed(centres[n], this->MeshVoid))
        {
          this->FillUniform(
            tet, n, this->Grid.NodeKey(block) * TetIds.ElementSlots + 1, centres[n]);
          tet += 12;
        }
      },
      [&](const Index3& block, Index n, int shape, int slot, const std::array<int, 4>& labels)
      {
        const Index id = this->Grid.NodeKey(block) * TetIds.ElementSlots + slot * PiecesPerTet + 1;
        const int ownLabel =
          labels[0] + labels[1] + labels[2] + labels[3] == 4 * LatticeNodes::Snapped
          ? (snapped++)->Label
          : LatticeNodes::Snapped;
        this->FillCut(tet, n, shape, id, labels, ownLabel);
      });
  }

  void FillUniform(Index tet, Index n, Index id, int label)
  {
    Index vertices[8];
    for (int c = 0; c < 8; ++c)
    {
      vertices[c] = this->FirstPoint[n + this->Grid.CornerOffset(c)];
    }
    const Index centre = this->PointAt(n, 1);
    for (int axis = 0; axis < 3; ++axis)
    {
      const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
      const Index below = this->PointAt(n - this->Grid.Stride(axis), 1);
      const Index corners[5] = { vertices[0], vertices[u], vertices[u | v], vertices[v],
        vertices[0] };
      for (int t = 0; t < 4; ++t)
      {
        this->SetTet(tet++, { { below, corners[t], corners[t + 1], centre } },
          id + (4 * axis + t) * PiecesPerTet, label);
      }
    }
  }

  /// The pieces of a lattice tet; ownLabel: when all nodes are snapped.
  void FillCut(
    Index& tet, Index n, int shape, Index id, const std::array<int, 4>& labels, int ownLabel)
  {
    const LatticeStencil& stencil = this->Tables.Stencil(shape, labels);
    const PlacedShape& placed = this->Shapes[shape];
    const auto labelOf = [&](int r)
    { return stencil.List[r].Node < 0 ? ownLabel : labels[stencil.List[r].Node]; };
    std::array<int, 4> order{ { 0, 1, 2, 3 } };
    for (int r = 1; r < stencil.Count; ++r)
    {
      for (int q = r; q > 0 && labelOf(order[q]) < labelOf(order[q - 1]); --q)
      {
        std::swap(order[q], order[q - 1]);
      }
    }
    for (int r = 0; r < stencil.Count; ++r)
    {
      const LatticeStencil::Region& region = stencil.List[order[r]];
      const int label = labelOf(order[r]);
      for (int piece = region.First; piece < region.Last; ++piece, ++id)
      {
        if (IsMeshed(label, this->MeshVoid))
        {
          std::array<Index, 4> points;
          for (int i = 0; i < 4; ++i)
          {
            const int set = stencil.Tets[piece][i];
            points[i] = this->PointAt(n + placed.Block[set], placed.Slot[set]);
          }
          this->SetTet(tet++, points, id, label);
        }
      }
    }
  }

  void SetTet(Index tet, const std::array<Index, 4>& points, Index id, int label)
  {
    Mesh& mesh = this->Result.Tets;
    std::copy(points.begin(), points.end(), mesh.Elements.data() + 4 * tet);
    mesh.ElementIds[tet] = id;
    mesh.Material[tet] = label;
  }

  const CartesianGrid& Grid;
  IndexBox Box;
  bool MeshVoid;
  const Partition& Parts;
  Runtime& Run;
  const CoarseTets& Coarse;
  const RefinedGrid& Levels;
  const LatticeTables& Tables;
  const LatticeNodes& Nodes;
  std::array<PlacedShape, LatticeTables::Shapes> Shapes;
  std::vector<Row> Rows;
  /// By block: the slots in use, and the first point.
  std::vector<std::atomic<std::uint64_t>, LargeAllocator<std::atomic<std::uint64_t>>> Slots;
  std::vector<int, LargeAllocator<int>> FirstPoint;
  Index FinePoints = 0;
  TetTopology Result;
};

} // namespace

/// Ends: every round unsnaps a node, and where none is snapped nothing is non-manifold.
LatticeTets BuildLatticeTets(const CartesianGrid& grid, LatticeNodes& nodes, bool meshVoid,
  const Partition& partition, Runtime& runtime, const CoarseTets& coarse)
{
  CheckIds(grid, TetIds.ElementSlots);
  for (;;)
  {
    LatticeTets tets;
    tets.Topology = LatticeTetBuilder(grid, nodes, meshVoid, partition, runtime, coarse).Build();
    tets.Faces = FindTetFaces(tets.Topology, grid);
    const std::vector<Index> nonManifold = GatherItems(
      runtime.Group(), FindNonManifoldNodes(tets.Topology, tets.Faces, grid, partition));
    if (nonManifold.empty())
    {
      return tets;
    }
    for (Index id : nonManifold)
    {
      const Index3 block = NodeOfPoint(grid, tets.Topology.Tets, id);
      const bool isVertex = SlotOfPoint(id) == VertexSlot;
      if (isVertex ? grid.HexBox().Touches(block) : grid.HexBox().Contains(block))
      {
        nodes.Unsnap({ isVertex ? LatticeNodes::Vertex : LatticeNodes::Centre, block });
      }
    }
  }
}

std::vector<Index> FindLatticeInterfaces(const CartesianGrid& grid, const LatticeNodes& nodes)
{
  const int* vertices = nodes.Labels(LatticeNodes::Vertex);
  const int* centres = nodes.Labels(LatticeNodes::Centre);
  const IndexBox box = grid.HexBox();
  std::vector<Index> found;
  ForCells(NodesOf(box),
    [&](const Index3& p)
    {
      const Index n = grid.Linear(p);
      bool differs = vertices[n] == LatticeNodes::Snapped;
      for (int c = 0; c < 8; ++c)
      {
        differs = differs ||
          (box.Contains(CellOfStar(p, c)) && centres[grid.CellOfNode(n, c)] != vertices[n]);
      }
      if (differs)
      {
        found.push_back(n);
      }
    });
  return found;
}

} // namespace vfm
