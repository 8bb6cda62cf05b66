#include "Phases/PlaceSurfaces.h"

#include "GivenSurfaces/SurfaceMatch.h"

#include <algorithm>

namespace vfm
{
namespace
{

std::unique_ptr<const BodySurfaces> Place(
  const MesherJob& job, const InputSurfaces& surfaces, const CartesianGrid& grid)
{
  const ImageFrame& frame = job.Input.Levels.Reading.Frame;
  auto placed = std::make_unique<const BodySurfaces>(surfaces, job.Input.Arrays.Fractions, grid,
    job.Options.EdgeAngle, [&frame](const Vector3& x) { return frame.ToOwn(x); });
  return placed->Bodies().empty() ? nullptr : std::move(placed);
}

/// Returns the text of the warning about bodies that do not match.
std::string DescribeOthers(const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return "The fractions are not those of the surfaces of " + text +
    ", which are not used. Was the grid moved after the fractions were computed? Move the "
    "surfaces before that instead.";
}

} // namespace

void MatchSurfaces(const MesherJob& job, Cells& cells)
{
  if (!job.Input.Surfaces || !job.Options.UseSurfaces)
  {
    return;
  }
  const std::unique_ptr<const BodySurfaces> bodies =
    Place(job, *job.Input.Surfaces, cells.Fields.Grid);
  if (!bodies)
  {
    return;
  }
  const std::vector<bool> matches =
    FindMatches(*bodies, cells.Fields.Grid, cells.Fields.Field.Fractions, job.Run);
  if (std::find(matches.begin(), matches.end(), false) == matches.end())
  {
    cells.Surfaces = job.Input.Surfaces;
    return;
  }
  auto kept = std::make_shared<InputSurfaces>();
  std::vector<std::string> others;
  for (std::size_t b = 0; b < matches.size(); ++b)
  {
    const std::string& name = job.Input.Arrays.Fractions[bodies->Bodies()[b].Material - 1];
    const auto& all = job.Input.Surfaces->Bodies;
    const auto body = std::find_if(
      all.begin(), all.end(), [&](const BodySurface& each) { return each.Name == name; });
    if (matches[b])
    {
      kept->Bodies.push_back(*body);
    }
    else
    {
      others.push_back(name);
    }
  }
  cells.Surfaces = std::move(kept);
  Warn(job, DescribeOthers(others));
}

std::unique_ptr<const BodySurfaces> PlaceSurfaces(const MesherJob& job, const Cells& cells)
{
  return cells.Surfaces ? Place(job, *cells.Surfaces, cells.Fields.Grid) : nullptr;
}

} // namespace vfm
