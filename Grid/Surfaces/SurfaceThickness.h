/**
 * SurfaceThickness: the thickness of a closed body, measured by balls inside it.
 */
#pragma once

#include "Surfaces/SurfaceSamples.h"
#include "Surfaces/TriangleSearch.h"

namespace vfm
{

/// Side of a surface on which balls lie.
enum class BallSide
{
  Inner, ///< thickness of the body
  Outer  ///< gaps between its walls
};

/// Returns the diameter of the largest ball that touches the surface at a sample and contains no
/// point of triangles that face the sample; infinite if none does. Only triangles whose normal is
/// opposed (cosine below -0.5) face it, so that balls do not shrink to 0 at convex edges. A ball
/// may be up to about a tenth too large.
std::vector<double> MeasureThickness(const std::vector<SurfaceSample>& samples,
  const TriangleSearch& surface, BallSide side, Runtime& runtime);

/// As MeasureThickness, up to a limit: balls that are larger, or touch nothing, have this diameter.
/// Each value depends on no other sample.
std::vector<double> MeasureThicknessTo(double limit, const std::vector<SurfaceSample>& samples,
  const TriangleSearch& surface, BallSide side, Runtime& runtime);

/// Returns the value that samples with a share of the area do not exceed.
/// @param values  of the samples
double FindQuantile(
  const std::vector<SurfaceSample>& samples, const std::vector<double>& values, double share);

/// Number of cells across a thickness that keeps its shape, sides and edges.
constexpr double CellsOfThickness = 2.5;
/// Share of the area that may be thinner than CellsOfThickness in cells of the suggested width.
constexpr double ThinShare = 0.05;

} // namespace vfm
