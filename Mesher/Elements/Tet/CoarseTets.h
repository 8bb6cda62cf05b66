/**
 * CoarseTets: the tets in the coarse hexes of a refined grid (CoarseHexes.h).
 *
 * Tets are made like in finest cells. A face between two hexes, at least one of them coarse, has
 * four tets. A face on the domain boundary has two, between its halves and the centre of its hex.
 * The centre of a hex is the mean of its corners. A face between two hexes can be divided in three
 * ways: into four tets around the edge between the centres, or into two tets on each side, along
 * either diagonal. The three ways have the same outer surface, so each face takes the way with the
 * smallest energy. The choice depends only on the two hexes of the face. Faces of whole
 * cells are not changed.
 *
 * On a periodic grid, a face takes the way of its owner's copy. A face on a flat seam has two tets
 * on each side, which belong to their own hexes, along one diagonal for both. If a finest cell is
 * beyond the seam, its two tets have an id made from the key of that cell.
 *
 * Ids are CentreId and TetId (LevelIds.h); a tet belongs to the hex with the smaller key. Points
 * and tets are in the order of ids. Results are bitwise identical on any
 * number of ranks, like TransitionSmoothing.
 */
#pragma once

#include "Elements/Hex/CoarseHexes.h"
#include "Elements/Tet/TetTopology.h"

namespace vfm
{

/// Tets of the coarse hexes near the owned cells. The grid of the hexes must outlive it.
class CoarseTets
{
public:
  using Tet = std::array<int, 4>; ///< points of Points, in positive orientation
  /// Corners of four tets, in grid coordinates (Interface.h).
  using FourTets = Vector3[4][4];
  /// Energy of four tets that divide a face; InvalidWay if one is not positive.
  /// @param widths  widths of the cell, in mean widths of the finest grid
  using WayEnergy = std::function<double(const FourTets& tets, const Vector3& widths)>;
  static constexpr double InvalidWay = 1e300;

  /// Makes the tets, or none if the grid has no refinements. Faces are not divided in their best
  /// way yet.
  /// @param hexes  coarse hexes that are not split; they are consumed (CoarseHexes::Visit)
  /// @throws InputError  if ids or numbers of points are too large
  /// @pre Collective.
  CoarseTets(CoarseHexes& hexes, Ranks& ranks);

  /// Divides the faces in their best ways at the present positions.
  /// @pre Collective.
  void ChooseWays(const WayEnergy& energy, Runtime& runtime);
  /// Returns the families to refine because tets in owned base cells are not positive, one list
  /// per refinement. If there are any on a rank, levels and tets must be made again.
  std::vector<std::vector<Index>> FindBadFamilies(const WayEnergy& energy) const;

  const RefinedGrid& Levels() const { return this->Grid; }
  /// Points of the coarse hexes, their centres, and points of finest cells, which have no ids.
  const Mesh& Points() const { return this->Local; }
  Mesh& Points() { return this->Local; }
  /// Calls visit(point, node) for each point of a level that may move, with its node of that level.
  /// A copy of a lattice node moves with this node, the centre of a transition hex with the upper
  /// node of its cell. So points of one colour share a tet only if they move with one node, and the
  /// owner of a cell has all tets at its points.
  void ForFreePoints(int level,
    const std::function<void(int point, const OctreeKeys::LevelIndex& node)>& visit) const;
  /// Calls visit(tet, widths of its cell in mean widths of the grid) for the tets of faces of
  /// transition hexes.
  void ForFreeTets(const std::function<void(const Tet& tet, const Vector3& widths)>& visit) const;
  /// Returns the number of points that do not belong to a finest cell of HexBox.
  Index NumberOfPoints() const { return static_cast<Index>(this->Local.PointIds.size()); }
  Index NumberOfTets() const;

  /// Returns the mesh point in a slot of a block, given by its linear index. The slot is VertexSlot
  /// for a vertex of the finest grid and CentreSlot for the centre of a fine cell.
  using FinePoint = std::function<Index(Index linear, Index slot)>;
  /// Writes points with ids and positions, and tets with ids and materials.
  /// @param firstPoint,firstTet  indices from which points and tets are written
  void Fill(
    TetTopology& topology, Index firstPoint, Index firstTet, const FinePoint& finePoint) const;

private:
  struct Hex
  {
    Index Key;
    OctreeKeys::LevelIndex Cell;
    int Material;
    bool IsWhole;                 // whether it is a cell, not a transition hex
    std::array<Index, 8> Corners; // points of Local, numbered by bits
    int Centre = -1;              // point of Local
  };
  struct CoarseFace
  {
    int Hex, Side;
    int Centre; // centre of the hex beyond the face; -1 on the domain boundary and flat seams
    std::array<int, 4> Corners; // counterclockwise as seen from beyond the face
    bool IsPlain;               // whether its hexes are whole cells
    int Way; // 0: around the edge between the centres; 1 + k: along the diagonal from corner k
    int Partner = -1; // on a flat seam, the same face as a face of the hex beyond
  };
  struct FineHalf
  {
    int Face, Axis; // face on a flat seam, and the axis across which it lies
    int Centre;     // centre of the finest cell beyond
  };
  Vector3 PointAt(int point) const;
  Vector3 WidthsOf(const CoarseFace& face) const;
  void TakeHexes(CoarseHexes& hexes);
  void AddFinePoints();
  void FindFaces();
  std::vector<CoarseFace> ListFaces() const;
  bool AddFace(CoarseFace face, std::vector<FineHalf>& fineHalves);
  int SeamOf(const CoarseFace& face) const;
  void AddFineHalves(const std::vector<FineHalf>& fineHalves);
  int FineCentreBeyond(const CoarseFace& face) const;
  void AddCentres();
  int TetsOf(const CoarseFace& face, int way, Tet tets[4]) const;
  int TetsOnBothSides(const CoarseFace& face, int way, Tet tets[4]) const;
  double EnergyOf(const CoarseFace& face, int way, const WayEnergy& energy) const;
  int BestWay(const CoarseFace& face, const WayEnergy& energy) const;
  bool Decides(const CoarseFace& face) const;
  int WayOfPartner(const CoarseFace& face, int way) const;
  void TakeWays(Ranks& ranks);
  int FindFine(Index code) const;

  const RefinedGrid& Grid;
  Mesh Local;        // points of coarse hexes, centres, and fine points, which have no ids
  int HexPoints = 0; // number of points before the centres
  std::vector<Index> FineCodes;  // 2 linear + slot of each fine point, ascending
  std::vector<Hex> Hexes;        // ordered by key, then the finest cells with tets on flat seams
  std::vector<CoarseFace> Faces; // ordered by hex and side
};

} // namespace vfm
