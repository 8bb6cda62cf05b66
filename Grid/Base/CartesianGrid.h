/**
 * CartesianGrid: a uniform or rectilinear grid of cells, of which this process holds one box plus
 * ghost layers. Cells and nodes are implicit.
 *
 * Indices. (i,j,k) are global. The linear index of the cell (i,j,k) and of the node (i,j,k), its lower
 * corner, is the same number: their arrays have one shape, the local box with one more layer of cells
 * on every side. So the eight cells of a node, the eight nodes of a cell and the neighbours of either
 * are fixed offsets, and every node of the local box has eight cells in memory. The outermost layer
 * mirrors the cell inside it where the stages want a value beyond the domain boundary (labels).
 *
 * Corner c of cell n is node n + Offset(c); cell c of the star of node n is n - Offset(7) + Offset(c).
 * Faces are numbered -x +x -y +y -z +z = 0..5.
 *
 * Keys. NodeKey and CellKey are global, the same on any number of processes.
 */
#pragma once

#include "Base/IndexBox.h"

namespace vfm
{

/// Layers of ghost cells that the stages need around the owned cells. What a stage reads and writes is derived from these two.
constexpr int GhostLayers = 6;
/// Of those, the layers whose hexes are made too, for smoothing and geometry at the rim of a rank's cells. Where interfaces cross
/// levels both are more: LayersFor (Options.h).
constexpr int HexLayers = 2;

class CartesianGrid
{
public:
  /// coordinates: of all nodes of the whole grid, one increasing list an axis (length units of the user).
  /// owned: the cells whose hexes this process makes. ghostLayers: layers of cells held around them. hexLayers: of those, the layers
  /// whose hexes are made too.
  /// Throws InputError when a list has fewer than two entries or does not increase.
  CartesianGrid(std::array<std::vector<double>, 3> coordinates, const IndexBox& owned,
    int ghostLayers = 0, int hexLayers = HexLayers);

  /// The whole grid in one process.
  explicit CartesianGrid(std::array<std::vector<double>, 3> coordinates);

  const IndexBox& Global() const { return this->GlobalBox; }
  const IndexBox& Owned() const { return this->OwnedBox; }
  const IndexBox& Local() const { return this->LocalBox; }
  /// The owned cells and up to levels of the ghost layers around them.
  IndexBox Extended(int levels) const;
  /// The cells whose hexes are made here: the owned ones and those near them.
  IndexBox HexBox() const { return this->Extended(this->HexGhosts); }

  /// Length of every array over cells or nodes.
  Index NumberOfEntries() const { return this->Entries; }
  Index Stride(int axis) const { return this->Strides[axis]; }
  Index Linear(const Index3& p) const
  {
    return (p[0] - this->Origin[0]) + (p[1] - this->Origin[1]) * this->Strides[1] +
      (p[2] - this->Origin[2]) * this->Strides[2];
  }
  Index3 Position(Index n) const
  {
    const Index k = n / this->Strides[2];
    const Index j = (n - k * this->Strides[2]) / this->Strides[1];
    const Index i = n - k * this->Strides[2] - j * this->Strides[1];
    return { { i + this->Origin[0], j + this->Origin[1], k + this->Origin[2] } };
  }

  /// From a cell to its corner c.
  Index CornerOffset(int c) const { return this->Corners[c]; }
  Index NodeOfCell(Index cell, int c) const { return cell + this->Corners[c]; }
  /// Cell c of the star of a node: c has the bit of an axis set when the cell lies on its + side.
  Index CellOfNode(Index node, int c) const { return node + this->Corners[c] - this->Corners[7]; }
  /// The cell across face f.
  Index Neighbour(Index cell, int face) const
  {
    return (face & 1) ? cell + this->Strides[face / 2] : cell - this->Strides[face / 2];
  }
  bool InDomain(const Index3& cell) const { return this->GlobalBox.Contains(cell); }

