#include "Tet/TetImprove.h"

#include "Smoothing/Smoother.h"

namespace vfm
{

TetQualityFloors FloorsOf(const MeshOptions& options)
{
  TetQualityFloors floors;
  if (options.TargetScaledJacobian > 0.0)
  {
    floors.Acute = options.TargetScaledJacobian;
    floors.Obtuse = std::min(options.TargetScaledJacobian + 0.1, 0.95);
  }
  return floors;
}

const SmoothingRamp& TetRamp()
{
  static const SmoothingRamp ramp{ { 1, 1.0, 0.1, 5, 0.0 }, { 2, 10.0, 0.05, 10, 0.0 },
    { 8, 70.0, 0.01, 15, 2e-3 } };
  return ramp;
}

void ImproveInside(const TetEnergy& energy, std::size_t fixed,
  const std::vector<std::array<int, 4>>& tets, std::vector<Vector3>& points)
{
  ActiveMesh active;
  active.Corners = 4;
  active.X = points;
  active.Fixed.assign(points.size(), 0);
  active.IsActive.assign(points.size(), 1);
  std::fill_n(active.IsActive.begin(), fixed, 0);
  for (const std::array<int, 4>& tet : tets)
  {
    active.Elements.insert(active.Elements.end(), tet.begin(), tet.end());
  }
  active.Widths.assign(1, { { 1.0, 1.0, 1.0 } });
  active.AttachmentOffset.assign(points.size() + 1, 0);
  active.Colours[0].push_back({ static_cast<int>(fixed), static_cast<int>(points.size()) });
  active.ListCorners();
  Runtime alone;
  const PointExchange exchange(alone.Group());
  Smoother smoother(active, nullptr, exchange, energy, alone);
  for (const SmoothingStage& stage : TetRamp())
  {
    smoother.RunStage(stage, [](double) {});
  }
  points = active.X;
}

} // namespace vfm
