/**
 * Crossings: points where an interface between two labels crosses the line between the
 * centres of two cells.
 */
#pragma once

#include "Interface/Interface.h"

namespace vfm
{

/// One of the two cells of a dual edge, with the fractions of a pair of labels around it.
struct EndCell
{
  Index Cell = -1;
  int First, Second;      ///< labels
  bool IsOneSided;        ///< whether the cell is at a side of the domain
  bool HasPlane;          ///< whether a plane was fitted
  bool IsCut;             ///< whether the cell has a PLIC plane
  double D;               ///< difference field, 0 at the interface
  double Share;           ///< share of the first label in the pair, if the cell is cut
  double Plane;           ///< n.x = Plane in the frame of the cell, if the cell is cut
  Vector3 Centre, Widths; ///< grid coordinates
  /// Gradient of D in the frame of the cell; at sides of the domain turned to the normal of the
  /// fitted plane.
  Vector3 Gradient;
};

/// Finds crossings. Keeps the cells of the last dual edges, since most cells have several; each
/// thread needs its own. The grid and the fractions must outlive it.
class CrossingFinder
{
public:
  /// @param fractions  the cells around both cells of each face must be in the local box or outside
  ///   the domain
  CrossingFinder(const CartesianGrid& grid, const FractionField& fractions, double isoValue);

  /// Returns where the interface crosses the dual edge of a face, in grid coordinates.
  ///
  /// For isoValue 0.5, the point is the mean of the cuts of the PLIC planes of both cells, weighted
  /// by f (1 - f). If neither cell is mixed, and for other iso values, it is interpolated linearly.
  /// The normal blends the normals of both cells, which are along the gradient over 3^3 cells
  /// (weighted least squares). The gradient is tilted in cells at a side of the domain. There, the
  /// normal is that of the plane that best fits the fractions of the pair around (LayerFit.h).
  Crossing Find(const InterfaceFace& face);

  /// Returns the crossing of the nearest face whose cells have the same pair of labels by their
  /// fractions, at most two cells away along each axis. If there is none, returns Find(face). It
  /// suits faces of cells whose labels differ from their fractions.
  Crossing FindNear(const InterfaceFace& face);

private:
  const EndCell& FindSide(const InterfaceFace& face, Index cell);

  const CartesianGrid& Grid;
  const FractionField& Fractions;
  const double IsoValue;
  std::vector<EndCell> Sides; // by cell and pair, as far as they have not been replaced
};

} // namespace vfm
