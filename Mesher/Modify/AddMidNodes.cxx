#include "Modify/AddMidNodes.h"

#include "Curved/EdgePulls.h"
#include "Modify/StraightenEdges.h"
#include "Ranks/AskByKey.h"
#include "Ranks/NumberInOrder.h"
#include "State/StateArrays.h"

namespace vfm
{
namespace
{

/// Returns the buffer with place for more values.
template <class T>
Buffer<T> Grown(const Buffer<T>& values, std::size_t size)
{
  Buffer<T> grown(size);
  std::copy(values.begin(), values.end(), grown.begin());
  return grown;
}

/// An edge or face of an element, by the ids of its corners.
template <class Key>
struct KeyUse
{
  Key Ids;
  Index Place; ///< in MidPoints
  bool operator<(const KeyUse& other) const { return this->Ids < other.Ids; }
};

/// Returns the distinct keys, ascending. Sets the points of the mid nodes from `first` on.
template <class Key>
std::vector<Key> NumberKeys(std::vector<KeyUse<Key>> uses, Index first, Buffer<Index>& midPoints)
{
  std::sort(uses.begin(), uses.end());
  std::vector<Key> keys;
  for (const KeyUse<Key>& use : uses)
  {
    if (keys.empty() || keys.back() != use.Ids)
    {
      keys.push_back(use.Ids);
    }
    midPoints[use.Place] = first + static_cast<Index>(keys.size()) - 1;
  }
  return keys;
}

/// Dimension and id of the surface or curve that has an edge or a face.
template <class Ids>
struct OnGeometry
{
  Ids Corners;
  int Dimension, Id;
  const Ids& Key() const { return this->Corners; }
  bool operator<(const OnGeometry& other) const
  {
    return std::tie(this->Corners, this->Dimension, this->Id) <
      std::tie(other.Corners, other.Dimension, other.Id);
  }
};

using Place = std::array<int, 2>; // dimension and id

class MidNodeBuilder
{
public:
  MidNodeBuilder(ElementOrder order, Runtime& runtime, Mesh& mesh) :
    TheMesh(mesh),
    Run(runtime),
    Mids(mesh.Corners, MidNodes::CountOf(order, mesh.Corners)),
    Corners(static_cast<Index>(mesh.PointIds.size())),
    Elements(static_cast<Index>(mesh.ElementIds.size()))
  {
  }

  CurvedReport Build()
  {
    this->ListNodes();
    this->AppendPoints();
    this->PlaceEdges();
    const CurvedReport report = this->CurveEdges();
    this->PlaceOthers();
    this->FillGeometry();
    return report;
  }

  /// Calls visit(mid point, corners, number of corners) for each mid node, some more than once.
  template <class Visit>
  void ForCorners(const Visit& visit) const
  {
    const ElementFaces faces(this->TheMesh.Corners);
    for (Index element = 0; element < this->Elements; ++element)
    {
      const Index* corners = this->CornersOf(element);
      const Index* mids = this->MidsOf(element);
      for (int e = 0; e < this->Mids.Edges; ++e)
      {
        const int(&ends)[2] = this->Mids.EdgeCorners[e];
        const Index points[2] = { corners[ends[0]], corners[ends[1]] };
        visit(mids[e], points, 2);
      }
      for (int f = 0; this->Mids.HasFaces() && f < faces.Count; ++f)
      {
        visit(mids[this->Mids.Edges + f], faces.PointsOf(corners, f).data(), 4);
      }
      if (this->Mids.HasFaces())
      {
        visit(mids[this->Mids.Count - 1], corners, 8);
      }
    }
  }

private:
  const Index* CornersOf(Index element) const
  {
    return this->TheMesh.Elements.data() + this->TheMesh.Corners * element;
  }
  const Index* MidsOf(Index element) const
  {
    return this->TheMesh.MidPoints.data() + this->Mids.Count * element;
  }
  EdgeIds EdgeOf(Index a, Index b) const
  {
    return MakeEdgeIds(this->TheMesh.PointIds[a], this->TheMesh.PointIds[b]);
  }
  FaceIds FaceOf(const std::array<Index, 4>& points) const
  {
    FaceIds ids;
    std::transform(points.begin(), points.end(), ids.begin(),
      [this](Index point) { return this->TheMesh.PointIds[point]; });
    std::sort(ids.begin(), ids.end());
    return ids;
  }

