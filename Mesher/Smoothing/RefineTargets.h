/**
 * RefineTargets: quadrics that are fitted to the volume fractions of the cells around, for curved
 * elements.
 *
 * The targets of straight elements are fitted to crossings of planes with lines between cell
 * centres (SurfaceTargets.h), which are off a curved surface by some 4 % of a cell per radian that
 * it turns within a cell. Straight facets are off by more; curved ones are not. A quadric that
 * gives each cell its fraction (FeatureFit.h) is much closer.
 */
#pragma once

#include "Fractions/FractionField.h"
#include "Interface/SurfaceTargets.h"
#include "SharpFeatures/FeatureSites.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// Replaces the targets of the points that this rank moves by quadrics fitted to fractions. A
/// target stays where too few cells contain only its pair of labels, or where the new quadric is
/// not better. Targets of sharp features and of coarser grids stay.
/// @param interface  interface of the finest grid
/// @param fractions  fractions that the interface was made from, owned and ghost cells
/// @param firstTarget  target of the interface's first surface point
/// @param isSought  pairs of labels whose targets are replaced
void RefineTargets(const Interface& interface, const FractionField& fractions, Index firstTarget,
  const PairFilter& isSought, const ActiveMesh& active, Runtime& runtime, SurfaceTargets& targets);

} // namespace vfm
