/**
 * Makes a solid from a triangle surface, and computes its fractions. The input is the number of
 * points (a byte), three doubles per point, and three numbers of points (a byte each) per triangle.
 */
#include "Harness.h"

#include "Ranks/Errors.h"
#include "Surfaces/SurfaceFractions.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace vfm
{
namespace testing
{
namespace
{

constexpr std::size_t Most = 6; // nodes of the grid along an axis

unsigned char ByteAt(const std::string& bytes, std::size_t at)
{
  return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0;
}

std::vector<Vector3> ReadPoints(const std::string& bytes)
{
  std::vector<Vector3> points(ByteAt(bytes, 0));
  const std::size_t size = std::min(points.size() * sizeof(Vector3), bytes.size() - 1);
  if (size > 0)
  {
    std::memcpy(points.data(), bytes.data() + 1, size);
  }
  return points;
}

std::vector<PointTriangle> ReadTriangles(const std::string& bytes, std::size_t begin)
{
  std::vector<PointTriangle> triangles;
  for (std::size_t at = begin; at + 3 <= bytes.size(); at += 3)
  {
    triangles.push_back({ { ByteAt(bytes, at), ByteAt(bytes, at + 1), ByteAt(bytes, at + 2) } });
  }
  return triangles;
}

/// Returns nodes at the coordinates of some corners of triangles.
std::array<std::vector<double>, 3> NodesOf(const ClosedSurface& surface)
{
  std::array<std::vector<double>, 3> nodes;
  for (int a = 0; a < 3; ++a)
  {
    for (std::size_t t = 0; t < std::min(surface.Triangles.size(), Most); ++t)
    {
      nodes[a].push_back(surface.Points[surface.Triangles[t][0]][a]);
    }
    std::sort(nodes[a].begin(), nodes[a].end());
    nodes[a].erase(std::unique(nodes[a].begin(), nodes[a].end()), nodes[a].end());
  }
  return nodes;
}

void CheckFractions(const ClosedSurface& surface)
{
  const std::array<std::vector<double>, 3> nodes = NodesOf(surface);
  InputSurfaces input;
  input.Bodies.push_back({ "body", surface, {}, {} });
  IndexBox cells;
  for (int a = 0; a < 3; ++a)
  {
    cells.Upper[a] = static_cast<Index>(nodes[a].size()) - 1;
  }
  Runtime runtime;
  const std::vector<Buffer<double>> fractions = FractionsOfSurfaces(nodes, cells, input, runtime);
  for (double fraction : fractions[0])
  {
    if (!(fraction >= 0.0 && fraction <= 1.0))
    {
      throw std::logic_error("a fraction that is not from 0 to 1");
    }
  }
}

/// Checks that points and triangles in reverse order give the same surface.
void CheckOrder(
  std::vector<Vector3> points, std::vector<PointTriangle> triangles, const ClosedSurface& expected)
{
  std::reverse(points.begin(), points.end());
  std::reverse(triangles.begin(), triangles.end());
  const Index last = static_cast<Index>(points.size()) - 1;
  for (PointTriangle& t : triangles)
  {
    t = { { last - t[1], last - t[2], last - t[0] } };
  }
  const ClosedSurface found = CloseSurface(points, triangles);
  if (found.Points != expected.Points || found.Triangles != expected.Triangles)
  {
    throw std::logic_error("a surface that depends on the order of the input");
  }
}

} // namespace

void ReadBytes(const std::string& bytes)
{
  if (bytes.empty())
  {
    return;
  }
  const std::vector<Vector3> points = ReadPoints(bytes);
  const std::vector<PointTriangle> triangles =
    ReadTriangles(bytes, 1 + points.size() * sizeof(Vector3));
  const ClosedSurface surface = CloseSurface(points, triangles);
  CheckOrder(points, triangles, surface);
  CheckFractions(surface);
}

} // namespace testing
} // namespace vfm
