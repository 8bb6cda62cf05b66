/**
 * CoarseTets: the tets of a refined grid where its hexes are no finest cells (CoarseHexes.h).
 *
 * They are made as those of the finest cells: around a face between two hexes, one of them a coarse one, stand four tets;
 * between a face of the domain and the centre of its hex two. Centres are the means of the corners. Around a face there are
 * three ways to cut: in four tets around the edge between the centres, or on either side in two along a diagonal. All three
 * have the same outside, so each face takes the one of the smallest energy (TetEnergy), which depends on its own two hexes
 * alone. Whole cells keep the first way.
 *
 * Then the centres and free points of transition hexes move where tets are poor, level by level.
 *
 * Ids: RefinedGrid::CentreId and TetId; a tet belongs to the hex of the smaller key. Order: as the ids. The same bit for bit
 * on any number of ranks, like TransitionSmoothing.
 */
#pragma once

#include "Hex/CoarseHexes.h"
#include "Smoothing/TetEnergy.h"
#include "Tet/TetTopology.h"

namespace vfm
{

class CoarseTets
{
public:
  /// None without refinements. Keeps a reference to the grid of the hexes. Where BadFamilies of any rank tells of some
  /// these want to be refined first: the rest is not made. Collective.
  CoarseTets(CoarseHexes& hexes, const TetEnergy& energy, Runtime& runtime);

  const RefinedGrid& Levels() const { return this->Grid; }
  /// Families that owned cells want to refine because tets there are not positive: of each refinement.
  const std::vector<std::vector<Index>>& BadFamilies() const { return this->Bad; }
  /// Of those that no finest cell of HexBox has.
  Index NumberOfPoints() const { return static_cast<Index>(this->Local.PointIds.size()); }
  Index NumberOfTets() const;

  /// The index of the mesh point of a vertex of the finest grid or of a centre of a fine cell; linear: of its block.
  using FinePoint = std::function<Index(Index linear, Index slot)>;
  /// Writes points, their positions, tets, their ids and materials, from those positions on.
  void Fill(
    TetTopology& topology, Index firstPoint, Index firstTet, const FinePoint& finePoint) const;

private:
  using Tet = std::array<int, 4>;

  struct Hex
  {
    Index Key;
    OctreeKeys::LevelIndex Cell;
    int Material;
    bool IsWhole;                 // an untouched cell
    std::array<Index, 8> Corners; // local points, by bits
  };
  struct Face
  {
    int Hex, Side;
    int Centre;                 // of the hex beyond; -1 on the domain
    std::array<int, 4> Corners; // around it, against the clock as seen from beyond
    bool IsPlain;               // between whole cells, or of one
    int Way; // 0 around the edge between the centres, 1 + k along the diagonal from corner k
  };
  Vector3 PointAt(int point) const;
  Vector3 WidthsOf(const Face& face) const;
  void TakeHexes(CoarseHexes& hexes);
  void AddFinePoints();
  void FindFaces();
  std::vector<Face> ListFaces() const;
  void AddFace(Face face);
  int FineCentreBeyond(const Face& face) const;
  void AddCentres();
  int TetsOf(const Face& face, int way, Tet tets[4]) const;
  double EnergyOf(const Face& face, int way) const;
  int BestWay(const Face& face) const;
  void ChooseWays(Runtime& runtime);
  void FindBadFamilies();
  int FindFine(Index code) const;
  std::vector<Mover> FindMovers(int level) const;
  void Improve(Runtime& runtime);

  const RefinedGrid& Grid;
  const TetEnergy& Energy;
  Mesh Local;        // points: those of coarse hexes, centres, fine ones; ids of all but the last
  int HexPoints = 0; // where the centres begin
  std::vector<Index> FineCodes; // of the fine points, ascending: 2 linear + slot
  std::vector<Hex> Hexes;       // by key
  std::vector<Face> Faces;      // by hex and side
  std::vector<std::vector<Index>> Bad;
};

} // namespace vfm
