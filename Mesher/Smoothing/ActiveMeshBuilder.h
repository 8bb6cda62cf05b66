/**
 * ActiveMeshBuilder: assembles an ActiveMesh from the points that may move and their elements. The
 * caller adds widths of elements, positions of points and attachments to the result.
 */
#pragma once

#include "Base/HexNumbering.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// Builder of an ActiveMesh: add elements, then call Finish once. Not thread safe.
class ActiveMeshBuilder
{
public:
  /// Starts with the movers and no elements.
  /// @param corners  number of points per element: 8 for hexes, 4 for tets
  /// @param points  number of points of the mesh
  /// @param movers  points that may move, owned or ghost. Points of one node share their owner and
  /// colour; points of different nodes with one colour share no element.
  ActiveMeshBuilder(int corners, std::size_t points, std::vector<Mover> movers);

  /// Returns whether an element has a mover.
  /// @param element  its points in the mesh
  template <class Point>
  bool HasMover(const Point* element) const;

  /// Adds an element of the mesh, and its points that are new.
  /// @param element  its points in the mesh, VTK order
  template <class Point>
  void Add(const Point* element);

  /// Adds the elements of a mesh that have a mover; returns their indices.
  std::vector<Index> AddAround(const Mesh& mesh, Runtime& runtime);

  /// Kind of the nodes of movers.
  enum class Nodes
  {
    Any,
    /// Mover::Owner is the node and its parity the colour. Nodes that share an element are at most
    /// one apart along each axis.
    OfGrid
  };
  /// Returns the mesh, complete except for widths, positions, attachments and lists of corners.
  /// @param partition  nullptr if ranks share no points
  /// @param colours  number of colours, equal on all ranks
  /// @pre Collective among the ranks that share movers.
  ActiveMesh Finish(
    const Partition& partition, const MoverCopies& copies, int colours, Nodes which = Nodes::Any);
  /// Returns the mesh of movers with eight colours that ranks do not share.
  ActiveMesh FinishAlone();

private:
  int AddPoint(Index meshPoint);
  ActiveMesh TakeResult(std::size_t movers);
  std::vector<MoveOrder::Node> TakeNodes(const Partition* partition);
  void RequestFlags(const std::vector<MoveOrder::Node>& nodes);

  std::vector<Mover> Movers;
  ActiveMesh Result;
};

template <class Point>
bool ActiveMeshBuilder::HasMover(const Point* element) const
{
  const int movers = static_cast<int>(this->Movers.size());
  return std::any_of(element, element + this->Result.Corners,
    [&](Point p) { return this->Result.PointOf[p] >= 0 && this->Result.PointOf[p] < movers; });
}

template <class Point>
void ActiveMeshBuilder::Add(const Point* element)
{
  for (int c = 0; c < this->Result.Corners; ++c)
  {
    const Point p = element[this->Result.HasHexes() ? VtkCorner[c] : c];
    const int known = this->Result.PointOf[p];
    this->Result.Elements.push_back(known >= 0 ? known : this->AddPoint(p));
  }
}

} // namespace vfm
