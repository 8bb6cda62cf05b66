#include "MeshDigest.h"

#include <algorithm>
#include <cstring>

namespace vfm
{
namespace testing
{
namespace
{

/// Digest of a sequence of numbers.
class Digest
{
public:
  explicit Digest(std::uint64_t kind) : Value(kind) {}
  void Add(std::int64_t number)
  {
    this->Value = (this->Value ^ static_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15U;
    this->Value ^= this->Value >> 29;
  }
  void Add(double number)
  {
    std::int64_t bits;
    std::memcpy(&bits, &number, sizeof(bits));
    this->Add(bits);
  }
  std::uint64_t Get() const { return this->Value * 0xbf58476d1ce4e5b9U; }

private:
  std::uint64_t Value;
};

std::uint64_t DigestOfElements(const Mesh& mesh)
{
  std::uint64_t sum = 0;
  for (std::size_t e = 0; e < mesh.ElementIds.size(); ++e)
  {
    Digest digest(1);
    digest.Add(mesh.ElementIds[e]);
    digest.Add(static_cast<std::int64_t>(mesh.Material[e]));
    digest.Add(static_cast<std::int64_t>(mesh.Fragment[e]));
    for (int c = 0; c < mesh.Corners; ++c)
    {
      const Index point = mesh.Elements[e * mesh.Corners + c];
      digest.Add(mesh.PointIds[point]);
      digest.Add(static_cast<std::int64_t>(mesh.GeometryDimension[point]));
      digest.Add(static_cast<std::int64_t>(mesh.GeometryId[point]));
      for (double x : mesh.PointAt(point))
      {
        digest.Add(x);
      }
    }
    sum += digest.Get();
  }
  return sum;
}

/// Returns the digest of what is listed by its points and a number: facets, edges or vertices.
std::uint64_t DigestOfParts(std::uint64_t kind, const Mesh& mesh, const Buffer<Index>& points,
  std::size_t width, const Buffer<int>& numbers)
{
  std::uint64_t sum = 0;
  std::vector<Index> ids(width);
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    for (std::size_t c = 0; c < width; ++c)
    {
      ids[c] = mesh.PointIds[points[width * i + c]];
    }
    std::sort(ids.begin(), ids.end());
    Digest digest(kind);
    digest.Add(static_cast<std::int64_t>(numbers[i]));
    for (Index id : ids)
    {
      digest.Add(id);
    }
    sum += digest.Get();
  }
  return sum;
}

} // namespace

std::uint64_t DigestOfRank(const Mesh& mesh)
{
  const SurfaceFacets& facets = mesh.Surfaces; // each is on one rank
  return DigestOfElements(mesh) +
    DigestOfParts(2, mesh, facets.Points, mesh.CornersOfFacet(), facets.SurfaceId) +
    DigestOfParts(3, mesh, mesh.Curves.Points, 2, mesh.Curves.CurveId) +
    DigestOfParts(4, mesh, mesh.Vertices.Points, 1, mesh.Vertices.VertexId);
}

} // namespace testing
} // namespace vfm
