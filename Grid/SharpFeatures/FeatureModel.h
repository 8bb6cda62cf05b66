/**
 * FeatureModel: up to three surfaces cut by each other, and the fraction of the second label of a pair that they leave in a cell.
 *
 * Each surface has an inside, where its distance is positive: the second label. A composition says which points are of the second label
 * by which surfaces they are inside of: a sum of signed products of indicators, so that its volume in a cell is a signed sum of volumes of
 * boxes under planes. In a cell each surface is its tangent plane over the cell's centre, moved by the mean of its quadratic term.
 */
#pragma once

#include "Interface/LocalQuadric.h"

#include <vector>

namespace vfm
{

/// A cell near a node, in its local frame: cells are about unit cubes.
struct SampleCell
{
  Vector3 Centre, Half;
  double Fraction; ///< of the second label among both
  double Weight;
};

/// Number of a composition: of one surface 0; of two 0..1 (both, either); of three 0..7 (all; any; (X or Y) and Z, (X and Y) or Z by Z).
int NumberOfCompositions(int surfaces);

struct FeatureModel
{
  static constexpr int MaximumSurfaces = 3;

  int Count = 0;
  int Composition = 0;
  std::array<LocalQuadric, MaximumSurfaces> Surfaces;
};

inline FeatureModel ModelOf(const LocalQuadric& surface)
{
  FeatureModel model;
  model.Count = 1;
  model.Surfaces[0] = surface;
  return model;
}

/// Whether a point inside of the surfaces whose bits are set is of the second label.
bool IsInside(const FeatureModel& model, int bits);

/// The fraction that the model leaves in a cell, 0..1.
double FractionIn(const FeatureModel& model, const SampleCell& cell);

/// The same with its derivatives by the six coefficients of each surface, one surface after another.
double FractionIn(const FeatureModel& model, const SampleCell& cell, double* derivatives);

} // namespace vfm
