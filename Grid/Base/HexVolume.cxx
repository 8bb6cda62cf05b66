#include "Base/HexVolume.h"

#include "Base/Lanes.h"

namespace vfm
{

/// Evaluates four Gauss points at once.
VFM_CLONES
double VolumeBetween(const std::array<Vector3, 4>& a, const std::array<Vector3, 4>& b)
{
  const double low = 0.5 - 0.5 / std::sqrt(3.0), high = 1.0 - low;
  const Lanes one = Fill(1.0), r{ low, high, low, high }, s{ low, low, high, high };
  const Lanes shape[4] = { (one - r) * (one - s), r * (one - s), r * s, (one - r) * s };
  const Lanes byR[4] = { s - one, one - s, s, -s }, byS[4] = { r - one, -r, r, one - r };
  double volume = 0.0;
  for (const double t : { low, high })
  {
    Lanes3 dr{}, ds{}, dt{};
    for (int c = 0; c < 4; ++c)
    {
      const Vector3 x = (1.0 - t) * a[c] + t * b[c], across = b[c] - a[c];
      const Lanes3 place{ Fill(x[0]), Fill(x[1]), Fill(x[2]) },
        apart{ Fill(across[0]), Fill(across[1]), Fill(across[2]) };
      dr = dr + Times(byR[c], place);
      ds = ds + Times(byS[c], place);
      dt = dt + Times(shape[c], apart);
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
