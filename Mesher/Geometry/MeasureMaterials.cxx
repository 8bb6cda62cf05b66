#include "Geometry/MeasureMaterials.h"

#include "Base/ExactSum.h"

namespace vfm
{
void MeasureMaterials(const Mesh& mesh, Ranks& ranks, MeshReport& report, const CellRuns* leftOut)
{
  const std::size_t materials = report.Materials.size();
  std::vector<std::int64_t> elements(materials, 0), perfect(materials, 0);
  std::vector<ExactSum> sums(materials);
  std::vector<double> worst(materials, -1.0); // minimum with changed sign
  const Index count = static_cast<Index>(mesh.Material.size());
  const bool isMeasured = !mesh.ScaledJacobian.empty();
  for (Index first = 0, last = 0; first < count; first = last) // runs of elements of one material
  {
    const int material = mesh.Material[first];
    std::int64_t ones = 0;
    for (; last < count && mesh.Material[last] == material; ++last)
    {
      const double quality = isMeasured ? mesh.ScaledJacobian[last] : 1.0;
      if (quality == 1.0)
      {
        ++ones;
        continue;
      }
      sums[material].Add(quality);
      worst[material] = std::max(worst[material], -quality);
    }
    elements[material] += last - first;
    perfect[material] += ones;
  }
  for (std::size_t r = 0; leftOut && r < leftOut->Runs.size(); ++r)
  {
    const CellRuns::Run& run = leftOut->Runs[r];
    elements[run.Material] += run.Count;
    perfect[run.Material] += run.Count;
  }
  for (std::size_t m = 0; m < materials; ++m)
  {
    sums[m].Add(1.0, perfect[m]);
  }
  ranks.Sum(elements);
  const std::vector<double> totals = SumOverRanks(sums, ranks);
  ranks.Max(worst);
  const bool hasQuality = ranks.Any(isMeasured);
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
