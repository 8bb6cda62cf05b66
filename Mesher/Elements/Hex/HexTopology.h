/**
 * HexTopology: makes the points and hexes of a mesh from labels, in their initial position.
 *
 * A grid node with one label in its star becomes one point G, or none if that label is not meshed.
 * A mixed node becomes one surface point S, shared by all labels, and one inner point I per meshed
 * label of its star, in the order of the labels. A meshed cell becomes its core hex on its eight
 * points G or I. Each of its faces towards another label has one buffer hex between the four points
 * I and the four points S of the face (the buffer layer, or pillow). Faces on the domain boundary
 * have none. Hence
 *
 *   hexes = meshed cells + one per interface face and meshed side.
 *
 * Two cells of labels A < B, seen along z; the nodes between them are mixed:
 *
 *     G-----------I----S----I-----------G
 *     |           |    |    |           |
 *     |   core    | b. | b. |   core    |       b.: buffer hexes, on face +x of the cell A
 *     |   hex A   | A  | B  |   hex B   |           and on face -x of the cell B
 *     |           |    |    |           |
 *     G-----------I----S----I-----------G
 *
 * Slots of ids (GlobalIds.h). Points of a node: 0 for G or S, 1 + position of the label among the
 * labels of the star for I. Hexes of a cell: 0 for the core hex, 1 + face for a buffer hex.
 *
 * Narrow void cells get points and hexes like meshed ones, as a barrier (NarrowVoid.h).
 *
 * In a stair-step mesh, mixed nodes are one point like the others and there is no buffer
 * layer. In a refined grid, all this applies only to the finest cells; the coarse hexes
 * follow (CoarseHexes.h).
 *
 * Hexes are made for CartesianGrid::HexBox; at the end a rank keeps the hexes of its own cells
 * (KeepOwned). Points are sorted by node and hexes by cell, the core hex first, then faces in
 * order; ids ascend.
 */
#pragma once

#include "Base/HexNumbering.h"
#include "Base/Runtime.h"
#include "Elements/Mesh.h"
#include "Labels/NarrowVoid.h"

namespace vfm
{

/// Thickness of the buffer layer before smoothing, in cell widths.
constexpr double BufferThickness = 0.125;

/// Returns the initial position of the inner point of a label at a node; the node itself if no
/// other label is around it.
Vector3 StartOfInnerPoint(
  const CartesianGrid& grid, const LabelArray& labels, const Index3& node, int label);

/// Returns the corners of the buffer hex on a face of a core hex: surface points on that face,
/// inner points on the opposite one.
/// @param surface,inner  points of the cell, numbered by bits like the result
template <class T>
std::array<T, 8> BufferHex(const std::array<T, 8>& surface, const std::array<T, 8>& inner, int face)
{
  const int bit = 1 << (face / 2);
  std::array<T, 8> corners;
  for (int c = 0; c < 8; ++c)
  {
    const int onFace = face & 1 ? c | bit : c & ~bit;
    corners[c] = c == onFace ? surface[c] : inner[onFace];
  }
  return corners;
}

/// Numbers of the mesh points of each grid node. Codes may be set by several threads for
/// different rows.
class PointNumbering
{
public:
  /// @param isRefined  whether only some cells are hexes of their own; memory is then proportional
  /// to these
  /// @param narrow  void cells that get hexes as a barrier; empty if void is meshed
  PointNumbering(const CartesianGrid& grid, const LabelArray& labels, bool meshVoid, bool isRefined,
    const NarrowVoid& narrow) :
    Grid(grid), Labels(labels), MeshVoid(meshVoid), Narrow(narrow)
  {
    if (isRefined)
    {
      this->SomeCodes = PagedArray<int>(grid, 0);
    }
    else
    {
      this->Codes = Buffer<int>(grid.NumberOfEntries());
    }
  }

