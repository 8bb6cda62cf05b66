/**
 * ActiveMeshBuilder: makes an ActiveMesh of the points that move and the elements that are known of them.
 *
 * Widths of elements and places of points are given to the result, and what it is attached to.
 */
#pragma once

#include "Base/HexNumbering.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

class ActiveMeshBuilder
{
public:
  /// corners: of an element. points: how many the mesh has. Points of one node share their owner and colour; those of different
  /// nodes and one colour share no element.
  ActiveMeshBuilder(int corners, std::size_t points, std::vector<Mover> movers);

  /// Whether an element, given by its points in the mesh, has a mover.
  template <class Point>
  bool HasMover(const Point* element) const;

  /// Adds an element of the mesh (VTK order), and those of its points that are new.
  template <class Point>
  void Add(const Point* element);

  /// Adds the elements of a mesh that have a mover; returns them.
  std::vector<Index> AddAround(const Mesh& mesh);

  /// What the nodes of movers are.
  enum class Nodes
  {
    Any,
    OfGrid ///< Mover::Owner itself, its colour the parity; those that share an element are at most one apart along each axis
  };
  /// All but widths and places. partition: null where no rank shares the points. colours: as many on all ranks. Collective
  /// among peers.
  ActiveMesh Finish(const Partition* partition, int colours = 8, Nodes which = Nodes::Any);

private:
  int AddPoint(Index meshPoint);
  std::vector<MoveOrder::Node> ListNodes(const Partition* partition) const;
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
    const Point p = element[this->Result.Corners == 8 ? VtkCorner[c] : c];
    const int known = this->Result.PointOf[p];
    this->Result.Elements.push_back(known >= 0 ? known : this->AddPoint(p));
  }
}

} // namespace vfm
