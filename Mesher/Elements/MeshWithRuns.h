/**
 * MeshWithRuns: a mesh together with the hexes that it leaves out (CellRuns), in the order of ids.
 */
#pragma once

#include "Elements/CellRuns.h"
#include "Elements/Mesh.h"

#include <functional>

namespace vfm
{

/// Numbers of the points and hexes of a mesh and of its runs, in the order of their ids. A mesh
/// that holds all hexes has the same points and hexes in this order. Needs memory for the runs, and
/// 8 bytes per point of the mesh.
class MeshWithRuns
{
public:
  /// Points of the runs that the mesh does not hold, at consecutive nodes along x.
  struct NodeRun
  {
    Index3 First; ///< first node
    Index Count;
    int Material, Fragment;
    Index Before; ///< number of points of the mesh with lower ids
    Index Number; ///< number of the first point, from 0
  };

  /// @param mesh  linear hexes of one rank; must outlive this object, like runs
  MeshWithRuns(const Mesh& mesh, const CellRuns& runs);

  const Mesh& Stored() const { return this->TheMesh; }
  Index NumberOfPoints() const { return this->Points; }
  Index NumberOfElements() const { return this->Elements; }
  /// Returns the number of a point of the mesh.
  Index NumberOfPoint(Index point) const { return this->Numbers[point]; }
  const std::vector<CellRuns::Run>& Cells() const { return this->Runs.Runs; }
  const std::vector<NodeRun>& Nodes() const { return this->NodeRuns; }

  ///@{ Return the global id of the first point or hex of a run. Ids ascend by PointSlots and
  /// ElementSlots of HexIds.
  Index FirstId(const NodeRun& run) const;
  Index FirstId(const CellRuns::Run& run) const;
  ///@}
  /// Returns the position of a point of a run.
  Vector3 PointAt(const NodeRun& run, Index place) const;
  /// Returns the volume of the cells of a run.
  double VolumeOf(const CellRuns::Run& run) const;

  /// Calls stored(first, last) for ranges of points of the mesh, and nodes(NodeRun) between them.
  template <class Stored, class Nodes>
  void ForPoints(const Stored& stored, const Nodes& nodes) const
  {
    Index next = 0;
    for (const NodeRun& run : this->NodeRuns)
    {
      stored(next, run.Before);
      nodes(run);
      next = run.Before;
    }
    stored(next, static_cast<Index>(this->TheMesh.PointIds.size()));
  }
  /// Calls stored(first, last) for ranges of elements of the mesh, and cells(CellRuns::Run) between
  /// them.
  template <class Stored, class Cells>
  void ForElements(const Stored& stored, const Cells& cells) const
  {
    Index next = 0;
    for (std::size_t r = 0; r < this->Runs.Runs.size(); ++r)
    {
      stored(next, this->ElementsBefore[r]);
      cells(this->Runs.Runs[r]);
      next = this->ElementsBefore[r];
    }
    stored(next, static_cast<Index>(this->TheMesh.ElementIds.size()));
  }
  /// Calls visit(material, corners) for each hex.
  /// @param visit  gets 8 numbers of points in VTK's order
  void ForCorners(const std::function<void(int material, const Index* corners)>& visit) const;

private:
  class Planes;
  void FindNodes();
  void FindElements();

  const Mesh& TheMesh;
  const CartesianGrid& Grid;
  const CellRuns& Runs;
  std::vector<NodeRun> NodeRuns;
  std::vector<Index> ElementsBefore; // of each run, number of elements of the mesh with lower ids
  std::vector<Index> Numbers;        // of points of the mesh
  Index Points = 0, Elements = 0;
};

} // namespace vfm
