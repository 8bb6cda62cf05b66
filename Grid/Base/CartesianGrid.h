/**
 * CartesianGrid: the box of cells of a uniform or rectilinear grid that one rank holds, and the
 * numbering of its cells, nodes and faces.
 */
#pragma once

#include "Base/IndexBox.h"

namespace vfm
{

/// Number of layers of ghost cells that the stages need around the owned cells. The ranges that a
/// stage reads and writes follow from GhostLayers and HexLayers. If interfaces cross levels, more
/// layers are needed; LayersFor (Options.h) returns their number.
constexpr int GhostLayers = 6;
/// Number of the innermost ghost layers whose hexes this rank makes too. Smoothing and geometry at
/// the boundary of the owned cells need them.
constexpr int HexLayers = 2;

/// Kind of the sides across periodic axes.
enum class Seam
{
  Flat, ///< nodes of the sides stay in their planes
  Free  ///< sides are faces like those inside, and follow interfaces
};

/// Uniform or rectilinear grid, of which this rank holds the local box: its owned cells and the
/// ghost layers around them. Cells and nodes are implicit. The grid does not change after
/// construction, so threads may read it at the same time.
///
/// Indices. (i,j,k) are global. Cell (i,j,k) and its lower corner, node (i,j,k), have the same
/// linear index. Arrays over cells and arrays over nodes have the same shape: the local box and one
/// more layer of cells on every side, the outermost layer. Therefore the eight cells of a node, the
/// eight nodes of a cell and the neighbours of both are at fixed offsets, and every node of the
/// local box has eight cells in memory. The outermost layer holds no data of the input. Stages that
/// read it (labels) copy to it the values of the adjacent cells of the local box; see ForMirrors.
///
/// Numbering. Corner c of a cell is on the + side of axis a if bit a of c is set. Corner c of cell
/// n is node n + CornerOffset(c). The star of node n is the eight cells around it; cell c of the
/// star is n - CornerOffset(7) + CornerOffset(c). Faces -x +x -y +y -z +z have the numbers 0 to 5.
///
/// A row along x of a rank with one ghost layer (g), two owned cells (o) and the outermost layer
/// (e); the bars are nodes:
///
///     n     n+1   n+2   n+3   n+4   n+5            linear index of cells and of nodes
///     |  e  |  g  |  o  |  o  |  g  |  e  |        n + Stride(1): the next row
///           :     [  Owned()  )     :
///           [       Local()         )
///
/// Corners of a cell and cells of a star, left, and faces of a cell, right. Cell 7 of the star of
/// node n is cell n.
///
///       6------7
///      /|     /|                   5 3
///     4------5 |       z  y        |/
///     | 2----|-3       | /      0--+--1
///     |/     |/        |/         /|
///     0------1         +--x      2 4
///
/// Keys. NodeKey and CellKey are global numbers that do not depend on the number of ranks.
///
/// Periodic axes. Along an axis on which the domain repeats, Global() covers more than one period:
/// an even number of layers of copies of cells lies before the domain and after it. So stages find
/// neighbours beyond the seam, the sides of the domain across this axis, as ghost cells. Only cells
/// of the domain are owned. The copies of a cell or node differ by whole periods; Canonical returns
/// one of them.
class CartesianGrid
{
public:
  /// Makes the grid of one rank.
  /// @param coordinates  node coordinates of the whole grid, one increasing list per axis, in the
  ///   length unit of the input
  /// @param owned  cells that this rank owns
  /// @param ghostLayers  number of layers of cells held around the owned cells
  /// @param hexLayers  number of the innermost of these layers whose hexes this rank makes, in
  ///   addition to the hexes of the owned cells
  /// @throws InputError  if a list has no cell or does not increase, or lengths are out of range
  CartesianGrid(std::array<std::vector<double>, 3> coordinates, const IndexBox& owned,
    int ghostLayers = 0, int hexLayers = HexLayers);

