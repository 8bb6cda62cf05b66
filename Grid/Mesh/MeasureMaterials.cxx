#include "Mesh/MeasureMaterials.h"

#include "Base/ExactSum.h"
#include "Base/MaxOfEach.h"

namespace vfm
{
void MeasureMaterials(const Mesh& mesh, Ranks& ranks, MeshReport& report)
{
  const std::size_t materials = report.Materials.size();
  std::vector<std::int64_t> elements(materials, 0);
  for (int material : mesh.Material)
  {
    ++elements[material];
  }
  ranks.Sum(elements);
  std::vector<ExactSum> sums(materials);
  std::vector<double> worst(materials, -1.0); // the smallest, negative
  for (std::size_t e = 0; e < mesh.ScaledJacobian.size(); ++e)
  {
    const int material = mesh.Material[e];
    const double quality = mesh.ScaledJacobian[e];
    sums[material].Add(quality);
    worst[material] = std::max(worst[material], -quality);
  }
  const std::vector<double> totals = SumOverRanks(sums, ranks);
  MaxOfEach(worst, ranks);
  const bool hasQuality = ranks.Any(!mesh.ScaledJacobian.empty());
  for (std::size_t m = 0; m < materials; ++m)
  {
    MeshReport::Material& material = report.Materials[m];
    material.Elements = elements[m];
    if (hasQuality && elements[m] > 0)
    {
      material.MinimumScaledJacobian = -worst[m];
      material.MeanScaledJacobian = totals[m] / static_cast<double>(elements[m]);
    }
  }
}

} // namespace vfm
