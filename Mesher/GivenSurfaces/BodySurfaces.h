/**
 * BodySurfaces: the surfaces from which fractions were computed, in coordinates of the grid.
 */
#pragma once

#include "Base/BoxTree.h"
#include "Base/CartesianGrid.h"
#include "Base/Vector3.h"
#include "Surfaces/InputSurfaces.h"
#include "Surfaces/SurfaceSheets.h"
#include "Surfaces/SurfaceSides.h"

#include <functional>
#include <string>
#include <vector>

namespace vfm
{

/// Surface of the body of one material.
struct GivenBody
{
  int Material;           ///< number of the material, from 1
  ClosedSurface Boundary; ///< in grid coordinates (GridCoordinates.h)
  SurfaceSheets Sheets;   ///< of the edge angle
  SurfaceSides Sides;
};

/// The surfaces of a run, equal on all ranks. Those of a periodic domain are given once.
class BodySurfaces
{
public:
  /// @param surfaces  bodies; those without a material are ignored
  /// @param names  names of materials 1, 2, ..
  /// @param grid  finest grid of the run
  /// @param edgeAngle  least angle of sharp edges, in degrees
  /// @param toAxes  converts a point of the surfaces to axes of the grid; empty: they are the same
  BodySurfaces(const InputSurfaces& surfaces, const std::vector<std::string>& names,
    const CartesianGrid& grid, double edgeAngle,
    const std::function<Vector3(const Vector3&)>& toAxes = {});

  /// Bodies with materials; where bodies overlap, the first one keeps its volume.
  const std::vector<GivenBody>& Bodies() const { return this->TheBodies; }
  /// Returns the position in Bodies() of the body of a material; -1: it has no surface.
  int Find(int material) const
  {
    const std::size_t number = static_cast<std::size_t>(material);
    return number < this->BodyOf.size() ? this->BodyOf[number] : -1;
  }
  /// Returns the position in Bodies() of the body on whose surface the interface of two materials
  /// lies: the only one, or the first one. -1: none.
  int FindOfInterface(int material, int other) const;
  /// Returns the lengths after which the domain repeats along each axis, in grid coordinates; 0: it
  /// does not.
  const Vector3& Periods() const { return this->ThePeriods; }

  /// Returns the domain, in grid coordinates.
  const Bounds& Domain() const { return this->TheDomain; }

private:
  std::vector<GivenBody> TheBodies;
  std::vector<int> BodyOf; // of each material from 0, or -1
  Vector3 ThePeriods;
  Bounds TheDomain;
};

} // namespace vfm
