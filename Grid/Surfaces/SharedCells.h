/**
 * SharedCells: overlaps of bodies in the cells of a row along x, measured on rays through the row.
 *
 * A ray finds all crossings with a body, so it knows which parts of it are inside. Two triangles
 * with a common edge see a ray on the same side of it, because the edge is cut once, from its lower
 * to its upper end: no ray passes between them.
 */
#pragma once

#include "Surfaces/CutPolygon.h"

#include <vector>

namespace vfm
{

/// Cell that the boundaries of a body and of earlier bodies cut, and its parts: outside both, in an
/// earlier body, in the body, in both. They sum to 1.
struct SharedCell
{
  Index Cell;
  int Body;
  std::array<double, 4> Parts{};
};

/// Rays through one row.
class RowRays
{
public:
  RowRays();

  /// Begins a row, without crossings.
  void Begin(const Interval& y, const Interval& z);

  /// Adds the crossings with a triangle of a body.
  void Add(const CutPolygon& triangle, int body);

  /// Computes the parts of cells of the row.
  /// @param nodes  all nodes of the grid along x
  /// @param cells  in ascending order of cells
  void Measure(const std::vector<double>& nodes, std::vector<SharedCell>& cells);

private:
  struct Crossing
  {
    double X;
    int Body;
    int Sign; // 1 if the ray enters the body
  };
  struct Ray
  {
    double Y, Z;
    std::vector<Crossing> Crossings;
  };
  static void MeasureRay(
    const Ray& ray, const std::vector<double>& nodes, std::vector<SharedCell>& cells);

  std::vector<Ray> Rays; // ascending y
};

/// Returns the part of a cell that belongs to a body and to no earlier one. The parts on the rays
/// are scaled such that they agree with the fractions.
/// @param earlier,own  fractions of the cell in the earlier bodies together, and in the body
/// @param parts  see SharedCell
double FractionBesideEarlier(double earlier, double own, const std::array<double, 4>& parts);

} // namespace vfm
