/**
 * A random case of the mesher: grid, field, options, method, ranks.
 */
#pragma once

#include "Options/MesherOptions.h"
#include "RankMeshes.h"

namespace vfm
{
namespace testing
{

struct FuzzCase
{
  std::string Field;  ///< kind of field
  std::string Words;  ///< description of the case in one line
  CartesianGrid Grid; ///< grid of the finest cells; of a periodic domain with copies of cells
  FractionField Fractions;
  MeshOptions Options;
  MeshMaker Make;
  /// boxes of the ranks that are compared with one rank; empty: one rank only
  std::vector<IndexBox> Boxes;
  bool HasCubes;
  Sides PeriodicSides = Sides::Flat; ///< of a periodic grid
  int Layers = 1;                    ///< along all interfaces
  double FirstLayer = 0.0;           ///< thickness, length units of the grid; 0: from the mesh
  std::string Split = {};            ///< option SplitInterfaces, by ids; empty: none
};

/// Returns the same case for the same seed on any machine.
/// @param isPeriodic  whether the domain repeats
FuzzCase MakeFuzzCase(unsigned seed, bool isPeriodic);

/// Prints coordinates, families and fractions as text with all digits.
void PrintCase(const FuzzCase& c);

} // namespace testing
} // namespace vfm
