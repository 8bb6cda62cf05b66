#include "Meshes/Gmsh/GmshPeriodic.h"

#include "Meshes/Files/ElementNodes.h"
#include "Report/DomainSides.h"
#include "Report/Sets/PeriodicPairs.h"

#include <map>
#include <set>

namespace vfm
{
namespace
{

/// Finds the copies of points.
class PointCopies
{
public:
  explicit PointCopies(const MeshData& mesh) : Places(mesh.NumberOfPoints)
  {
    for (Index point = 0; point < mesh.NumberOfPoints; ++point)
    {
      this->Places[point] = { point, { { 0, 0, 0 } } };
    }
    for (const PeriodicPair& pair : FindPeriodicPairs(mesh))
    {
      this->Places[pair.Point] = { pair.Partner, pair.Periods };
      this->Points[this->Places[pair.Point]] = pair.Point;
      this->Points[this->Places[pair.Partner]] = pair.Partner;
    }
  }

  bool IsEmpty() const { return this->Points.empty(); }

  /// Returns the copy one period lower along an axis, or -1.
  Index Lower(Index point, int axis) const
  {
    Place place = this->Places[point];
    --place.second[axis];
    const auto found = this->Points.find(place);
    return found == this->Points.end() ? -1 : found->second;
  }

private:
  using Place = std::pair<Index, Index3>; // a partner, and the periods from it

  std::vector<Place> Places;     // of points
  std::map<Place, Index> Points; // in pairs
};

/// Returns the points of a face, sorted, with -1 in place of a fourth point of triangles.
template <class Function>
FaceIds SortedPoints(const FaceIds& points, const Function& function)
{
  FaceIds found;
  std::transform(points.begin(), points.end(), found.begin(),
    [&function](Index point) { return point < 0 ? -1 : function(point); });
  std::sort(found.begin(), found.end());
  return found;
}

/// Returns the surface of each face on a lower side of the domain.
std::map<FaceIds, int> FindLowerFaces(const GmshModel& model)
{
  std::map<FaceIds, int> surfaces;
  const std::vector<SurfaceEntity>& entities = model.Entities.Surfaces;
  for (std::size_t s = 0; s < entities.size(); ++s)
  {
    if (entities[s].DomainSide == NoSide || entities[s].DomainSide % 2 != 0)
    {
      continue;
    }
    for (const ElementSide& side : entities[s].Sides)
    {
      const FaceIds points = PointsOfSide(model.Mesh, side);
      surfaces[SortedPoints(points, [](Index point) { return point; })] = static_cast<int>(s) + 1;
    }
  }
  return surfaces;
}

/// Returns the rows of the matrix that moves the master to the copy.
std::array<double, 16> TranslationOf(const MeshData& mesh, int axis)
{
  const double length = NumbersOfField(mesh.Fields, "PeriodLengths")[axis];
  const ImageFrame frame = FrameOfDomain(mesh);
  std::array<double, 16> rows{};
  for (int a = 0; a < 4; ++a)
  {
    rows[5 * a] = 1.0;
  }
  for (int a = 0; a < 3; ++a)
  {
    rows[4 * a + 3] = length * frame.Axes[3 * a + axis];
  }
  return rows;
}

} // namespace

std::vector<GmshLink> FindGmshLinks(const GmshModel& model)
{
  const PointCopies copies(model.Mesh);
  if (copies.IsEmpty())
  {
    return {};
  }
  const std::map<FaceIds, int> lowerFaces = FindLowerFaces(model);
  const std::vector<SurfaceEntity>& entities = model.Entities.Surfaces;
  std::vector<GmshLink> links;
  for (std::size_t s = 0; s < entities.size(); ++s)
  {
    if (entities[s].DomainSide == NoSide || entities[s].DomainSide % 2 == 0)
    {
      continue;
    }
    const int axis = entities[s].DomainSide / 2;
    std::map<int, std::set<std::array<Index, 2>>> nodes; // by master
    for (const ElementSide& side : entities[s].Sides)
    {
      const FaceIds points = PointsOfSide(model.Mesh, side);
      const auto lower = lowerFaces.find(
        SortedPoints(points, [&](Index point) { return copies.Lower(point, axis); }));
      if (lower == lowerFaces.end())
      {
        continue;
      }
      for (Index point : NodesOfSide(model.Mesh, side.Element, side.Side))
      {
        nodes[lower->second].insert({ { point, copies.Lower(point, axis) } });
      }
    }
    for (const auto& [master, pairs] : nodes)
    {
      links.push_back({ static_cast<int>(s) + 1, master, axis, { pairs.begin(), pairs.end() } });
    }
  }
  return links;
}

void WriteLinks(GmshFile& file, const MeshData& mesh, const std::vector<GmshLink>& links)
{
  if (links.empty())
  {
    return;
  }
  file.Begin("Periodic");
  file.Size(static_cast<Index>(links.size()));
  file.EndLine();
  for (const GmshLink& link : links)
  {
    file.Int(DimensionOfElements(mesh) - 1);
    file.Int(link.Copy);
    file.Int(link.Master);
    file.EndLine();
    const std::array<double, 16> rows = TranslationOf(mesh, link.Axis);
    file.Size(static_cast<Index>(rows.size()));
    for (double number : rows)
    {
      file.Real(number);
    }
    file.EndLine();
    file.Size(static_cast<Index>(link.Nodes.size()));
    file.EndLine();
    for (const std::array<Index, 2>& pair : link.Nodes)
    {
      file.Size(mesh.PointIds[pair[0]]);
      file.Size(mesh.PointIds[pair[1]]);
      file.EndLine();
    }
  }
  file.End("Periodic");
}

} // namespace vfm
