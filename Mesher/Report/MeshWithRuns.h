/**
 * MeshWithRuns: a mesh together with the hexes that it leaves out (CellRuns), in the order of ids.
 */
#pragma once

#include "Base/GlobalIds.h"
#include "Elements/CellRuns.h"
#include "Report/MeshData.h"

#include <functional>
#include <string_view>

namespace vfm
{

/// Receives consecutive parts of the bytes of an array.
using AddBytes = std::function<void(std::string_view)>;

/// Points and hexes of a mesh and of its runs, numbered in the order of their ids. A mesh that
/// holds all hexes has the same points, hexes and values in this order. Needs memory for the runs,
/// and 8 bytes per point of the mesh.
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

  /// @param mesh  points and elements in the order of their ids, without mid nodes; must outlive
  ///   this object, like the others
  /// @param grid  grid of the runs
  MeshWithRuns(const MeshData& mesh, const CartesianGrid& grid, const CellRuns& runs);

  const MeshData& Stored() const { return this->Mesh; }
  const std::vector<CellRuns::Run>& Cells() const { return this->Runs.Runs; }
  /// Returns the volume of the cells of a run.
  double VolumeOf(const CellRuns::Run& run) const;
  Index NumberOfPoints() const { return this->Points; }
  Index NumberOfElements() const { return this->Elements; }
  /// Returns the number of a point of the mesh.
  Index NumberOfPoint(Index point) const { return this->Numbers[point]; }
  const std::vector<NodeRun>& Nodes() const { return this->NodeRuns; }

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
    stored(next, this->Mesh.NumberOfPoints);
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
    stored(next, this->Mesh.NumberOfElements);
  }
  /// Calls visit(material, corners) for each hex; corners: 8 numbers of points in VTK's order.
  void ForCorners(const std::function<void(int material, const Index* corners)>& visit) const;

  ///@{ Add the coordinates of points, shape (points, 3), and the corners of hexes, shape (elements,
  /// 8), in native byte order.
  void AddPoints(const AddBytes& add) const;
  void AddCorners(const AddBytes& add) const;
  ///@}
  ///@{ Add the values of an array of the mesh, which must be one of MeshArrays.h.
  void AddPointValues(const MeshArray& array, const AddBytes& add) const;
  void AddElementValues(const MeshArray& array, const AddBytes& add) const;
  ///@}

private:
  class Planes;
  void FindNodes();
  void FindElements();

  const MeshData& Mesh;
  const CartesianGrid& Grid;
  const CellRuns& Runs;
  std::vector<NodeRun> NodeRuns;
  std::vector<Index> ElementsBefore; // of each run, number of elements of the mesh with lower ids
  std::vector<Index> Numbers;        // of points of the mesh
  Index Points = 0, Elements = 0;
};

} // namespace vfm
