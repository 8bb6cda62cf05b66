/**
 * LayerHeights: where the edges of columns are cut into layers.
 */
#pragma once

#include "Base/Runtime.h"
#include "Modify/LayerColumns.h"

namespace vfm
{

/// Thickness of layers.
struct LayerSpacing
{
  int Layers = 1;
  double Growth = 1.0;    ///< thickness of a layer relative to the one before it, from the surface
  double Thickness = 0.0; ///< of the first layer, length units of the mesh; 0: from the column
};

/// Returns where layers end, as fractions of an edge from its foot: 0, .., 1.
/// @param height length of the edge along the normal of the surface, in units of the thickness of
/// the first layer; 0: layers fill the edge
/// The first layer has its thickness if there is room for all layers. If there is more room than
/// layers of this growth need, the last layer fills it; if there is less, layers grow less.
std::vector<double> FindLayerEnds(const LayerSpacing& spacing, double height);

/// Returns for each edge where its layers end: Layers + 1 values from 0 to 1. Faces between layers
/// are flattened (FlattenLayers.h). All coefficients of the Jacobian (HexCoefficients.h) of the
/// layers are positive if those of the columns are; where flat faces or a given thickness prevent
/// this, edges approach the division of columns without them.
/// @pre Collective
/// @note The same values on any number of ranks.
std::vector<std::vector<double>> FindLayerHeights(
  const Mesh& mesh, const LayerColumns& columns, const LayerSpacing& spacing, Runtime& runtime);

} // namespace vfm