  Vector3 NodePoint(const Index3& p) const
  {
    return { { this->X[0][p[0]], this->X[1][p[1]], this->X[2][p[2]] } };
  }
  /// The cell that holds a point, between two cells the upper one; beside the domain one beside it.
  Index3 CellAt(const Vector3& point) const;
  const std::array<std::vector<double>, 3>& Coordinates() const { return this->X; }
  const std::vector<double>& Coordinates(int axis) const { return this->X[axis]; }
  double Width(int axis, Index i) const { return this->X[axis][i + 1] - this->X[axis][i]; }
  double CellVolume(const Index3& c) const
  {
    return this->Width(0, c[0]) * this->Width(1, c[1]) * this->Width(2, c[2]);
  }
  /// Cube root of the mean cell volume: the length that makes the grid's numbers near 1.
  double MeanWidth() const;

  Index CellKey(const Index3& c) const
  {
    return (c[2] * this->GlobalBox.Upper[1] + c[1]) * this->GlobalBox.Upper[0] + c[0];
  }
  Index NodeKey(const Index3& p) const
  {
    return (p[2] * (this->GlobalBox.Upper[1] + 1) + p[1]) * (this->GlobalBox.Upper[0] + 1) + p[0];
  }
  Index3 CellOfKey(Index key) const { return Unpack(key, this->GlobalBox.Upper); }
  Index3 NodeOfKey(Index key) const
  {
    const Index3& n = this->GlobalBox.Upper;
    return Unpack(key, { { n[0] + 1, n[1] + 1, n[2] + 1 } });
  }
  /// The cell above a node, on the upper sides of the domain the one below.
  Index3 CellOfBlock(const Index3& node) const
  {
    const Index3& n = this->GlobalBox.Upper;
    return { { std::min(node[0], n[0] - 1), std::min(node[1], n[1] - 1),
      std::min(node[2], n[2] - 1) } };
  }
  /// Nodes of one colour have no cell in common: parity of i, j and k, 0..7.
  static int Colour(const Index3& p)
  {
    return static_cast<int>((p[0] & 1) | (p[1] & 1) << 1 | (p[2] & 1) << 2);
  }
  /// Bit f set when the node lies on side f of the domain.
  int DomainSides(const Index3& node) const
  {
    int sides = 0;
    for (int a = 0; a < 3; ++a)
    {
      sides |= (node[a] == 0) << (2 * a) | (node[a] == this->GlobalBox.Upper[a]) << (2 * a + 1);
    }
    return sides;
  }

  /// Calls body(n) for the cells of the outer layer that mirror a cell: none but at the rim of the local box.
  template <class Body>
  void ForMirrors(Index cell, const Body& body) const;

private:
  static Index3 Unpack(Index key, const Index3& size)
  {
    return { { key % size[0], key / size[0] % size[1], key / (size[0] * size[1]) } };
  }

  std::array<std::vector<double>, 3> X;
  IndexBox GlobalBox, OwnedBox, LocalBox;
  Index3 Origin, Strides;
  std::array<Index, 8> Corners;
  Index Entries = 0;
  int HexGhosts;
};

template <class Body>
void CartesianGrid::ForMirrors(Index cell, const Body& body) const
{
  const Index3 p = this->Position(cell);
  Index3 low, high;
  for (int a = 0; a < 3; ++a)
  {
    low[a] = p[a] == this->LocalBox.Lower[a] ? -1 : 0;
    high[a] = p[a] == this->LocalBox.Upper[a] - 1 ? 1 : 0;
  }
  for (Index z = low[2]; z <= high[2]; ++z)
  {
    for (Index y = low[1]; y <= high[1]; ++y)
    {
      for (Index x = low[0]; x <= high[0]; ++x)
      {
        if (x != 0 || y != 0 || z != 0)
        {
          body(cell + x + y * this->Strides[1] + z * this->Strides[2]);
        }
      }
    }
  }
}

} // namespace vfm