  /// Makes the grid of one rank from another grid of the same domain.
  CartesianGrid(const CartesianGrid& other, const IndexBox& owned, int ghostLayers = 0,
    int hexLayers = HexLayers);
  /// Makes a grid of which one rank owns all cells.
  explicit CartesianGrid(std::array<std::vector<double>, 3> coordinates);
  /// Makes the grid of one rank of a domain that repeats. Indices of the result count from the
  /// first copy.
  /// @param coordinates  node coordinates of one period along periodic axes
  /// @param owned  cells that this rank owns, counted from the lowest cell of the domain
  /// @param isPeriodic  whether the domain repeats along each axis
  /// @param layers  number of layers of copies before and after the domain; an odd number or one
  ///   below ghostLayers is raised
  static CartesianGrid Covering(const std::array<std::vector<double>, 3>& coordinates,
    const IndexBox& owned, const std::array<bool, 3>& isPeriodic, Seam seam, int ghostLayers,
    int hexLayers = HexLayers, Index layers = 0);
  /// Returns the grid of the same domain with other cells, repeated like this one.
  /// @param coordinates  node coordinates of the domain
  /// @param owned, layers  as of Covering
  CartesianGrid WithCells(const std::array<std::vector<double>, 3>& coordinates,
    const IndexBox& owned, int ghostLayers, Index layers) const;
  /// Returns the grid of the domain, without copies of cells. Indices count from its lowest cell.
  CartesianGrid OfDomain(int ghostLayers = 0) const;

  /// Returns the cells that exist for the stages: the domain, and along periodic axes its copies.
  const IndexBox& Global() const { return this->GlobalBox; }
  /// Returns the cells of the domain: one period along periodic axes.
  const IndexBox& Domain() const { return this->DomainBox; }
  const IndexBox& Owned() const { return this->OwnedBox; }
  const IndexBox& Local() const { return this->LocalBox; }
  /// Returns the owned cells and the innermost `levels` ghost layers around them, as far as they
  /// are in the local box.
  IndexBox Extended(int levels) const;
  /// Returns the cells whose hexes this rank makes: the owned cells and the hexLayers around them.
  IndexBox HexBox() const { return this->Extended(this->HexGhosts); }

  /// Returns the length of every array over cells or nodes.
  Index NumberOfEntries() const { return this->Entries; }
  Index Stride(int axis) const { return this->Strides[axis]; }
  /// Returns the linear index of cell or node (i,j,k).
  Index Linear(const Index3& p) const
  {
    return (p[0] - this->Origin[0]) + (p[1] - this->Origin[1]) * this->Strides[1] +
      (p[2] - this->Origin[2]) * this->Strides[2];
  }
  /// Returns (i,j,k) of a linear index.
  Index3 Position(Index n) const
  {
    const Index k = n / this->Strides[2];
    const Index j = (n - k * this->Strides[2]) / this->Strides[1];
    const Index i = n - k * this->Strides[2] - j * this->Strides[1];
    return { { i + this->Origin[0], j + this->Origin[1], k + this->Origin[2] } };
  }

  /// Returns the linear index of corner c of a cell minus the index of the cell.
  Index CornerOffset(int c) const { return this->Corners[c]; }
  Index NodeOfCell(Index cell, int c) const { return cell + this->Corners[c]; }
  /// Returns cell c of the star of a node. Bit a of c is set if the cell is on
  /// the + side of axis a.
  Index CellOfNode(Index node, int c) const { return node + this->Corners[c] - this->Corners[7]; }
  /// Returns the cell across a face.
  Index Neighbour(Index cell, int face) const
  {
    return (face & 1) ? cell + this->Strides[face / 2] : cell - this->Strides[face / 2];
  }
  bool InDomain(const Index3& cell) const { return this->GlobalBox.Contains(cell); }

  bool IsPeriodic() const { return this->Periods != Index3{}; }
  /// Returns the number of cells after which the domain repeats along an axis; 0: it does not.
  Index Period(int axis) const { return this->Periods[axis]; }
  /// Returns the cells in a number of periods along each axis.
  Index3 CellsInPeriods(const Index3& count) const
  {
    return { { count[0] * this->Periods[0], count[1] * this->Periods[1],
      count[2] * this->Periods[2] } };
  }
  /// Returns the axes across which a node or the lower corner of a cell lies on a flat seam: bit a
  /// is set for axis a.
  int FlatSeams(const Index3& node) const;
  /// Returns the same for a point, which must have exactly the coordinate of the seam.
  int FlatSeams(const Vector3& point) const;
  bool IsOnFlatSeam(const Index3& node, int axis) const
  {
    return (this->FlatSeams(node) >> axis & 1) != 0;
  }
  /// Returns the length of a period; 0: the domain does not repeat along the axis.
  double PeriodLength(int axis) const;
  /// Returns the copy of a cell whose index is in the domain, or of a node: the lower one, if it is
  /// on a seam. CanonicalNode returns the upper one, which has owned cells below.
  Index3 Canonical(const Index3& p) const;
  Index3 CanonicalNode(const Index3& node) const;

