/**
 * LocalVolumes: shifts of interfaces near thin cells by what is missing around them.
 *
 * FragmentVolumes shifts all interfaces of a fragment by the same length. If a fragment has films
 * and a thick body, that takes material from one place and adds it in another. Here, the volume of
 * the elements in each cell is compared with the fractions, and an interface shifts by what the
 * cells around it lack, over its area in them.
 */
#pragma once

#include "Elements/MeshRun.h"
#include "Smoothing/ActiveMesh.h"
#include "Volumes/CellVolumes.h"
#include "Volumes/FragmentVolumes.h"

namespace vfm
{

/// What cells near thin cells lack. Keeps references to grid and partition.
class LocalVolumes
{
public:
  /// @param thin  thin cells of the local box, ascending
  /// @param mesh  all hexes of this rank, without corners, at their start; all are of one level
  /// @param active  its active part, with MeshElement
  /// @param volumes  small fragments keep their shifts: they have a shift of their own
  LocalVolumes(const MeshCells& cells, const std::vector<Index>& thin, const Mesh& mesh,
    const ActiveMesh& active, const FragmentVolumes& volumes, const MeshRun& run);

  /// Returns what the cells near thin cells lack of each material, and areas of interfaces.
  /// @param mesh  the active part, at its present positions
  /// @pre Collective among peers.
  CellVolumes Measure(const ActiveMesh& mesh) const;

  /// Replaces the shifts of points with a thin cell in the 4^3 cells around their node.
  /// @param volumes  Measure
  /// @param[in,out] shifts  shift of each attachment, grid coordinates
  void ReplaceShifts(
    const CellVolumes& volumes, const ActiveMesh& mesh, std::vector<double>& shifts) const;

  /// Returns which active elements are in surroundings of 3^3 cells that contain more of their
  /// material than the fractions, by more than a share of these.
  std::vector<unsigned char> FindExcess(
    const CellVolumes& volumes, const ActiveMesh& mesh, double share) const;

private:
  struct Element
  {
    int Active; // its number in the active mesh
    int Material;
    Index3 Cell;
  };

  void MarkRegion(const std::vector<Index>& thin);
  void AddInactive(const Mesh& mesh, const ActiveMesh& active);
  void AddFractions(const FractionField& fractions, const Mesh& mesh);
  void ListPoints(const Mesh& mesh, const ActiveMesh& active);
  void AddElements(const ActiveMesh& mesh, CellVolumes& volumes) const;
  void AddFacets(const ActiveMesh& mesh, CellVolumes& volumes) const;
  double ShiftOf(const CellVolumes& volumes, Index node, int material) const;

  const CartesianGrid& Grid;
  const Partition& Parts;
  Runtime& TheRuntime;
  std::vector<unsigned char> Region; // whether each cell of the local box counts
  CellVolumes Start;                 // fractions minus elements that do not move
  std::vector<Element> Elements;     // owned active hexes in or beside the region
  std::vector<Index> CellOf;         // cell of each active element near thin cells; -1 for others
  std::vector<int> MaterialOf;       // material of each fragment; 0 if it is small or not here
  std::vector<Index> NodeOf;         // node of each active point near thin cells; -1 for others
};

} // namespace vfm
