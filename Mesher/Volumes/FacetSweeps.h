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
  /// @param start,now  positions at the start and at present
  void Set(int facet, int corner, const Vector3& start, const Vector3& now)
  {
    for (int a = 0; a < 3; ++a)
    {
      this->Start[facet / 4][corner][a][facet % 4] = start[a];
      this->Now[facet / 4][corner][a][facet % 4] = now[a];
    }
  }

  /// Computes the area of each of the first facets, and VolumeBetween its corners at the start and
  /// now.
  /// @param facets  number of facets; up to the next multiple of four, all must be set
  void Measure(int facets, double (&volumes)[Most], double (&areas)[Most]) const;

private:
  using Four = double[4][3][4]; // of each corner and axis, for four facets

  Four Start[Most / 4], Now[Most / 4];
};

} // namespace vfm
