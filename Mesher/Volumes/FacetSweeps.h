/**
 * FacetSweeps: areas of facets and the volumes that they have swept, several facets at once.
 */
#pragma once

#include "Base/Vector3.h"

namespace vfm
{

/// Corners of up to 16 facets. Each four facets are beside each other in memory.
class FacetCorners
{
public:
  static constexpr int Most = 16;

  /// Sets a corner of a facet, both from 0.
  /// @param start  position at the start, in length units of the mesh
  /// @param now  present position, in grid coordinates
  void Set(int facet, int corner, const double* start, const double* now)
  {
    for (int a = 0; a < 3; ++a)
    {
      this->Start[facet / 4][corner][a][facet % 4] = start[a];
      this->Now[facet / 4][corner][a][facet % 4] = now[a];
    }
  }

  /// Computes the area of each of the first facets, and VolumeBetween its corners at the start and
  /// now, in grid coordinates.
  /// @param facets  number of facets; up to the next multiple of four, all must be set
  /// @param origin  of grid coordinates
  /// @param scale  unit of grid coordinates
  void Measure(int facets, const Vector3& origin, double scale, double (&volumes)[Most],
    double (&areas)[Most]) const;

private:
  using Four = double[4][3][4]; // of each corner and axis, for four facets

  Four Start[Most / 4], Now[Most / 4];
};

} // namespace vfm
