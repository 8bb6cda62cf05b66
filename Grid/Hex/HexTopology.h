/**
 * From labels to hexahedra: the points and hexes of the mesh, before anything moves.
 *
 * A grid node with one label in its star becomes one point G (none where that label is not meshed).
 * A mixed node becomes one surface point S, shared by all, and one inner point I per meshed label of
 * its star, in the order of the labels. A meshed cell becomes its core hex on its eight G or I. Each of
 * its faces towards another label carries one buffer hex between the face's four I and four S (the
 * buffer layer, or pillow). Faces on the domain boundary carry none. So
 *   hexes = meshed cells + one per interface face and meshed side.
 * In a stair-step mesh mixed nodes are one point like the others and there is no buffer layer.
 *
 * In a refined grid this is so for the fine cells alone; the coarse hexes follow (CoarseHexes.h).
 *
 * Made for CartesianGrid::HexBox; a rank keeps those of its own cells at the end (KeepOwned).
 * Order: points by node, hexes by cell, core first, then the faces -x +x -y +y -z +z; ids ascend.
 */
#pragma once

#include "Base/HexNumbering.h"
#include "Base/Runtime.h"
#include "Labels/Labels.h"
#include "Mesh/Mesh.h"

namespace vfm
{

/// Thickness of the buffer layer before smoothing, in cell widths.
constexpr double BufferThickness = 0.125;

/// Where the inner point of a label starts at a node; the node itself where the label alone is around it.
Vector3 StartOfInnerPoint(
  const CartesianGrid& grid, const LabelArray& labels, const Index3& node, int label);

/// The corners of the buffer hex on a face of a core hex: those on the face of the surface, the opposite ones inner ones.
/// Numbered by bits.
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

/// Where the mesh points of a grid node are.
class PointNumbering
{
public:
  /// isRefined: whether only some cells are hexes of their own: memory follows those.
  PointNumbering(
    const CartesianGrid& grid, const LabelArray& labels, bool meshVoid, bool isRefined) :
    Grid(grid), Labels(labels), MeshVoid(meshVoid)
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

  bool IsMeshed(int label) const { return vfm::IsMeshed(label, this->MeshVoid); }
  /// A node with S and I points. In a stair-step mesh there is none.
  bool IsSplit(Index node) const { return this->CodeOf(node) < 0; }
  /// G or S.
  Index FirstPoint(Index node) const
  {
    const int code = this->CodeOf(node);
    return code < 0 ? ~code : code;
  }
  /// G, or the I of the label.
  Index InnerPoint(Index node, int label) const
  {
    const int code = this->CodeOf(node);
    return code >= 0 ? code : ~code + 1 + this->MeshedRank(node, label);
  }

  /// How many points a node has: 0, 1, or S and its I.
  int PointsAt(Index node) const;

  /// FirstPoint of some nodes of a row where it is a G, below 0 elsewhere. copy: holds them where they are in pages.
  const int* CodesOf(Index first, Index count, std::vector<int>& copy) const;

  /// What BuildHexes sets: the index of G, or ~(index of S).
  void SetCode(Index node, int code)
  {
    if (this->Codes.empty())
    {
      this->SomeCodes.Set(node, code);
      return;
    }
    this->Codes[node] = code;
  }
  /// Of nodes of a row: code, code + step ...
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
  // index of G, or ~(index of S), of each node: one of both
  Buffer<int> Codes;
  PagedArray<int> SomeCodes;
};

class CoarseHexes;

/// Makes points (grid nodes; I moved inwards by BufferThickness), ids, hexes and materials. mixed: all
/// mixed nodes (FindMixedNodes). Every corner of every hex has a positive Jacobian when all stars pass the label condition.
/// coarse: the hexes beside those of finest cells. Throws InputError when an id does not fit.
Mesh BuildHexes(const CartesianGrid& grid, const LabelArray& labels,
  const std::vector<Index>& mixed, bool stairStep, PointNumbering& numbering, Runtime& runtime,
  CoarseHexes& coarse);

} // namespace vfm
