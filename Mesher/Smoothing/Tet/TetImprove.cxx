#include "Smoothing/Tet/TetImprove.h"

#include "Smoothing/ActiveMeshBuilder.h"
#include "Smoothing/Smoother.h"

namespace vfm
{
namespace
{

const SmoothingPace Pace{ 1.3, 1.0, 0.0, 2e-4, 4e-3 };

} // namespace

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

const SmoothingRamp& TetRamp(TetMethod method)
{
  const auto make = [](double weight)
  {
    return SmoothingRamp{ { 2, 10.0, 0.05, 8, 0.0, Pace, 2 }, { 8, weight, 0.01, 15, 2e-3, Pace } };
  };
  static const SmoothingRamp cells = make(70.0), lattice = make(100.0);
  return method == TetMethod::Lattice ? lattice : cells;
}

void ImproveInside(const TetEnergy& energy, std::size_t fixed,
  const std::vector<std::array<int, 4>>& tets, std::vector<Vector3>& points,
  const std::function<void(double)>& progress)
{
  std::vector<Mover> movers;
  for (std::size_t p = fixed; p < points.size(); ++p)
  {
    movers.push_back({ static_cast<Index>(p), static_cast<Index>(p), 0, {}, 0 });
  }
  ActiveMeshBuilder builder(4, points.size(), std::move(movers));
  for (const std::array<int, 4>& tet : tets)
  {
    builder.Add(tet.data());
  }
  ActiveMesh active = builder.FinishAlone();
  active.Widths.assign(1, { { 1.0, 1.0, 1.0 } });
  for (std::size_t p = 0; p < active.X.size(); ++p)
  {
    active.X[p] = points[active.MeshPoint[p]];
  }
  Runtime alone;
  Smoother smoother(active, nullptr, energy, alone);
  const double share = 1.0 / static_cast<double>(TetRamp().size());
  double done = 0.0;
  for (const SmoothingStage& stage : TetRamp())
  {
    smoother.RunStage(stage, [&](double fraction) { progress(done + share * fraction); });
    done += share;
  }
  for (std::size_t p = 0; p < active.X.size(); ++p)
  {
    points[active.MeshPoint[p]] = active.X[p];
  }
}

} // namespace vfm
