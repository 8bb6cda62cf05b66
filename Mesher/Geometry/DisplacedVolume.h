/**
 * DisplacedVolume: how much of each material is in another place in the mesh than in the fractions.
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/Mesh.h"
#include "Fractions/FractionField.h"

namespace vfm
{

/// Number of cells along the edges of the blocks in which volumes are compared. Smaller blocks
/// would count that fractions are smeared over several cells.
constexpr Index CellsOfBlock = 4;

/// Returns the displaced volume of each material from 0, as a fraction of its volume in the
/// fractions: what blocks of 4 x 4 x 4 cells have less in elements than in the fractions, or what
/// blocks have more, whichever is larger. 0: all of it is where it was, or it is in no cell. 1: all
/// of it is elsewhere, or in no element. Far material (Mesh::Far) is where it was.
///
/// Elements that lie in several blocks are divided into 64 parts.
/// @param mesh  owned elements, linear, in the length unit of the grid
/// @pre Collective.
/// @note Bitwise reproducible on any number of ranks and threads.
std::vector<double> FindDisplacedVolumes(
  const CartesianGrid& grid, const FractionField& fractions, const Mesh& mesh, Runtime& runtime);

} // namespace vfm
