/**
 * FeatureModel: up to three surfaces that cut each other, and the fraction of the second label of a
 * pair that they leave in a cell.
 *
 * The inside of a surface is where its distance is positive, on the side of the second label. A
 * composition defines the region of the second label from the insides of the surfaces. It is a sum
 * of signed products of indicators, so its volume in a cell is a signed sum of volumes of boxes cut
 * by planes. In each cell a surface is replaced by its tangent plane over the cell centre, shifted
 * by the mean of the quadratic term.
 */
#pragma once

#include "Interface/LocalQuadric.h"

#include <vector>

namespace vfm
{

/// Cell near a node, in its local frame, where cells are about unit cubes.
struct SampleCell
{
  Vector3 Centre, Half; ///< Half: half widths
  double Fraction;      ///< share of the second label in both labels together
  double Weight;
};

/// Returns the number of compositions of 1 to 3 surfaces. With indices from 0:
/// - One surface: its inside.
/// - Two surfaces: X and Y; X or Y.
/// - Three surfaces: all; any; (X or Y) and Z for each Z; (X and Y) or Z for each Z.
int NumberOfCompositions(int surfaces);

/// Surfaces in the local frame of a node, and how they are combined.
struct FeatureModel
{
  static constexpr int MaximumSurfaces = 3;

  int Count = 0;
  int Composition = 0;                                ///< index, below NumberOfCompositions(Count)
  std::array<LocalQuadric, MaximumSurfaces> Surfaces; ///< the first Count are set
};

/// Returns the model of one surface.
inline FeatureModel ModelOf(const LocalQuadric& surface)
{
  FeatureModel model;
  model.Count = 1;
  model.Surfaces[0] = surface;
  return model;
}

/// Returns whether a point has the second label; bit k is set if the point is inside surface k.
bool IsInside(const FeatureModel& model, int bits);

/// Returns the fraction of the second label that the model leaves in a cell, 0 to 1.
double FractionIn(const FeatureModel& model, const SampleCell& cell);

/// Also sets the derivatives by the six coefficients of each surface: 6 Count values,
/// one surface after another.
double FractionIn(const FeatureModel& model, const SampleCell& cell, double* derivatives);

} // namespace vfm
