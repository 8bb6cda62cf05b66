/**
 * Groups of cases for the test of all guarantees of a mesh (PropertiesTest).
 */
#pragma once

#include "CheckCase.h"
#include "Phases/MeshOfCells.h"

#include <functional>

namespace vfm
{
namespace testing
{

struct Kind
{
  const char* Name;
  MeshMaker Make;
  TetMethod Method;
  bool FineInterfaces = true;
};

inline const Kind Hexes{ "Hexes", MakeHexMesh, TetMethod::Lattice };
inline const Kind Crossing{ "Crossing", MakeHexMesh, TetMethod::Lattice, false };
inline const Kind CrossingTets{ "CrossingTets", MakeTetMesh, TetMethod::Lattice, false };
inline const Kind Cells{ "Cells", MakeTetMesh, TetMethod::Cells };
inline const Kind Lattice{ "Lattice", MakeTetMesh, TetMethod::Lattice };
inline const Kind Filled{ "TetGen", MakeTetMesh, TetMethod::TetGen };
inline const Kind Kinds[] = { Hexes, Cells, Lattice };

/// A case, and the divisions among ranks that must give the same mesh.
struct Input
{
  FuzzCase Case;
  Cuts Ranks = {};
};

/// Bounds of the worst values of a group, and sums that must not be 0.
struct Bounds
{
  double Jacobian = -1.0, Angle = 0.0; ///< least; degrees
  bool NoFlips = false, NoLocked = false;
  Index Transitions = -1; ///< more of them
  bool HasLevels = false, HasTransitions = false,
       AddsFamilies = false, ///< the first two: each case
    AddsNoFamilies = false;  ///< because no valid mesh starts
};

struct Group
{
  std::string Name;
  unsigned Seeds; ///< of a sweep; or the number of all cases
  std::function<Input(unsigned seed)> Make;
  Bounds Limits = {};
  bool IsSweep = true;
  unsigned Part = 0, Parts = 1; ///< of the sweep
};

/// @param halvings  of the cells of the finest level
FuzzCase CaseOf(const Kind& kind, const CartesianGrid& grid, FractionField field, int halvings = 0);
Input CaseOfShape(const Kind& kind, const MeshCase& shape, int halvings = 0);

inline std::vector<IndexBox> WithEmptyRank(std::vector<IndexBox> boxes)
{
  boxes.insert(boxes.begin() + 1, IndexBox());
  return boxes;
}

/// Adds cells of several levels, and the same on ranks.
void AddLevels(std::vector<Group>& groups);
void AddLevelRanks(std::vector<Group>& groups);
/// Adds periodic domains.
void AddPeriods(std::vector<Group>& groups);

} // namespace testing
} // namespace vfm