  /// Returns whether cells of a label are part of the finished mesh.
  bool IsMeshed(int label) const { return vfm::IsMeshed(label, this->MeshVoid); }
  /// Returns whether a node has a point of a label that is around it: G or I.
  bool HasPoint(Index node, int label) const
  {
    return this->IsMeshed(label) || (label == 0 && this->Narrow.Touches(node));
  }
  /// Calls visit(begin, end) for the runs of cells with hexes in [first, last), cells of one label
  /// in a row.
  template <class Visitor>
  void ForCells(Index first, Index last, int label, const Visitor& visit) const;
  /// Calls visit(begin, end, hasPoint) for runs of nodes in [first, last), nodes of one label in a
  /// row.
  template <class Visitor>
  void ForNodes(Index first, Index last, int label, const Visitor& visit) const;
  /// Returns whether a node has points S and I; never in a stair-step mesh.
  bool IsSplit(Index node) const { return this->CodeOf(node) < 0; }
  /// Returns point G or S of a node.
  Index FirstPoint(Index node) const
  {
    const int code = this->CodeOf(node);
    return code < 0 ? ~code : code;
  }
  /// Returns point G of a node, or point I of the label.
  Index InnerPoint(Index node, int label) const
  {
    const int code = this->CodeOf(node);
    return code >= 0 ? code : ~code + 1 + this->MeshedRank(node, label);
  }

  /// Returns the number of points of a node: 0, 1, or S and its points I.
  int PointsAt(Index node) const;

  /// Returns the codes of consecutive nodes of a row: FirstPoint where it is a point G,
  /// negative elsewhere.
  /// @param copy  holds the codes if they are stored in pages
  const int* CodesOf(Index first, Index count, std::vector<int>& copy) const;

  /// Sets the code of a node: the index of G, or ~(index of S).
  void SetCode(Index node, int code)
  {
    if (this->Codes.empty())
    {
      this->SomeCodes.Set(node, code);
      return;
    }
    this->Codes[node] = code;
  }
  /// Sets the codes of consecutive nodes of a row to code, code + step, ..
  void SetCodes(Index first, Index count, Index code, int step);

private:
  int MeshedRank(Index node, int label) const;
  int CodeOf(Index node) const
  {
    return this->Codes.empty() ? this->SomeCodes[node] : this->Codes[node];
  }

  const CartesianGrid& Grid;
  const LabelArray& Labels;
  bool MeshVoid;
  const NarrowVoid& Narrow;
  // Code of each node, in one of both: index of G, or ~(index of S).
  Buffer<int> Codes;
  PagedArray<int> SomeCodes;
};

template <class Visitor>
void PointNumbering::ForCells(Index first, Index last, int label, const Visitor& visit) const
{
  if (this->IsMeshed(label))
  {
    visit(first, last);
  }
  else if (!this->Narrow.IsEmpty())
  {
    this->Narrow.ForCells(first, last,
      [&](Index begin, Index end, bool isNarrow)
      {
        if (isNarrow)
        {
          visit(begin, end);
        }
      });
  }
}

template <class Visitor>
void PointNumbering::ForNodes(Index first, Index last, int label, const Visitor& visit) const
{
  if (this->IsMeshed(label) || this->Narrow.IsEmpty())
  {
    visit(first, last, this->IsMeshed(label));
    return;
  }
  this->Narrow.ForNodes(first, last, visit);
}

class CoarseHexes;
class NearCells;

/// Hexes of HexBox before points move.
struct HexTopology
{
  Mesh Hexes;
  bool HasAllCells = true; ///< false: only those of NearCells
  /// The first hex of each row of HexBox (y fastest), then the end of the hexes of finest cells.
  std::vector<Index> RowOffset;
  Index WholeCells = 0; ///< number of hexes, from the first one, that are unchanged cells
};

/// Makes points, ids, hexes and materials. Points are at grid nodes; points I are moved inwards
/// by BufferThickness. Each corner of each hex has a positive Jacobian if all stars pass the
/// label condition.
/// @param mixed  all mixed nodes (FindMixedNodes)
/// @param[out] numbering  points of each grid node
/// @param coarse  hexes other than finest cells; they are written into the mesh
/// @param near  finest cells that get points and hexes; null: all of them
/// @throws InputError  if an id or the number of points is too large
/// @pre Collective.
HexTopology BuildHexes(const CartesianGrid& grid, const LabelArray& labels,
  const std::vector<Index>& mixed, bool stairStep, PointNumbering& numbering, Runtime& runtime,
  CoarseHexes& coarse, const NearCells* near = nullptr);

} // namespace vfm