  void ListNodes();
  void AppendPoints();
  void PlaceEdges();
  CurvedReport CurveEdges();
  void PlaceOthers();
  void FillGeometry();
  Vector3 CornersSum(const Index* sorted, int count) const;

  Mesh& TheMesh;
  Runtime& Run;
  const MidNodes Mids;
  const Index Corners, Elements; // numbers of corner points and of elements
  std::vector<EdgeIds> Edges;    // ascending; the points of their mid nodes follow the corners
  std::vector<FaceIds> Faces;    // ascending; their points follow those of edges
};

void MidNodeBuilder::ListNodes()
{
  Mesh& mesh = this->TheMesh;
  const ElementFaces faces(mesh.Corners);
  mesh.MidsPerElement = this->Mids.Count;
  mesh.MidPoints = Buffer<Index>(this->Mids.Count * this->Elements);
  std::vector<KeyUse<EdgeIds>> edgeUses;
  std::vector<KeyUse<FaceIds>> faceUses;
  edgeUses.reserve(this->Mids.Edges * this->Elements);
  for (Index element = 0; element < this->Elements; ++element)
  {
    const Index* corners = this->CornersOf(element);
    const Index place = this->Mids.Count * element;
    for (int e = 0; e < this->Mids.Edges; ++e)
    {
      const int(&ends)[2] = this->Mids.EdgeCorners[e];
      edgeUses.push_back({ this->EdgeOf(corners[ends[0]], corners[ends[1]]), place + e });
    }
    for (int f = 0; this->Mids.HasFaces() && f < faces.Count; ++f)
    {
      faceUses.push_back(
        { this->FaceOf(faces.PointsOf(corners, f)), place + this->Mids.Edges + f });
    }
  }
  this->Edges = NumberKeys(std::move(edgeUses), this->Corners, mesh.MidPoints);
  const Index firstFace = this->Corners + static_cast<Index>(this->Edges.size());
  this->Faces = NumberKeys(std::move(faceUses), firstFace, mesh.MidPoints);
  const Index firstCentre = firstFace + static_cast<Index>(this->Faces.size());
  for (Index element = 0; this->Mids.HasFaces() && element < this->Elements; ++element)
  {
    mesh.MidPoints[this->Mids.Count * (element + 1) - 1] = firstCentre + element;
  }
}

/// Appends the ids, and makes place for the other data of points.
void MidNodeBuilder::AppendPoints()
{
  Mesh& mesh = this->TheMesh;
  Ranks& ranks = this->Run.Group();
  const Index centres = this->Mids.HasFaces() ? this->Elements : 0;
  const Index points =
    this->Corners + static_cast<Index>(this->Edges.size() + this->Faces.size()) + centres;
  CheckNumberOfPoints(points, ranks);
  Index next = this->Corners, greatest = 0;
  for (Index id : mesh.PointIds)
  {
    greatest = std::max(greatest, id);
  }
  greatest = MaximumOverRanks(greatest, ranks);
  mesh.PointIds = Grown(mesh.PointIds, points);
  const auto append = [&](const auto& keys)
  {
    const std::vector<std::int64_t> numbers = NumberInOrder(keys, ranks);
    for (std::int64_t number : numbers)
    {
      mesh.PointIds[next++] = greatest + 1 + number;
    }
    greatest = MaximumOverRanks(numbers.empty() ? greatest : mesh.PointIds[next - 1], ranks);
  };
  append(this->Edges);
  if (this->Mids.HasFaces())
  {
    append(this->Faces);
    append(std::vector<Index>(mesh.ElementIds.begin(), mesh.ElementIds.end()));
  }
  mesh.Points = Grown(mesh.Points, 3 * points);
  mesh.GeometryDimension = Grown(mesh.GeometryDimension, points);
  mesh.GeometryId = Grown(mesh.GeometryId, points);
}

/// Places the mid nodes of edges in their middles.
void MidNodeBuilder::PlaceEdges()
{
  Mesh& mesh = this->TheMesh;
  this->ForCorners(
    [&](Index mid, const Index* ends, int count)
    {
      if (count == 2)
      {
        const Vector3 x = 0.5 * (mesh.PointAt(ends[0]) + mesh.PointAt(ends[1]));
        std::copy(x.begin(), x.end(), mesh.Points.data() + 3 * mid);
      }
    });
}

/// Collective. Moves the mid nodes of interface edges onto the interface.
CurvedReport MidNodeBuilder::CurveEdges()
{
  Mesh& mesh = this->TheMesh;
  Ranks& ranks = this->Run.Group();
  CurvedEdges curved;
  curved.OfMidPoint.assign(this->Edges.size(), -1);
  std::vector<Index> onSurface;
  std::vector<EdgeIds> questions;
  for (Index element = 0; element < this->Elements; ++element)
  {
    for (int e = 0; e < this->Mids.Edges; ++e)
    {
      const int(&ends)[2] = this->Mids.EdgeCorners[e];
      const Index* corners = this->CornersOf(element);
      const Index edge = this->MidsOf(element)[e] - this->Corners;
      if (curved.OfMidPoint[edge] == -1 &&
        mesh.GeometryDimension[corners[ends[0]]] < DimensionOfVolumes &&
        mesh.GeometryDimension[corners[ends[1]]] < DimensionOfVolumes)
      {
        curved.OfMidPoint[edge] = -2; // asked
        onSurface.push_back(edge);
        questions.push_back(this->Edges[edge]);
      }
    }
  }
  const std::vector<Vector3> moves = CombinePulls(mesh.Pulls, questions, ranks);
  std::vector<EdgePull>().swap(mesh.Pulls);
  for (std::size_t i = 0; i < moves.size(); ++i)
  {
    const bool isCurved = Norm(moves[i]) > 0.0;
    curved.OfMidPoint[onSurface[i]] = isCurved ? static_cast<Index>(curved.Keys.size()) : -1;
    if (isCurved)
    {
      curved.Keys.push_back(questions[i]);
      curved.Moves.push_back(moves[i]);
    }
  }
  const CurvedReport report = StraightenEdges(mesh, this->Corners, this->Run, curved);
  for (std::size_t edge = 0; edge < curved.OfMidPoint.size(); ++edge)
  {
    for (int a = 0; curved.OfMidPoint[edge] >= 0 && a < 3; ++a)
    {
      mesh.Points[3 * (this->Corners + edge) + a] += curved.Moves[curved.OfMidPoint[edge]][a];
    }
  }
  return report;
}

/// Returns the sum of some points in the order of their ids, with pairs of equal coordinates added
/// exactly.
Vector3 MidNodeBuilder::CornersSum(const Index* points, int count) const
{
  std::array<Index, 12> sorted;
  std::copy_n(points, count, sorted.begin());
  std::sort(sorted.begin(), sorted.begin() + count,
    [this](Index a, Index b) { return this->TheMesh.PointIds[a] < this->TheMesh.PointIds[b]; });
  Vector3 sum{ { 0.0, 0.0, 0.0 } };
  for (int i = 0; i < count; i += 2)
  {
    sum = sum + (this->TheMesh.PointAt(sorted[i]) + this->TheMesh.PointAt(sorted[i + 1]));
  }
  return sum;
}

/// Places the mid nodes of faces and elements from corners and edges.
void MidNodeBuilder::PlaceOthers()
{
  Mesh& mesh = this->TheMesh;
  const auto place = [&](Index mid, const Vector3& x)
  { std::copy(x.begin(), x.end(), mesh.Points.data() + 3 * mid); };
  const ElementFaces faces(mesh.Corners);
  ForEach(this->Run, this->Mids.HasFaces() ? this->Elements : 0,
    [&](Index element)
    {
      const Index* corners = this->CornersOf(element);
      const Index* mids = this->MidsOf(element);
      place(mids[this->Mids.Count - 1],
        0.25 * (this->CornersSum(mids, 12) - this->CornersSum(corners, 8)));
    });
  std::vector<unsigned char> isPlaced(this->Faces.size(), 0);
  const Index firstFace = this->Corners + static_cast<Index>(this->Edges.size());
  for (Index element = 0; this->Mids.HasFaces() && element < this->Elements; ++element)
  {
    const Index* mids = this->MidsOf(element);
    for (int f = 0; f < faces.Count; ++f)
    {
      const Index mid = mids[this->Mids.Edges + f];
      if (isPlaced[mid - firstFace])
      {
        continue;
      }
      isPlaced[mid - firstFace] = 1;
      Index edges[4];
      for (int c = 0; c < 4; ++c)
      {
        edges[c] = mids[this->Mids.EdgeOfFace(f, c)];
      }
      const std::array<Index, 4> corners = faces.PointsOf(this->CornersOf(element), f);
      place(mid, 0.5 * this->CornersSum(edges, 4) - 0.25 * this->CornersSum(corners.data(), 4));
    }
  }
}

/// Collective. Fills the geometry of mid nodes.
void MidNodeBuilder::FillGeometry()
{
  Mesh& mesh = this->TheMesh;
  std::vector<OnGeometry<EdgeIds>> edges;
  std::vector<OnGeometry<FaceIds>> faces;
  const SurfaceFacets& surfaces = mesh.Surfaces;
  const int corners = mesh.CornersOfFacet();
  for (std::size_t f = 0; f < surfaces.SurfaceId.size(); ++f)
  {
    const Index* points = surfaces.Points.data() + corners * f;
    for (int c = 0; c < corners; ++c)
    {
      edges.push_back({ this->EdgeOf(points[c], points[(c + 1) % corners]), DimensionOfSurfaces,
        surfaces.SurfaceId[f] });
    }
    if (this->Mids.HasFaces())
    {
      faces.push_back({ this->FaceOf({ { points[0], points[1], points[2], points[3] } }),
        DimensionOfSurfaces, surfaces.SurfaceId[f] });
    }
  }
  for (std::size_t e = 0; e < mesh.Curves.CurveId.size(); ++e)
  {
    const Index* ends = mesh.Curves.Points.data() + 2 * e;
    edges.push_back(
      { this->EdgeOf(ends[0], ends[1]), DimensionOfSurfaces - 1, mesh.Curves.CurveId[e] });
  }
  const auto combine = [](auto first, auto last) {
    return first < last ? Place{ { first->Dimension, first->Id } } : Place{ { 3, 0 } };
  };
  std::vector<Place> places = AskByKey(edges, this->Edges, combine, this->Run.Group());
  const std::vector<Place> ofFaces = AskByKey(faces, this->Faces, combine, this->Run.Group());
  places.insert(places.end(), ofFaces.begin(), ofFaces.end());
  places.resize(mesh.PointIds.size() - this->Corners, Place{ { DimensionOfVolumes, 0 } });
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    mesh.GeometryDimension[this->Corners + i] = places[i][0];
    mesh.GeometryId[this->Corners + i] = places[i][1];
  }
  for (std::size_t at = 0; at < mesh.MidPoints.size(); ++at)
  {
    const Index point = mesh.MidPoints[at];
    if (mesh.GeometryDimension[point] == DimensionOfVolumes)
    {
      mesh.GeometryId[point] = mesh.Fragment[at / this->Mids.Count];
    }
  }
}

/// Appends the values of mid nodes to an array of points: means over their corners, in the order of
/// ids.
template <class Value>
void AppendMeans(const MidNodeBuilder& builder, const Mesh& mesh, TransferredArray& array)
{
  const int width = array.Components;
  Buffer<Value> values(width * mesh.PointIds.size());
  std::copy_n(array.Values.data(), array.Values.size(), reinterpret_cast<char*>(values.data()));
  builder.ForCorners(
    [&](Index mid, const Index* corners, int count)
    {
      std::array<Index, 8> sorted;
      std::copy_n(corners, count, sorted.begin());
      std::sort(sorted.begin(), sorted.begin() + count,
        [&mesh](Index a, Index b) { return mesh.PointIds[a] < mesh.PointIds[b]; });
      for (int c = 0; c < width; ++c)
      {
        double sum = 0.0;
        for (int i = 0; i < count; ++i)
        {
          sum += static_cast<double>(values[width * sorted[i] + c]);
        }
        values[width * mid + c] = static_cast<Value>(sum / count);
      }
    });
  array.Values = TakeBytes(values);
}

} // namespace

FieldArrays AddMidNodes(ElementOrder order, Runtime& runtime, Mesh& mesh, OutputState& state)
{
  MidNodeBuilder builder(order, runtime, mesh);
  const CurvedReport report = builder.Build();
  if (state.NodalVelocity)
  {
    TransferredArray& velocity = *state.NodalVelocity;
    VisitType(CarrierType(velocity.Type),
      [&](auto tag) { AppendMeans<typename decltype(tag)::Type>(builder, mesh, velocity); });
  }
  return { { "CurvedMidNodes", std::vector<Index>{ report.Curved } },
    { "StraightenedMidNodes", std::vector<Index>{ report.Straightened } },
    { "CurvedJacobian", std::vector<double>{ report.SmallestRatio } } };
}

} // namespace vfm
