#include "CheckPeriods.h"

#include "Base/Vector3.h"
#include "Elements/TetQuality.h"
#include "Geometry/JoinCopies.h"
#include "Geometry/LeaveCovering.h"
#include "GluedChecks.h"
#include "Phases/MeshOfCells.h"

#include <cmath>
#include <set>

namespace vfm
{
namespace testing
{
namespace
{

// Tolerance of flat sides, relative to the period, or to coordinates far from the origin.
constexpr double PlaneTolerance = 2e-14, Rounding = 1e-15;

/// Checks that no point is beyond flat sides.
std::string FindPlaneProblem(const CartesianGrid& grid, const Mesh& mesh)
{
  for (std::size_t at = 0; at < mesh.Points.size(); ++at)
  {
    const int a = static_cast<int>(at % 3);
    const std::vector<double>& x = grid.Coordinates(a);
    const double below = x[grid.Domain().Lower[a]] - mesh.Points[at];
    const double above = mesh.Points[at] - x[grid.Domain().Upper[a]];
    const double tolerance =
      PlaneTolerance * grid.PeriodLength(a) + Rounding * std::fabs(mesh.Points[at]);
    if (grid.Period(a) > 0 && std::max(below, above) > tolerance)
    {
      return "beyond a flat side by " +
        std::to_string(std::max(below, above) / grid.PeriodLength(a)) + " periods, id " +
        std::to_string(mesh.PointIds[at / 3]);
    }
  }
  return "";
}

/// Returns whether two points differ by -1, 0 or 1 periods along each axis, bitwise.
bool AreTranslates(const CartesianGrid& grid, const Vector3& p, const Vector3& q)
{
  bool are = true;
  for (int a = 0; a < 3; ++a)
  {
    const double lower = std::min(p[a], q[a]), upper = std::max(p[a], q[a]);
    are = are && (lower == upper || (grid.Period(a) > 0 && lower + grid.PeriodLength(a) == upper));
  }
  return are;
}

/// Checks the partners of all points of a mesh of one rank.
std::string FindPartnerProblem(const CartesianGrid& grid, const Mesh& mesh)
{
  std::map<Index, Index> places;
  for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
  {
    places[mesh.PointIds[p]] = static_cast<Index>(p);
  }
  const std::set<Index> partners(mesh.PeriodicPartner.begin(), mesh.PeriodicPartner.end());
  for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
  {
    const auto at = places.find(mesh.PeriodicPartner[p]);
    if (at == places.end() || at->first > mesh.PointIds[p] ||
      mesh.PeriodicPartner[at->second] != at->first ||
      !AreTranslates(grid, mesh.PointAt(static_cast<Index>(p)), mesh.PointAt(at->second)))
    {
      return "wrong partner of point " + std::to_string(mesh.PointIds[p]);
    }
  }
  const std::size_t families = Glue(grid, mesh).PointIds.size();
  return partners.size() == families ? ""
                                     : std::to_string(partners.size()) +
      " families of points instead of " + std::to_string(families);
}

using Face = std::array<Index, 3>;

Face FaceOf(const Mesh& mesh, Index tet, int side)
{
  Face face;
  for (int c = 0; c < 3; ++c)
  {
    face[c] = mesh.Elements[4 * tet + FaceOfTet[side][c]];
  }
  std::sort(face.begin(), face.end());
  return face;
}

/// Checks that each face of one tet has one copy, if all cells have tets and all axes are periodic.
/// TetGen's tets may reach from one side to the other: then different faces of the glued mesh have
/// the same points.
std::string FindCopyProblem(const CartesianGrid& grid, const Mesh& mesh)
{
  const Mesh glued = Glue(grid, mesh);
  std::map<Face, std::vector<Face>> faces; // for each face its copies in the glued mesh
  for (Index tet = 0; tet < static_cast<Index>(mesh.ElementIds.size()); ++tet)
  {
    for (int side = 0; side < 4; ++side)
    {
      faces[FaceOf(mesh, tet, side)].push_back(FaceOf(glued, tet, side));
    }
  }
  std::map<Face, int> copies;
  for (const auto& face : faces)
  {
    copies[face.second[0]] += face.second.size() == 1;
  }
  const bool areMatched = std::all_of(copies.begin(), copies.end(),
    [](const auto& copy) { return copy.second == 0 || copy.second == 2; });
  return areMatched ? "" : "faces of sides without a copy";
}

/// Checks that each point of joined sides exists once.
std::string FindJoinedProblem(const Mesh& mesh)
{
  const bool isSorted = std::is_sorted(mesh.PointIds.begin(), mesh.PointIds.end());
  const bool isOnGrid = mesh.PointIds.empty() || mesh.PointIds[0] > 0;
  return isSorted && isOnGrid && mesh.PeriodicPartner.empty() ? "" : "points of joined sides";
}

void Leave(const CartesianGrid& grid, Sides sides, Runtime& runtime, Mesh& mesh)
{
  const bool joins = sides == Sides::Joined;
  LeaveCovering(Partition(grid, runtime.Group()), joins ? Partner::Upper : Partner::Lowest, mesh);
  if (joins)
  {
    JoinCopies(runtime, mesh);
  }
}

template <auto Make, Sides Kind>
Mesh MakeTorus(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, Runtime& runtime, MeshReport& report)
{
  Mesh mesh = Make(grid, fractions, options, runtime, report);
  Leave(grid, Kind, runtime, mesh);
  return mesh;
}

} // namespace

std::string FindTorusProblem(const FuzzCase& c, const Mesh& mesh, const MeshReport& report)
{
  if (c.Make == MakeHexMesh || c.Options.Method != TetMethod::TetGen)
  {
    return FindGluedProblem(c.Grid, mesh, c.Options.MeshVoid, report.NumberOfFragments);
  }
  const bool isTorus = c.Grid.Period(0) > 0 && c.Grid.Period(1) > 0 && c.Grid.Period(2) > 0;
  return isTorus && c.Options.MeshVoid && c.PeriodicSides != Sides::Joined
    ? FindCopyProblem(c.Grid, mesh)
    : "";
}

std::string FindSideProblem(const FuzzCase& c, const Mesh& mesh)
{
  return (c.PeriodicSides == Sides::Flat ? FindPlaneProblem(c.Grid, mesh) : std::string()) +
    FindConformityProblem(mesh);
}

std::string LeaveTorus(const FuzzCase& c, Mesh& mesh)
{
  Runtime alone;
  Leave(c.Grid, c.PeriodicSides, alone, mesh);
  return c.PeriodicSides == Sides::Joined ? FindJoinedProblem(mesh)
                                          : FindPartnerProblem(c.Grid, mesh);
}

MeshMaker MakerOfTorus(const FuzzCase& c)
{
  const bool isHex = c.Make == MakeHexMesh;
  return c.PeriodicSides != Sides::Joined
    ? (isHex ? MakeTorus<MakeHexMesh, Sides::Flat> : MakeTorus<MakeTetMesh, Sides::Flat>)
    : (isHex ? MakeTorus<MakeHexMesh, Sides::Joined> : MakeTorus<MakeTetMesh, Sides::Joined>);
}

} // namespace testing
} // namespace vfm
