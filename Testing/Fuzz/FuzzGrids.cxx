#include "FuzzGrids.h"

#include <algorithm>
#include <cstdio>

namespace vfm
{
namespace testing
{
namespace
{

constexpr double LargestAspect = 100.0; // ratio of the widths of a cell
constexpr double LargestGrading = 7.0;  // ratio of neighbouring widths along an axis
constexpr double FarthestOrigin = 1e5;  // in mean widths
constexpr double LargestScale = 1e6;

using Widths = std::array<std::vector<double>, 3>;

/// Returns the largest ratio of two widths of a cell.
double AspectOf(const Widths& widths)
{
  double aspect = 1.0;
  for (int a = 0; a < 3; ++a)
  {
    const double widest = *std::max_element(widths[a].begin(), widths[a].end());
    for (int b = 0; b < 3; ++b)
    {
      const double least = *std::min_element(widths[b].begin(), widths[b].end());
      aspect = std::max(aspect, a == b ? 1.0 : widest / least);
    }
  }
  return aspect;
}

double GradingOf(const Widths& widths)
{
  double grading = 1.0;
  for (const std::vector<double>& axis : widths)
  {
    for (std::size_t i = 1; i < axis.size(); ++i)
    {
      grading = std::max({ grading, axis[i] / axis[i - 1], axis[i - 1] / axis[i] });
    }
  }
  return grading;
}

enum class Kind
{
  Cubes,
  Boxes,  ///< equal boxes
  Graded, ///< each wider or narrower than the one before
  Random
};

Widths DrawWidths(const Index3& cells, Kind kind, RandomDraw& draw)
{
  Widths widths;
  const double aspect = draw.Scale(1.2, LargestAspect), grading = draw.Scale(1.1, LargestGrading);
  for (int a = 0; a < 3; ++a)
  {
    double width = kind == Kind::Cubes ? 1.0 : draw.Scale(1.0, aspect);
    for (Index i = 0; i < cells[a]; ++i)
    {
      const double random = draw.Scale(1.0, grading);
      widths[a].push_back(kind == Kind::Random ? width * random : width);
      if (kind == Kind::Graded)
      {
        width *= draw.Pick({ random, 1.0 / random, grading, 1.0 });
      }
    }
  }
  const double reached = AspectOf(widths);
  if (reached > LargestAspect)
  {
    const double power = std::log(LargestAspect) / std::log(reached);
    for (std::vector<double>& axis : widths)
    {
      std::transform(axis.begin(), axis.end(), axis.begin(),
        [power](double width) { return std::pow(width, power); });
    }
  }
  return widths;
}

} // namespace

FuzzGrid DrawGrid(const Index3& cells, RandomDraw& draw)
{
  const Kind kind =
    draw.Pick({ Kind::Cubes, Kind::Cubes, Kind::Boxes, Kind::Graded, Kind::Random });
  const Widths widths = DrawWidths(cells, kind, draw);
  const double scale = draw.Chance(0.5) ? 1.0 : draw.Scale(1.0 / LargestScale, LargestScale);
  const double far = draw.Chance(0.5) ? 0.0 : draw.Scale(1.0, FarthestOrigin);
  double volume = 1.0;
  for (const std::vector<double>& axis : widths)
  {
    double length = 0.0;
    for (double width : axis)
    {
      length += width;
    }
    volume *= length / static_cast<double>(axis.size());
  }
  std::array<std::vector<double>, 3> coordinates;
  for (int a = 0; a < 3; ++a)
  {
    double at = far * std::cbrt(volume) * draw.Between(-1.0, 1.0);
    coordinates[a].push_back(scale * at);
    for (double width : widths[a])
    {
      at += width;
      coordinates[a].push_back(scale * at);
    }
  }
  char words[160];
  std::snprintf(words, sizeof words,
    "%lld x %lld x %lld cells, aspect %.3g, grading %.3g, scale %.2g, origin %.2g widths away",
    static_cast<long long>(cells[0]), static_cast<long long>(cells[1]),
    static_cast<long long>(cells[2]), AspectOf(widths), GradingOf(widths), scale, far);
  return { CartesianGrid(coordinates), kind == Kind::Cubes, words };
}

} // namespace testing
} // namespace vfm
