#include "Base/HexVolume.h"

#include "Base/Lanes.h"

namespace vfm
{

/// Four points of Gauss at once.
VFM_CLONES
double VolumeBetween(const std::array<Vector3, 4>& a, const std::array<Vector3, 4>& b)
{
  const double low = 0.5 - 0.5 / std::sqrt(3.0), high = 1.0 - low;
  const Lanes one = Splat(1.0), r{ low, high, low, high }, s{ low, low, high, high };
  const Lanes shape[4] = { (one - r) * (one - s), r * (one - s), r * s, (one - r) * s };
  const Lanes byR[4] = { s - one, one - s, s, -s }, byS[4] = { r - one, -r, r, one - r };
  double volume = 0.0;
  for (const double t : { low, high })
  {
    Lanes3 dr{}, ds{}, dt{};
    for (int c = 0; c < 4; ++c)
    {
      const Vector3 x = (1.0 - t) * a[c] + t * b[c], across = b[c] - a[c];
      const Lanes3 place{ Splat(x[0]), Splat(x[1]), Splat(x[2]) };
      dr = Plus(dr, Times(byR[c], place));
      ds = Plus(ds, Times(byS[c], place));
      dt = Plus(dt, Times(shape[c], { Splat(across[0]), Splat(across[1]), Splat(across[2]) }));
    }
    const Lanes parts = Dot(dr, Cross(ds, dt));
    for (int g = 0; g < 4; ++g)
    {
      volume += parts[g] / 8.0;
    }
  }
  return volume;
}

} // namespace vfm