  Vector3 NodePoint(const Index3& p) const
  {
    return { { this->X[0][p[0]], this->X[1][p[1]], this->X[2][p[2]] } };
  }
  /// Returns the cell that contains a point; for a point on a face, the cell on its + side. For a
  /// point outside the domain, the index along that axis is -1 or the number of cells. A point on
  /// an upper side of the domain counts as outside.
  Index3 CellAt(const Vector3& point) const;
  /// Returns the same; fast if a cell near the point is known.
  Index3 CellAt(const Vector3& point, Index3 near) const;
  const std::array<std::vector<double>, 3>& Coordinates() const { return this->X; }
  const std::vector<double>& Coordinates(int axis) const { return this->X[axis]; }
  /// Returns the width of a cell, equal for all copies of it.
  double Width(int axis, Index i) const { return this->Widths[axis][i]; }
  double CellVolume(const Index3& c) const
  {
    return this->Width(0, c[0]) * this->Width(1, c[1]) * this->Width(2, c[2]);
  }
  /// Returns the cube root of the mean cell volume, the length unit in which coordinate
  /// differences are near 1.
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
  /// Returns the cell on the + side of a node along all axes; on an upper side of the domain, the
  /// cell on the - side. The block of the node (TetTopology.h) belongs to this cell.
  Index3 CellOfBlock(const Index3& node) const
  {
    const Index3& n = this->GlobalBox.Upper;
    return { { std::min(node[0], n[0] - 1), std::min(node[1], n[1] - 1),
      std::min(node[2], n[2] - 1) } };
  }
  /// Returns the parities of i, j and k as bits of a number, 0 to 7.
  static int Parities(const Index3& p)
  {
    return static_cast<int>((p[0] & 1) | (p[1] & 1) << 1 | (p[2] & 1) << 2);
  }
  /// Returns the colour of a node, from 0. Nodes of one colour have no common cell, and copies have
  /// one colour. Without odd periods, colours are the parities. Along an axis with an odd period,
  /// the last node of the period has a third value.
  int Colour(const Index3& node) const;
  /// Returns the number of colours: 8, or 12, 18 or 27 with odd periods.
  int NumberOfColours() const;
  /// Returns the sides of the domain on which a node lies: bit f is set for side f.
  int DomainSides(const Index3& node) const
  {
    int sides = 0;
    for (int a = 0; a < 3; ++a)
    {
      sides |= (node[a] == 0) << (2 * a) | (node[a] == this->GlobalBox.Upper[a]) << (2 * a + 1);
    }
    return sides;
  }

  /// Calls body(n) for each cell n of the outermost layer that mirrors a cell of the local box.
  /// Only cells at the boundary of the local box have mirrors.
  template <class Body>
  void ForMirrors(Index cell, const Body& body) const;

private:
  void SetWidths();
  void SetLocal(int ghostLayers);
  static Index3 Unpack(Index key, const Index3& size)
  {
    return { { key % size[0], key / size[0] % size[1], key / (size[0] * size[1]) } };
  }

  std::array<std::vector<double>, 3> X, Widths;
  IndexBox GlobalBox, DomainBox, OwnedBox, LocalBox;
  Index3 Periods{ { 0, 0, 0 } };
  Seam TheSeam = Seam::Free;
  Index3 Origin, Strides;
  std::array<Index, 8> Corners;
  Index Entries = 0;
  int HexGhosts;
};

/// Returns whether all cells have equal widths along each axis, within 1e-9.
bool IsUniform(const CartesianGrid& grid);
/// Returns whether all cells are cubes of equal size, within 1e-9.
bool HasCubes(const CartesianGrid& grid);

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
