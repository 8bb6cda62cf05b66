/**
 * CellSizes: widths of the coarsest and of the finest cells, if materials have widths of their own
 * (option MaterialWidths).
 *
 * The finest cells have the smallest width of a material, and the coarsest ones 2^Halvings times
 * this, at most the largest width. The cells of an image whose voxels are no cubes keep their
 * proportions: the width of a material is that along the axis of the narrowest cells.
 */
#pragma once

#include "Base/CartesianGrid.h"

namespace vfm
{

using GridNodes = std::array<std::vector<double>, 3>;

inline double MeanWidth(const std::vector<double>& nodes)
{
  return (nodes.back() - nodes.front()) / static_cast<double>(nodes.size() - 1);
}

inline Vector3 MeanWidths(const GridNodes& nodes)
{
  return { { MeanWidth(nodes[0]), MeanWidth(nodes[1]), MeanWidth(nodes[2]) } };
}

struct CellSizes
{
  GridNodes Nodes;             ///< of the finest cells
  int Halvings = 0;            ///< of the coarsest cells until they are the finest
  std::vector<int> OfMaterial; ///< of the coarsest cells until they fit materials 0, 1, ..
};

/// Plans the cells for given widths.
/// @param nodes of the cells of the input
/// @param widths option CellWidth: of the cells of all other materials; 0: the cells of the input
/// @param ofMaterial widths of materials 0, 1, ..; infinite: others. Void without a width takes the
/// coarsest cells.
/// @param repeats axes along which the domain repeats: their number of coarsest cells is even
/// @throws InputError if a width is smaller than that of the cells of the input
CellSizes PlanSizes(const GridNodes& nodes, const Vector3& widths,
  const std::vector<double>& ofMaterial, const std::array<bool, 3>& repeats);

/// Returns the nodes of the finest cells.
/// @param nodes of the cells of the input
/// @param finest widths of the finest cells
GridNodes PlaceNodes(
  const GridNodes& nodes, const Vector3& finest, int halvings, const std::array<bool, 3>& repeats);

/// Returns the largest number of halvings, at most a given one, with which PlaceNodes makes the
/// finest cells at most a quarter wider. Domains of few coarsest cells along an axis limit it.
int LimitHalvings(
  const GridNodes& nodes, const Vector3& finest, int halvings, const std::array<bool, 3>& repeats);

/// Returns how often the cells of the input can be doubled so that there is one along each axis, or
/// four where the domain repeats.
int CountDoublings(const GridNodes& nodes, const std::array<bool, 3>& repeats);

/// Returns the widths of the cells of materials 0, 1, ..: the largest along the axes. Empty without
/// CellSizes::OfMaterial.
std::vector<double> WidthsOfMaterials(const CellSizes& sizes);

} // namespace vfm
