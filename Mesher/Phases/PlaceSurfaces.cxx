#include "Phases/PlaceSurfaces.h"

namespace vfm
{

std::unique_ptr<const BodySurfaces> PlaceSurfaces(const MesherJob& job, const CartesianGrid& grid)
{
  const InputSurfaces* surfaces = job.Input.Surfaces.get();
  if (!surfaces || !job.Options.UseSurfaces)
  {
    return nullptr;
  }
  const ImageFrame& frame = job.Input.Levels.Reading.Frame;
  auto placed = std::make_unique<const BodySurfaces>(*surfaces, job.Input.Arrays.Fractions, grid,
    job.Options.EdgeAngle, [&frame](const Vector3& x) { return frame.ToOwn(x); });
  return placed->Bodies().empty() ? nullptr : std::move(placed);
}

} // namespace vfm
