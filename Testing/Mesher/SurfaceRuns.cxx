#include "SurfaceRuns.h"

#include "Input/PlainArrays.h"
#include "LabelInput.h"
#include "Surfaces/SurfaceFractions.h"

#include <mutex>

namespace vfm
{
namespace testing
{
namespace
{

/// Returns the bodies in world coordinates.
InputSurfaces InSpace(const SurfaceCase& c)
{
  InputSurfaces turned = c.Surfaces;
  for (BodySurface& body : turned.Bodies)
  {
    for (Vector3& x : body.Boundary.Points)
    {
      x = c.Frame.ToSpace(x);
    }
    for (PointTriangle& t : body.Boundary.Triangles)
    {
      if (c.Frame.IsMirrored())
      {
        std::swap(t[1], t[2]);
      }
    }
  }
  return turned;
}

} // namespace

MesherInput MakeSurfaceInput(const SurfaceCase& c, Ranks& ranks)
{
  const Index3& n = c.Cells;
  const Index first = ranks.Rank() * n[2] / ranks.Count();
  const Index last = (ranks.Rank() + 1) * n[2] / ranks.Count();
  const IndexBox cells{ { { 0, 0, first } }, { { n[0], n[1], last } } };
  std::array<std::vector<double>, 3> coordinates;
  for (int a = 0; a < 3; ++a)
  {
    for (Index i = 0; i <= n[a]; ++i)
    {
      coordinates[a].push_back(static_cast<double>(i));
    }
  }
  Runtime serial;
  std::vector<Buffer<double>> fractions =
    FractionsOfSurfaces(coordinates, cells, c.Surfaces, serial);
  auto arrays = std::make_shared<PlainArrays>(cells.NumberOfCells());
  std::vector<std::string> names;
  for (std::size_t b = 0; b < fractions.size(); ++b)
  {
    names.push_back(c.Surfaces.Bodies[b].Name);
    arrays->Store(names.back(), ValueType::Double, std::move(fractions[b]));
  }
  MesherInput input = MakeInput({ MakeBlock(cells, {}, 1.0, arrays) }, ranks);
  input.Levels.Reading.Frame = c.Frame;
  input.Arrays.Fractions = names;
  input.Surfaces = std::make_shared<const InputSurfaces>(InSpace(c));
  return input;
}

SurfaceMesh MeshSurfaces(const SurfaceCase& c, const MesherOptions& options, int ranks)
{
  SurfaceMesh made;
  std::mutex mutex;
  RunOnRanks(ranks,
    [&](ThreadRanks& group)
    {
      RankRuntime runtime(group);
      const MesherResult result = RunMesher(MakeSurfaceInput(c, group), options, runtime);
      const std::lock_guard<std::mutex> lock(mutex);
      made.Merged.Add(result.TheMesh);
      made.Fields = result.Fields;
      made.Report = result.Report;
    });
  return made;
}

} // namespace testing
} // namespace vfm
