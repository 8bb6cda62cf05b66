#include "Modify/SplitInterfaces.h"

#include "Base/Sorted.h"
#include "Elements/SelectPoints.h"
#include "Modify/GreatestId.h"
#include "Modify/NodeCopies.h"
#include "Report/Sets/MaterialsBehind.h"
#include "State/ViewMesh.h"

namespace vfm
{
namespace
{

using Pair = std::array<int, 2>;

/// A point of the split mesh.
struct NewPoint
{
  Index Id, Partner;
  Index Source; // point of the mesh before

  bool operator<(const NewPoint& other) const { return this->Id < other.Id; }
  bool operator==(const NewPoint& other) const { return this->Id == other.Id; }
};

/// The facets to cut, and their pairs of materials.
struct CutFacets
{
  std::vector<char> IsCut; // of each facet
  std::vector<Pair> Pairs; // of all ranks
};

CutFacets ChooseFacets(const MeshData& mesh, const MaterialPairs& pairs, Ranks& ranks)
{
  const std::vector<Index> behind = FindMaterialsBehind(mesh, ranks);
  CutFacets cut;
  for (std::size_t f = 0; f < behind.size(); ++f)
  {
    const int own = mesh.Material[(*mesh.Facets)[f].Element], other = static_cast<int>(behind[f]);
    const bool isCut = other != NothingBehind && pairs.Contains(own, other);
    cut.IsCut.push_back(isCut ? 1 : 0);
    if (isCut)
    {
      cut.Pairs.push_back({ { std::min(own, other), std::max(own, other) } });
    }
  }
  cut.Pairs = UnionOverRanks(ranks, std::move(cut.Pairs));
  return cut;
}

/// Replaces the points of the mesh, and renumbers their users. A user of a point that has several
/// copies gets the copy with the id of the point, or else the first.
/// @param points ascending by id
void ReplacePoints(
  const std::vector<NewPoint>& points, Runtime& runtime, Mesh& mesh, OutputState& state)
{
  std::vector<Index> sources, numbers(mesh.PointIds.size(), -1);
  for (const NewPoint& point : points)
  {
    Index& number = numbers[point.Source];
    const bool isFirst = number < 0 || point.Id == mesh.PointIds[point.Source];
    number = isFirst ? static_cast<Index>(sources.size()) : number;
    sources.push_back(point.Source);
  }
  mesh.OriginalPointIds = Select(mesh.UnsplitPointIds(), sources, runtime);
  if (!mesh.PeriodicPartner.empty())
  {
    const bool isFirst = mesh.OriginalPartner.empty();
    mesh.OriginalPartner =
      Select(isFirst ? mesh.PeriodicPartner : mesh.OriginalPartner, sources, runtime);
  }
  SelectPoints(sources, numbers, runtime, mesh);
  SortGeometry(mesh);
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    mesh.PointIds[p] = points[p].Id;
  }
  if (!mesh.PeriodicPartner.empty())
  {
    mesh.PeriodicPartner = Buffer<Index>(points.size());
    std::transform(points.begin(), points.end(), mesh.PeriodicPartner.begin(),
      [](const NewPoint& point) { return point.Partner; });
  }
  if (state.NodalVelocity)
  {
    TransferredArray& velocity = *state.NodalVelocity;
    const Index size = static_cast<Index>(velocity.Values.size() / numbers.size());
    velocity.Values = Select(velocity.Values, sources, runtime, size);
  }
}

/// Returns a point of the mesh as it is.
NewPoint PointOf(const Mesh& mesh, Index point)
{
  const Index id = mesh.PointIds[point];
  return { id, mesh.PeriodicPartner.empty() ? id : mesh.PeriodicPartner[point], point };
}

Index PlaceOf(const std::vector<NewPoint>& points, Index id)
{
  return FindSorted(points, NewPoint{ id, 0, 0 });
}

/// Gives the corners of elements their copies of nodes.
void UseCopies(
  const std::vector<CornerCopy>& copies, Runtime& runtime, Mesh& mesh, OutputState& state)
{
  std::vector<char> isReplaced(mesh.PointIds.size(), 0);
  std::vector<NewPoint> points;
  for (const CornerCopy& copy : copies)
  {
    isReplaced[mesh.Elements[copy.Corner]] = 1;
    points.push_back({ copy.Id, copy.Partner, mesh.Elements[copy.Corner] });
  }
  for (std::size_t p = 0; p < isReplaced.size(); ++p)
  {
    if (isReplaced[p] == 0)
    {
      points.push_back(PointOf(mesh, static_cast<Index>(p)));
    }
  }
  SortUnique(points);
  ReplacePoints(points, runtime, mesh, state);
  for (const CornerCopy& copy : copies)
  {
    mesh.Elements[copy.Corner] = PlaceOf(points, copy.Id);
  }
}

/// Adds the nodes of the second sides of faces whose first element is on this rank.
void AddSecondSides(
  const std::vector<FieldArray>& fields, Runtime& runtime, Mesh& mesh, OutputState& state)
{
  const std::vector<SplitFace> faces =
    FindSplitFaces(ViewMesh(mesh, state, fields), runtime.Group());
  std::vector<NewPoint> points;
  for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
  {
    points.push_back(PointOf(mesh, static_cast<Index>(p)));
  }
  const std::vector<NewPoint> own = points;
  for (const SplitFace& face : faces)
  {
    for (std::size_t p = 0; p < face.Points[0].size(); ++p)
    {
      const Index id = face.Points[1][p];
      if (id >= 0 && PlaceOf(own, id) < 0)
      {
        points.push_back({ id, face.Partners[p], PlaceOf(own, face.Points[0][p]) });
      }
    }
  }
  SortUnique(points);
  ReplacePoints(points, runtime, mesh, state);
}

} // namespace

void SplitInterfaces(const MaterialPairs& pairs, ConnectionKind connection, Runtime& runtime,
  std::vector<FieldArray>& fields, Mesh& mesh, OutputState& state)
{
  Ranks& ranks = runtime.Group();
  const MeshData before = ViewMesh(mesh, state, fields);
  const CutFacets cut = ChooseFacets(before, pairs, ranks);
  const Index largest = FindGreatestId(mesh.PointIds, ranks);
  UseCopies(FindNodeCopies(before, cut.IsCut, ranks), runtime, mesh, state);
  fields.push_back({ SplitConnectionField, std::vector<int>{ static_cast<int>(connection) } });
  fields.push_back(FieldOfRows("SplitPairs", cut.Pairs));
  fields.push_back(
    { "AddedNodes", std::vector<Index>{ FindGreatestId(mesh.PointIds, ranks) - largest } });
  if (connection == ConnectionKind::Cohesive)
  {
    AddSecondSides(fields, runtime, mesh, state);
  }
}

std::vector<CohesiveBlock> SplitMesh(const MaterialPairs& pairs, const MesherOptions& options,
  const std::function<void(const std::string&)>& warn, Runtime& runtime,
  std::vector<FieldArray>& fields, Mesh& mesh, OutputState& state)
{
  SplitInterfaces(pairs, options.SplitConnection, runtime, fields, mesh, state);
  const bool isSplit = !std::get<std::vector<int>>(FindField(fields, "SplitPairs")->Values).empty();
  if (!isSplit && warn && runtime.Group().Rank() == 0)
  {
    warn("SplitInterfaces is " + options.SplitInterfaces +
      ", but no such materials have a common face.");
  }
  return FindCohesiveBlocks(ViewMesh(mesh, state, fields), runtime.Group());
}

} // namespace vfm
