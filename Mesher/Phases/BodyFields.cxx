#include "Phases/BodyFields.h"

#include "Base/ParseText.h"
#include "Materials/MaterialTexts.h"
#include "Surfaces/SurfaceThickness.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace vfm
{
namespace
{

using Body = MeshReport::Body;

// Area without a warning: of a part far from the mesh, in squares of the cell width, that of a
// sharp tip; of all that is lost, over the area of the surface, that of edges of wedges.
constexpr double LargestQuietArea = 8.0, LargestQuietShare = 0.05;

bool HasElements(const MeshReport& report, const Body& body)
{
  return report.Materials[body.Material].Elements > 0;
}

bool IsInPieces(const MeshReport& report, const Body& body)
{
  return body.IsWhole && report.Materials[body.Material].Fragments > body.Solids;
}

bool LosesSurface(const Body& body)
{
  return body.LostArea > LargestQuietArea || body.LostShare > LargestQuietShare;
}

std::string PrintLength(double length)
{
  std::ostringstream text;
  text << std::setprecision(3) << length;
  return text.str();
}

std::string PrintPlace(const Vector3& x)
{
  return "(" + PrintLength(x[0]) + ", " + PrintLength(x[1]) + ", " + PrintLength(x[2]) + ")";
}

/// Returns a body and what it loses.
std::string DescribeBody(const MeshReport& report, const Materials& table, const Body& body,
  double width, const ImageFrame& frame)
{
  std::vector<std::string> losses;
  if (body.LostSolids > 0)
  {
    losses.push_back(std::to_string(body.LostSolids) + " of its " + std::to_string(body.Solids) +
      " solids have no elements");
  }
  if (LosesSurface(body))
  {
    losses.push_back(PercentOf(body.LostShare) +
      " of its surface is farther than a cell from the mesh, most near " +
      PrintPlace(frame.ToSpace(body.LostPlace)) + " over a length of " +
      PrintLength(width * body.LostLength) + ", where it is " +
      PrintLength(width * body.LostThickness) + " thick");
  }
  if (IsInPieces(report, body))
  {
    losses.push_back("it has " + std::to_string(report.Materials[body.Material].Fragments) +
      " fragments instead of " + std::to_string(body.Solids));
  }
  return NameMaterial(table, body.Material) + ": " + JoinTexts(losses);
}

/// Returns the cell width that keeps what a body loses, in mean widths of the finest cells.
double FindKeepingWidth(const MeshReport& report, const Body& body)
{
  const double lost =
    body.LostSolids > 0 || LosesSurface(body) ? body.LostThickness : body.Thickness;
  return (IsInPieces(report, body) ? std::min(lost, body.Thickness) : lost) / CellsOfThickness;
}

} // namespace

FieldArrays ListBodies(
  const MeshReport& report, const Materials& table, double width, bool meshVoid)
{
  if (report.Bodies.empty())
  {
    return {};
  }
  const std::size_t count = table.Names.size();
  std::vector<double> thickness(count, 0.0), widths(count, 0.0), lost(count, 0.0);
  std::vector<Index> solids(count, 0);
  for (const Body& body : report.Bodies)
  {
    thickness[body.Material] = body.Thickness;
    widths[body.Material] = width * body.Thickness / CellsOfThickness;
    lost[body.Material] = body.LostShare;
    solids[body.Material] = body.Solids;
  }
  return { { "SurfaceThickness", TakeMeshed(thickness, meshVoid) },
    { "SuggestedWidth", TakeMeshed(widths, meshVoid) },
    { "LostSurface", TakeMeshed(lost, meshVoid) }, { "Solids", TakeMeshed(solids, meshVoid) } };
}

std::string DescribeLostBodies(
  const MeshReport& report, const Materials& table, double width, const ImageFrame& frame)
{
  std::vector<std::string> losses;
  double keeping = 1e300;
  for (const Body& body : report.Bodies)
  {
    if (HasElements(report, body) &&
      (body.LostSolids > 0 || LosesSurface(body) || IsInPieces(report, body)))
    {
      losses.push_back(DescribeBody(report, table, body, width, frame));
      keeping = std::min(keeping, FindKeepingWidth(report, body));
    }
  }
  return losses.empty() ? ""
                        : CountMaterials(losses.size(), "loses", "lose") +
      " parts that are thinner than its cells: " + Enumerate(losses) + ". A cell width of " +
      PrintLength(RoundDown(width * keeping)) + " or less should keep them.";
}

} // namespace vfm
