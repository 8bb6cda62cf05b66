#include "Geometry/MeasureSurfaces.h"

#include "Base/ExactSum.h"
#include "Base/Vector3.h"
#include "Octree/RefinedGrid.h"

#include <mutex>

namespace vfm
{
namespace
{

constexpr int SumsOfSurface = 7; // area, first moments, vector area

/// Adds the sums of a facet.
/// @param x  corners
void AddFacet(const std::array<Vector3, 4>& x, int corners, ExactSum* sum)
{
  for (int c = 2; c < corners; ++c)
  {
    const Vector3 vector = 0.5 * Cross(x[c - 1] - x[0], x[c] - x[0]);
    const double area = Norm(vector);
    const Vector3 moment = (area / 3.0) * (x[0] + x[c - 1] + x[c]);
    sum[0].Add(area);
    for (int axis = 0; axis < 3; ++axis)
    {
      sum[1 + axis].Add(moment[axis]);
      sum[4 + axis].Add(vector[axis]);
    }
  }
}

/// Returns the sums of each surface over all ranks, in units of `unit` and relative to `origin`.
std::vector<double> SumFacets(
  const Mesh& mesh, const Vector3& origin, double unit, Runtime& runtime)
{
  std::vector<ExactSum> sums(SumsOfSurface * mesh.Tables.SurfaceVolumes.size());
  const SurfaceFacets& facets = mesh.Surfaces;
  const int corners = mesh.CornersOfFacet();
  const double scale = 1.0 / unit;
  std::mutex lock;
  runtime.For(0, static_cast<Index>(facets.SurfaceId.size()),
    [&](Index first, Index last)
    {
      std::vector<ExactSum> own(sums.size());
      for (Index f = first; f < last; ++f)
      {
        if (!facets.IsOwned[f])
        {
          continue;
        }
        std::array<Vector3, 4> x;
        for (int c = 0; c < corners; ++c)
        {
          x[c] = scale * (mesh.PointAt(facets.Points[corners * f + c]) - origin);
        }
        AddFacet(x, corners, own.data() + SumsOfSurface * (facets.SurfaceId[f] - 1));
      }
      const std::lock_guard<std::mutex> guard(lock);
      for (std::size_t s = 0; s < sums.size(); ++s)
      {
        sums[s].Add(own[s]);
      }
    });
  return SumOverRanks(sums, runtime.Group());
}

} // namespace

void MeasureSurfaces(Mesh& mesh, Runtime& runtime)
{
  const CartesianGrid& grid = mesh.Levels->Finest();
  const double unit = grid.MeanWidth();
  const Vector3 origin{ { grid.Coordinates(0)[0], grid.Coordinates(1)[0],
    grid.Coordinates(2)[0] } };
  const std::vector<double> sums = SumFacets(mesh, origin, unit, runtime);
  GeometryTables& tables = mesh.Tables;
  for (std::size_t at = 0; at < sums.size(); at += SumsOfSurface)
  {
    const double* sum = sums.data() + at;
    const double share = sum[0] > 0.0 ? 1.0 / sum[0] : 0.0;
    tables.SurfaceAreas.push_back(unit * unit * sum[0]);
    tables.SurfaceCentroids.push_back(
      origin + (unit * share) * Vector3{ { sum[1], sum[2], sum[3] } });
    tables.SurfaceNormals.push_back(share * Vector3{ { sum[4], sum[5], sum[6] } });
  }
}

} // namespace vfm
