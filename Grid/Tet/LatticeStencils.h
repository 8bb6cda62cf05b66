/**
 * The combinatorics of the lattice, free of any grid: the shapes of lattice tets, the points at which they may be
 * cut, the tets that they are cut into.
 *
 * Sets. A set of the four nodes of a lattice tet is a number 1..15, a bit a node. It names a point: of one node the node
 * itself, of two the cut between them, of three the point in their triangle, of four the point inside. All
 * start at the mean of their nodes.
 *
 * Slots of a point within the block (i,j,k) in which it starts:
 *    0       vertex (i,j,k)
 *    1       centre of the cell (i,j,k)
 *    2..9    cut between corner c of the cell and its centre
 *   10..12   cut on the edge of the grid from (i,j,k) along an axis
 *   13..15   cut between the centres beside face `axis`; on a face of the domain on its diagonal
 *   16..27   4 a face: in the triangle of both centres and a corner; on a face of the domain in one of its halves
 *   28..39   in the triangle of the centre and an edge of the cell, 4 an axis
 *   40..51   4 a face: in a lattice tet of it (of the lower sides of the domain: 2)
 *   52..57   in the triangle of the centre and the diagonal of face -x +x -y +y -z +z of the cell on the domain
 *   58..63   2 an axis: in a lattice tet of the cell's face on an upper side of the domain
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <cstdint>

namespace vfm
{

/// Twice the coordinates in cells, from a block: even those of a vertex, odd those of a centre.
using HalfPoint = std::array<int, 3>;

/// A lattice tet of a face of block (0,0,0).
struct LatticeTet
{
  std::array<HalfPoint, 4> Nodes;  ///< in positive orientation
  std::array<HalfPoint, 16> Block; ///< of the point of each set, in cells
  std::array<int, 16> Slot;
};

/// How a lattice tet is cut. Regions in the order of their first nodes.
struct LatticeStencil
{
  struct Region
  {
    int Node;             ///< one of its nodes with a label; -1 when all are snapped
    int First, Last;      ///< its tets
    std::uint32_t Points; ///< bit s: it has the point of set s
  };
  int Count = 0;
  std::array<Region, 4> List;
  std::array<std::array<std::uint8_t, 4>, 24> Tets; ///< sets, in positive orientation
};

class LatticeTables
{
public:
  static constexpr int Shapes = 36;

  static const LatticeTables& Get();

  /// Shapes of an inner face: 4 from here on.
  static int InnerShape(int axis) { return 12 * axis; }
  /// Shapes of a face on the lower or upper side of the domain: 2 from here on.
  static int DomainShape(int axis, int upper, int diagonal)
  {
    return 12 * axis + 4 + 4 * upper + 2 * diagonal;
  }
  /// Which diagonal cuts a face of the domain: 0 through its lowest corner, 1 the other.
  static int Diagonal(const Index3& block)
  {
    return static_cast<int>((block[0] + block[1] + block[2]) & 1);
  }

  const LatticeTet& Shape(int shape) const { return this->Tets[shape]; }

  /// labels: of the nodes, -1 snapped. Points of the stencil are fanned from those of the smallest id.
  const LatticeStencil& Stencil(int shape, const std::array<int, 4>& labels) const
  {
    return this->Stencils[shape * Patterns + this->PatternOfCode[Code(labels)]];
  }

  /// Where a point of a block starts: the mean of its nodes, exactly in the plane when they all are in one.
  Vector3 StartOf(const CartesianGrid& grid, const Index3& block, int slot) const;

private:
  /// The nodes of a point, relative to its block.
  struct PointNodes
  {
    int Count = 0;
    std::array<HalfPoint, 4> Nodes;
  };

  static constexpr int Patterns = 52; // of equal labels and snapped nodes

  LatticeTables();
  void AddShape(int shape, const std::array<HalfPoint, 4>& nodes, int domain);
  void AddPatterns();
  /// Which labels are snapped and which equal.
  static int Code(const std::array<int, 4>& l)
  {
    return (l[0] < 0) | (l[1] < 0) << 1 | (l[2] < 0) << 2 | (l[3] < 0) << 3 | (l[0] == l[1]) << 4 |
      (l[0] == l[2]) << 5 | (l[0] == l[3]) << 6 | (l[1] == l[2]) << 7 | (l[1] == l[3]) << 8 |
      (l[2] == l[3]) << 9;
  }

  std::array<LatticeTet, Shapes> Tets;
  std::array<std::array<PointNodes, 64>, 3> Sources; // inside the domain, on it with diagonal 0, 1
  std::array<std::uint8_t, 1024> PatternOfCode{};
  std::vector<LatticeStencil> Stencils;
};

} // namespace vfm
