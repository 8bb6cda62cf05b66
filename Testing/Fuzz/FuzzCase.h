/**
 * A random case of the mesher: grid, field, options, method, ranks.
 */
#pragma once

#include "RankMeshes.h"

namespace vfm
{
namespace testing
{

struct FuzzCase
{
  std::string Field;  ///< its kind
  std::string Words;  ///< what the case is, in a line
  CartesianGrid Grid; ///< of the finest cells
  FractionField Fractions;
  MeshOptions Options;
  MeshMaker Make;
  std::vector<IndexBox> Boxes; ///< of the ranks to compare with one; none: one alone
  bool HasCubes;
};

/// The same case for the same seed, on any machine.
FuzzCase MakeFuzzCase(unsigned seed);

/// Coordinates, families and fractions as text, all digits.
void PrintCase(const FuzzCase& c);

} // namespace testing
} // namespace vfm
