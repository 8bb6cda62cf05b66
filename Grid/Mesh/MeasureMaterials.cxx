#include "Mesh/MeasureMaterials.h"

#include "Base/ExactSum.h"

#include <algorithm>

namespace vfm
{
namespace
{

/// The smallest of each over all ranks.
void TakeSmallest(std::vector<float>& values, Ranks& ranks)
{
  for (const Bytes& bytes : ranks.Gather(ToBytes(values)))
  {
    const std::vector<float> others = FromBytes<float>(bytes);
    for (std::size_t v = 0; v < values.size(); ++v)
    {
      values[v] = std::min(values[v], others[v]);
    }
  }
}

} // namespace

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
  std::vector<float> smallest(materials, 1.0F);
  for (std::size_t e = 0; e < mesh.ScaledJacobian.size(); ++e)
  {
    const int material = mesh.Material[e];
    sums[material].Add(mesh.ScaledJacobian[e]);
    smallest[material] = std::min(smallest[material], mesh.ScaledJacobian[e]);
  }
  const std::vector<double> totals = SumOverRanks(sums, ranks);
  TakeSmallest(smallest, ranks);
  const bool hasQuality = ranks.Any(!mesh.ScaledJacobian.empty());
  for (std::size_t m = 0; m < materials; ++m)
  {
    MeshReport::Material& material = report.Materials[m];
    material.Elements = elements[m];
    if (hasQuality && elements[m] > 0)
    {
      material.MinimumScaledJacobian = static_cast<double>(smallest[m]);
      material.MeanScaledJacobian = totals[m] / static_cast<double>(elements[m]);
    }
  }
}

} // namespace vfm
