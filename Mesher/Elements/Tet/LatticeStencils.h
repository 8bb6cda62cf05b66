/**
 * LatticeStencils: the combinatorics of the body-centred lattice, independent of any grid. These
 * are the shapes of lattice tets, the points where they may be cut, and the resulting tets.
 *
 * Sets. A set of the four nodes of a lattice tet is a number from 1 to 15 with one bit per node. It
 * identifies a point: the node itself (one node), the cut on an edge (two), the point in a triangle
 * (three) or inside the tet (four). Each point starts at the mean of the nodes in its set.
 *
 * Slots. A point that starts in block (i,j,k) has one of these slots:
 *    0       vertex (i,j,k)
 *    1       centre of cell (i,j,k)
 *    2..9    cut between corner c of the cell and its centre
 *   10..12   cut on the edge of the grid from (i,j,k) along each axis
 *   13..15   cut between the two centres at face `axis`; on the domain boundary, cut on the
 *            diagonal of the face
 *   16..27   per face 4 points in the triangles of both centres and a corner; on the domain
 *            boundary, points in the halves of the face
 *   28..39   per axis 4 points in the triangles of the centre and an edge of the cell
 *   40..51   per face 4 points in its lattice tets; 2 on the lower sides of the domain
 *   52..57   point in the triangle of the centre and the diagonal of face -x +x -y +y -z +z of the
 *            cell, if the face is on the domain boundary
 *   58..63   per axis 2 points in the lattice tets of a face on the upper side of the domain
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <cstdint>

namespace vfm
{

/// Twice the coordinates relative to a block, in cells. Coordinates are even at
/// vertices and odd at centres.
using HalfPoint = std::array<int, 3>;

/// Lattice tet at a face of block (0,0,0).
struct LatticeTet
{
  std::array<HalfPoint, 4> Nodes;  ///< nodes in positive orientation
  std::array<HalfPoint, 16> Block; ///< block of the point of each set, in cells
  std::array<int, 16> Slot;        ///< slot of the point of each set
};

/// Division of a lattice tet into regions of one label each, ordered by their first nodes.
struct LatticeStencil
{
  struct Region
  {
    int Node;             ///< first node of the region
    int First, Last;      ///< first tet and end of the tets of the region
    std::uint32_t Points; ///< bit s is set if the region has the point of set s
  };
  int Count = 0; ///< number of regions
  std::array<Region, 4> List;
  std::array<std::array<std::uint8_t, 4>, 24> Tets; ///< sets of the corners, positive orientation
};

/// Tables of all shapes and stencils. There is one constant instance, which threads may share.
class LatticeTables
{
public:
  static constexpr int Shapes = 36;

  static const LatticeTables& Get();

  /// Returns the first of the 4 shapes of a face inside the domain.
  static int InnerShape(int axis) { return 12 * axis; }
  /// Returns the first of the 2 shapes of a face on the lower (0) or upper (1) side of the domain.
  static int DomainShape(int axis, int upper, int diagonal)
  {
    return 12 * axis + 4 + 4 * upper + 2 * diagonal;
  }
  /// Returns the diagonal that divides the faces of a block on the domain boundary: 0 runs through
  /// the lowest corner, 1 is the other.
  static int Diagonal(const Index3& block)
  {
    return static_cast<int>((block[0] + block[1] + block[2]) & 1);
  }

  const LatticeTet& Shape(int shape) const { return this->Tets[shape]; }

  /// Returns the stencil of a shape. Each of its tets has a node that is not snapped, an anchor. It
  /// divides polygons by fans from their first point: centres that are not snapped come first, then
  /// vertices that are not, then all others by id. So tets on both sides of a face match.
  /// @param labels  labels of the four nodes, -1 if snapped; at least one is not
  const LatticeStencil& Stencil(int shape, const std::array<int, 4>& labels) const
  {
    return this->Stencils[shape * Patterns + this->PatternOfCode[Code(labels)]];
  }

  /// Returns the initial position of a point: the mean of its nodes, in length units of the grid.
  /// If all nodes have one coordinate in common, the point has exactly this coordinate.
  Vector3 StartOf(const CartesianGrid& grid, const Index3& block, int slot) const;

private:
  /// Nodes of a point, relative to its block.
  struct PointNodes
  {
    int Count = 0;
    std::array<HalfPoint, 4> Nodes;
  };

  static constexpr int Patterns = 51; // patterns of equal labels and snapped nodes

  LatticeTables();
  void AddShape(int shape, const std::array<HalfPoint, 4>& nodes, int domain);
  void AddPatterns();
  /// Returns bits that describe which labels are snapped and which are equal.
  static int Code(const std::array<int, 4>& l)
  {
    return (l[0] < 0) | (l[1] < 0) << 1 | (l[2] < 0) << 2 | (l[3] < 0) << 3 | (l[0] == l[1]) << 4 |
      (l[0] == l[2]) << 5 | (l[0] == l[3]) << 6 | (l[1] == l[2]) << 7 | (l[1] == l[3]) << 8 |
      (l[2] == l[3]) << 9;
  }

  std::array<LatticeTet, Shapes> Tets;
  // Nodes of each slot: inside the domain, and on its boundary with diagonal 0 and 1.
  std::array<std::array<PointNodes, 64>, 3> Sources;
  std::array<std::uint8_t, 1024> PatternOfCode{};
  std::vector<LatticeStencil> Stencils;
};

} // namespace vfm
