/**
 * LocalVolumes: shifts of interfaces near thin cells by what is missing around them.
 *
 * FragmentVolumes shifts all interfaces of a fragment by the same length. If a fragment has films
 * and a thick body, that takes material from one place and adds it in another. Here, the volume of
 * the elements in each cell is compared with the fractions, and an interface shifts by what the
 * cells around it lack, over its area in them.
 *
 * Volumes are sums of integers, so they depend on neither their order nor ranks.
 */
#pragma once

#include "Elements/MeshRun.h"
#include "Smoothing/ActiveMesh.h"
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

  /// Replaces the shifts of points with a thin cell in the 4^3 cells around their node.
  /// @param mesh  the active part, at its present positions
  /// @param[in,out] shifts  shift of each attachment, grid coordinates
  /// @pre Collective among peers.
  void ReplaceShifts(const ActiveMesh& mesh, std::vector<double>& shifts) const;

  /// Returns which active elements are in surroundings of 3^3 cells that contain more of their
  /// material than the fractions, by more than a share of these.
  /// @pre Collective among peers.
  std::vector<unsigned char> FindExcess(const ActiveMesh& mesh, double share) const;

private:
  /// Volume that a cell lacks of a material and volume in its fractions, and area of interfaces, in
  /// Quantum mean cells.
  struct Amounts
  {
    std::int64_t Lack = 0, Filled = 0, Area = 0;
  };
  struct Entry
  {
    Index Key; // KeyOf
    Amounts Values;
  };
  using Sums = std::vector<Entry>; // one per cell and material, ascending
  struct Item;                     // an entry of Sums for another rank
  struct Element
  {
    int Active; // its number in the active mesh
    int Material;
    Index3 Cell;
  };

  Index KeyOf(Index cell, int material) const { return cell * this->Materials + material; }
  void MarkRegion(const std::vector<Index>& thin);
  Sums Measure(const ActiveMesh& mesh) const;
  void AddInactive(const Mesh& mesh, const ActiveMesh& active);
  void AddFractions(const FractionField& fractions, const Mesh& mesh);
  void ListPoints(const Mesh& mesh, const ActiveMesh& active);
  static void Add(Sums& sums, Index key, const Amounts& amounts);
  static void Unite(Sums& sums);
  static Sums::const_iterator FirstFrom(const Sums& sums, Index key);
  void AddElements(const ActiveMesh& mesh, Sums& sums) const;
  void AddFacets(const ActiveMesh& mesh, Sums& sums) const;
  void Complete(Sums& sums) const;
  void SendToOwners(Sums& sums) const;
  void SendToGhosts(Sums& sums) const;
  template <class Visit>
  void ForRow(
    const Sums& sums, const Index3& first, Index count, int material, const Visit& visit) const;
  double ShiftOf(const Sums& sums, Index node, int material) const;

  const CartesianGrid& Grid;
  const Partition& Parts;
  Runtime& TheRuntime;
  const int Materials;               // with void
  std::vector<unsigned char> Region; // whether each cell of the local box counts
  Sums Start;                        // fractions minus elements that do not move
  std::vector<Element> Elements;     // owned active hexes in or beside the region
  std::vector<Index> CellOf;         // cell of each active element near thin cells; -1 for others
  std::vector<int> MaterialOf;       // material of each fragment; 0 if it is small or not here
  std::vector<Index> NodeOf;         // node of each active point near thin cells; -1 for others
};

} // namespace vfm
