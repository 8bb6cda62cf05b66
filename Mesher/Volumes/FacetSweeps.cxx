#include "Volumes/FacetSweeps.h"

#include "Base/Lanes.h"

namespace vfm
{
namespace
{

// Places of the points of the Gauss rule, and the rest to 1 of the second.
constexpr double Sqrt3 = 1.7320508075688772;
constexpr double Low = 0.5 - 0.5 / Sqrt3, High = 1.0 - Low, BeyondHigh = 1.0 - High;

/// Returns a quad at part t of the way from a to b.
VFM_INLINE Lanes3 Between(const Lanes3& a, const Lanes3& b, double t)
{
  return Times(Fill(1.0 - t), a) + Times(Fill(t), b);
}

/// Returns the derivative of the position along the first axis of a quad, whose place along the
/// second one is s = 1 - rest.
VFM_INLINE Lanes3 AlongFirst(const Lanes3 (&x)[4], double s, double rest)
{
  const Lanes near = Fill(rest), far = Fill(s);
  return ((Times(near, x[1]) - Times(near, x[0])) + Times(far, x[2])) - Times(far, x[3]);
}

/// The same along the second axis; the place along the first one is r.
VFM_INLINE Lanes3 AlongSecond(const Lanes3 (&x)[4], double r, double rest)
{
  const Lanes near = Fill(rest), far = Fill(r);
  return (Times(far, x[2]) - (Times(near, x[0]) + Times(far, x[1]))) + Times(near, x[3]);
}

/// Returns the value at a place of a quad.
VFM_INLINE Lanes3 ValueAt(const Lanes3 (&x)[4], double r, double restOfR, double s, double restOfS)
{
  return ((Times(Fill(restOfR * restOfS), x[0]) + Times(Fill(r * restOfS), x[1])) +
           Times(Fill(r * s), x[2])) +
    Times(Fill(restOfR * s), x[3]);
}

/// Evaluates VolumeBetween in each lane, with the same operations in the same order.
VFM_INLINE Lanes VolumesBetween(const Lanes3 (&a)[4], const Lanes3 (&b)[4])
{
  const Lanes3 across[4] = { b[0] - a[0], b[1] - a[1], b[2] - a[2], b[3] - a[3] };
  const Lanes3 dt[4] = { ValueAt(across, Low, High, Low, High),
    ValueAt(across, High, BeyondHigh, Low, High), ValueAt(across, Low, High, High, BeyondHigh),
    ValueAt(across, High, BeyondHigh, High, BeyondHigh) };
  Lanes volume = Fill(0.0);
  for (const double t : { Low, High })
  {
    const Lanes3 x[4] = { Between(a[0], b[0], t), Between(a[1], b[1], t), Between(a[2], b[2], t),
      Between(a[3], b[3], t) };
    const Lanes3 dr[2] = { AlongFirst(x, Low, High), AlongFirst(x, High, BeyondHigh) };
    const Lanes3 ds[2] = { AlongSecond(x, Low, High), AlongSecond(x, High, BeyondHigh) };
    for (int g = 0; g < 4; ++g)
    {
      volume = volume + Dot(dr[g >> 1], Cross(ds[g & 1], dt[g])) * 0.125;
    }
  }
  return volume;
}

VFM_INLINE Lanes3 Load(const double (&corner)[3][4])
{
  return { LoadLanes(corner[0]), LoadLanes(corner[1]), LoadLanes(corner[2]) };
}

} // namespace

VFM_CLONES
void FacetCorners::Measure(int facets, double (&volumes)[Most], double (&areas)[Most]) const
{
  for (int first = 0; first < facets; first += 4)
  {
    Lanes3 start[4], now[4];
    for (int c = 0; c < 4; ++c)
    {
      start[c] = Load(this->Start[first / 4][c]);
      now[c] = Load(this->Now[first / 4][c]);
    }
    StoreLanes(VolumesBetween(start, now), volumes + first);
    const Lanes3 normal = Cross(now[2] - now[0], now[3] - now[1]);
    StoreLanes(0.5 * SquareRoot(Dot(normal, normal)), areas + first);
  }
}

} // namespace vfm
