/**
 * ThinCandidates: the cells that films, threads and drops of a material may get although the
 * material does not have their label.
 */
#pragma once

#include "Base/Runtime.h"
#include "Labels/Labels.h"
#include "Labels/PartsAround.h"

namespace vfm
{

/// A cell with some of a material that has another label.
struct ThinCandidate
{
  Index Cell; ///< linear index
  int Material;
  double Fraction;
  double Key; ///< the order of thinning: candidates with small keys leave first
  /// No cell around has the material's label, and none has much more of the material.
  bool IsRidge;
  bool EndsAtSide; ///< whether it is the end of a body, in a cell at a side of the domain
  /// Whether it is at a side of the domain and holds much less than the cell before.
  bool FadesAtSide;
};

/// Candidates of all materials in and around the owned cells, and which of them are in the set of
/// their material. The set of a material is the cells with its label and these candidates.
class ThinCandidates
{
public:
  /// Layers around the owned cells whose candidates are known.
  static constexpr int Layers = 3;

  /// Finds the candidates; all are in the sets at first. A candidate has at least 2 % of the
  /// material, and the weighted mean around it is below one half: where the material is the
  /// majority around, a cell with less is a gap.
  /// @param labels  AssignMaterials of the same cells; must outlive this object
  ThinCandidates(const CartesianGrid& grid, const FractionField& fractions,
    const LabelArray& labels, Runtime& runtime);

  std::size_t Size() const { return this->List.size(); }
  /// Returns a candidate. Candidates are in the order of cells, then of materials.
  const ThinCandidate& operator[](std::size_t n) const { return this->List[n]; }
  /// Returns the number of the candidate of a cell, -1 if there is none.
  int Find(Index cell, int material) const;
  bool IsIn(std::size_t n) const { return this->In[n] != 0; }
  void Remove(std::size_t n) { this->In[n] = 0; }
  /// Returns whether a cell is in the set of a material.
  bool IsInSet(Index cell, int material) const
  {
    if (this->Labels[cell] == material)
    {
      return true;
    }
    const int found = this->Find(cell, material);
    return found >= 0 && this->IsIn(found);
  }
  /// Returns which of the cells around a candidate are in the set of its material.
  /// @param mirrored  whether cells outside the domain count as the nearest cell inside; else they
  ///   are not in the set
  CellsAround SetAround(const ThinCandidate& candidate, bool mirrored) const;
  /// Calls body(n) for the candidates of the same material in the 26 cells around.
  template <class Body>
  void ForAround(const ThinCandidate& candidate, const Body& body) const
  {
    const Index3 p = this->Grid.Position(candidate.Cell);
    for (int step = 0; step < 27; ++step)
    {
      const Index3 cell = CellAround(p, step);
      const int found = step != 13 && this->Grid.Local().Contains(cell)
        ? this->Find(this->Grid.Linear(cell), candidate.Material)
        : -1;
      if (found >= 0)
      {
        body(static_cast<std::size_t>(found));
      }
    }
  }

private:
  const CartesianGrid& Grid;
  const LabelArray& Labels;
  std::vector<ThinCandidate> List;
  std::vector<unsigned char> In;
  PagedArray<int> First; // number of the first candidate of each cell; -1: none
};

} // namespace vfm
