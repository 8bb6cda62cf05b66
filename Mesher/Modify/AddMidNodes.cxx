#include "Modify/AddMidNodes.h"

#include "Modify/GreatestId.h"
#include "Modify/StraightenEdges.h"
#include "Ranks/MergeByKey.h"
#include "Ranks/NumberKeys.h"
#include "Report/MatchFaces.h"
#include "Smoothing/EdgePulls.h"
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

/// The distinct edges or faces of the elements, ascending.
template <class Key>
struct DistinctKeys
{
  std::vector<Key> Ids;
  std::vector<Index> Places; ///< a place of each in MidPoints
};

/// Returns the distinct keys. Sets the points of the mid nodes from `first` on.
template <class Key>
DistinctKeys<Key> ListKeys(std::vector<KeyUse<Key>> uses, Index first, Buffer<Index>& midPoints)
{
  std::sort(uses.begin(), uses.end());
  DistinctKeys<Key> keys;
  for (const KeyUse<Key>& use : uses)
  {
    if (keys.Ids.empty() || keys.Ids.back() != use.Ids)
    {
      keys.Ids.push_back(use.Ids);
      keys.Places.push_back(use.Place);
    }
    midPoints[use.Place] = first + static_cast<Index>(keys.Ids.size()) - 1;
  }
  return keys;
}

using Place = std::array<int, 2>; // dimension and id of a surface or curve

/// Edges or faces on surfaces and curves, with their places.
template <class Key>
struct PlacedKeys
{
  std::vector<Key> Ids;
  std::vector<Place> Places;

  void Add(const Key& ids, int dimension, int id)
  {
    this->Ids.push_back(ids);
    this->Places.push_back({ { dimension, id } });
  }
};

/// Returns for each question the place of lowest dimension and id that any rank knows.
/// @pre Collective
template <class Key>
std::vector<Place> FindPlaces(
  const PlacedKeys<Key>& known, const std::vector<Key>& questions, Ranks& ranks)
{
  return AskByKey(
    known.Ids, known.Places, questions, Place{ { DimensionOfVolumes, 0 } },
    [](const Place& a, const Place& b) { return std::min(a, b); }, ranks);
}

/// Returns the lowest coordinates of copies along each axis.
Vector3 LowestOf(const Vector3& a, const Vector3& b)
{
  return { { std::min(a[0], b[0]), std::min(a[1], b[1]), std::min(a[2], b[2]) } };
}

class MidNodeBuilder
{
public:
  MidNodeBuilder(
    InterpolationOrder order, const FieldArrays& fields, Runtime& runtime, Mesh& mesh) :
    TheMesh(mesh),
    Run(runtime),
    HasCopies(runtime.Group().Any(!mesh.PeriodicPartner.empty())),
    IsSplit(runtime.Group().Any(!mesh.OriginalPointIds.empty())),
    Images(fields, HasCopies),
    Mids(mesh.Corners, MidNodes::CountOf(order, mesh.Corners)),
    Corners(static_cast<Index>(mesh.PointIds.size())),
    Elements(static_cast<Index>(mesh.ElementIds.size()))
  {
  }

  CurvedReport Build()
  {
    this->ListNodes();
    this->AppendPoints();
    this->SetOriginalIds();
    this->PlaceEdges();
    const CurvedReport report = this->CurveEdges();
    this->SetPartners(this->Corners, this->Edges);
    this->PlaceOthers();
    this->SetPartners(this->FirstFace(), this->Faces);
    this->TheMesh.OriginalPartner = Buffer<Index>();
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
  Index FirstFace() const { return this->Corners + static_cast<Index>(this->Edges.Ids.size()); }
  /// Returns the corners of the edge with a place in MidPoints.
  std::array<Index, 2> EndsAt(Index place) const
  {
    const Index* corners = this->CornersOf(place / this->Mids.Count);
    const int(&ends)[2] = this->Mids.EdgeCorners[place % this->Mids.Count];
    return { { corners[ends[0]], corners[ends[1]] } };
  }
  /// Returns the edge with other ids of points than Mesh::PointIds.
  static EdgeIds KeyOf(const Buffer<Index>& ids, const std::array<Index, 2>& ends)
  {
    return MakeEdgeIds(ids[ends[0]], ids[ends[1]]);
  }
  static FaceIds KeyOf(const Buffer<Index>& ids, const std::array<Index, 4>& points)
  {
    return SortedIds(points, ids.data());
  }
  /// Returns all edges or faces with other ids of points.
  std::vector<EdgeIds> KeysOf(const DistinctKeys<EdgeIds>& edges, const Buffer<Index>& ids) const
  {
    std::vector<EdgeIds> keys;
    keys.reserve(edges.Places.size());
    for (Index place : edges.Places)
    {
      keys.push_back(KeyOf(ids, this->EndsAt(place)));
    }
    return keys;
  }
  std::vector<FaceIds> KeysOf(const DistinctKeys<FaceIds>& faces, const Buffer<Index>& ids) const
  {
    const ElementFaces table(this->TheMesh.Corners);
    std::vector<FaceIds> keys;
    keys.reserve(faces.Places.size());
    for (Index place : faces.Places)
    {
      const Index* corners = this->CornersOf(place / this->Mids.Count);
      const int face = static_cast<int>(place % this->Mids.Count) - this->Mids.Edges;
      keys.push_back(KeyOf(ids, table.PointsOf(corners, face)));
    }
    return keys;
  }

  void ListNodes();
  void AppendPoints();
  void SetOriginalIds();
  void PlaceEdges();
  CurvedReport CurveEdges();
  std::vector<Index> ListCurvedEdges() const;
  void PlaceOthers();
  void FillGeometry();
  Vector3 SumOf(const Index* points, int count, const Vector3& near) const;
  Vector3 PlaceOfLowest(const Index* corners, int count) const;
  template <class Key>
  std::vector<Index> LowestIds(Index first, const std::vector<Key>& keys) const;
  template <class Key>
  void SetPartners(Index first, const DistinctKeys<Key>& keys);

  Mesh& TheMesh;
  Runtime& Run;
  const bool HasCopies, IsSplit; // copies on opposite sides; at split interfaces
  const PeriodImages Images;
  const MidNodes Mids;
  const Index Corners, Elements; // numbers of corner points and of elements
  DistinctKeys<EdgeIds> Edges;   // the points of their mid nodes follow the corners
  DistinctKeys<FaceIds> Faces;   // their points follow those of edges
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
      edgeUses.push_back({ KeyOf(mesh.PointIds, this->EndsAt(place + e)), place + e });
    }
    for (int f = 0; this->Mids.HasFaces() && f < faces.Count; ++f)
    {
      faceUses.push_back(
        { KeyOf(mesh.PointIds, faces.PointsOf(corners, f)), place + this->Mids.Edges + f });
    }
  }
  this->Edges = ListKeys(std::move(edgeUses), this->Corners, mesh.MidPoints);
  this->Faces = ListKeys(std::move(faceUses), this->FirstFace(), mesh.MidPoints);
  const Index firstCentre = this->FirstFace() + static_cast<Index>(this->Faces.Ids.size());
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
  const Index points = this->FirstFace() + static_cast<Index>(this->Faces.Ids.size()) + centres;
  CheckNumberOfPoints(points, ranks);
  Index next = this->Corners, greatest = FindGreatestId(mesh.PointIds, ranks);
  mesh.PointIds = Grown(mesh.PointIds, points);
  const auto append = [&](const auto& keys)
  {
    const KeyNumbers numbers = NumberItems(keys, FirstOfKey(), ranks);
    for (std::int64_t number : numbers.Numbers)
    {
      mesh.PointIds[next++] = greatest + 1 + number;
    }
    greatest += numbers.Total;
  };
  append(this->Edges.Ids);
  if (this->Mids.HasFaces())
  {
    append(this->Faces.Ids);
    append(std::vector<Index>(mesh.ElementIds.begin(), mesh.ElementIds.end()));
  }
  mesh.Points = Grown(mesh.Points, 3 * points);
  mesh.GeometryDimension = Grown(mesh.GeometryDimension, points);
  mesh.GeometryId = Grown(mesh.GeometryId, points);
  for (Buffer<Index>* ids : { &mesh.PeriodicPartner, &mesh.OriginalPointIds })
  {
    if (!ids->empty())
    {
      *ids = Grown(*ids, points);
      std::copy(
        mesh.PointIds.begin() + this->Corners, mesh.PointIds.end(), ids->begin() + this->Corners);
    }
  }
}

/// Collective. Returns the lowest id of the mid nodes with equal keys, for each mid node.
/// @param first  point of the first key
template <class Key>
std::vector<Index> MidNodeBuilder::LowestIds(Index first, const std::vector<Key>& keys) const
{
  const auto start = this->TheMesh.PointIds.begin() + first;
  return MergeByKey(
    keys, std::vector<Index>(start, start + keys.size()),
    [](Index a, Index b) { return std::min(a, b); }, this->Run.Group());
}

/// Collective. Gives all copies of a mid node at split interfaces the lowest id of them as the id
/// before the split.
void MidNodeBuilder::SetOriginalIds()
{
  Mesh& mesh = this->TheMesh;
  const auto setLowest = [&](Index first, const auto& keys)
  {
    const std::vector<Index> lowest =
      this->LowestIds(first, this->KeysOf(keys, mesh.OriginalPointIds));
    std::copy(lowest.begin(), lowest.end(), mesh.OriginalPointIds.begin() + first);
  };
  if (this->IsSplit)
  {
    setLowest(this->Corners, this->Edges);
    setLowest(this->FirstFace(), this->Faces);
  }
}

/// Collective. Sets the partners of the mid nodes of edges or faces, and moves copies to exactly
/// whole periods from each other.
/// @param first  point of the first key
template <class Key>
void MidNodeBuilder::SetPartners(Index first, const DistinctKeys<Key>& keys)
{
  if (!this->HasCopies)
  {
    return;
  }
  Mesh& mesh = this->TheMesh;
  const auto count = static_cast<Index>(keys.Ids.size());
  std::vector<Vector3> places;
  for (Index point = first; point < first + count; ++point)
  {
    places.push_back(this->Images.ToOwn(mesh.PointAt(point)));
  }
  std::vector<Key> shared = this->KeysOf(keys, mesh.PeriodicPartner);
  const std::vector<Index> lowest = this->LowestIds(first, shared);
  if (this->IsSplit) // copies at split interfaces are in one place too
  {
    shared = this->KeysOf(keys, mesh.CommonIds());
  }
  places = MergeByKey(shared, places, LowestOf, this->Run.Group());
  std::copy(lowest.begin(), lowest.end(), mesh.PeriodicPartner.begin() + first);
  for (Index i = 0; i < count; ++i)
  {
    const Vector3 x = this->Images.ImageOf(places[i], mesh.PointAt(first + i));
    std::copy(x.begin(), x.end(), mesh.Points.data() + 3 * (first + i));
  }
}

/// Places the mid nodes of edges in their middles.
void MidNodeBuilder::PlaceEdges()
{
  Mesh& mesh = this->TheMesh;
  const Buffer<Index>& ids = mesh.UnsplitPointIds();
  for (std::size_t edge = 0; edge < this->Edges.Places.size(); ++edge)
  {
    auto [low, high] = this->EndsAt(this->Edges.Places[edge]);
    if (ids[low] > ids[high])
    {
      std::swap(low, high);
    }
    const Vector3 end = mesh.PointAt(low);
    const Vector3 x = 0.5 * (end + this->Images.Near(mesh.PointAt(high), end));
    std::copy(x.begin(), x.end(), mesh.Points.data() + 3 * (this->Corners + edge));
  }
}

/// Returns the edges that may be curved: those with both ends on surfaces, and those of layers.
std::vector<Index> MidNodeBuilder::ListCurvedEdges() const
{
  const Mesh& mesh = this->TheMesh;
  std::vector<unsigned char> mayBeCurved(this->Edges.Ids.size(), 0);
  for (std::size_t edge = 0; edge < mayBeCurved.size(); ++edge)
  {
    const auto [first, second] = this->EndsAt(this->Edges.Places[edge]);
    mayBeCurved[edge] = mesh.GeometryDimension[first] < DimensionOfVolumes &&
      mesh.GeometryDimension[second] < DimensionOfVolumes;
  }
  for (std::size_t element = 0; element < mesh.Layer.size(); ++element)
  {
    for (int e = 0; mesh.Layer[element] > 0 && e < this->Mids.Edges; ++e)
    {
      mayBeCurved[this->MidsOf(static_cast<Index>(element))[e] - this->Corners] = 1;
    }
  }
  std::vector<Index> edges;
  for (std::size_t edge = 0; edge < mayBeCurved.size(); ++edge)
  {
    if (mayBeCurved[edge] != 0)
    {
      edges.push_back(static_cast<Index>(edge));
    }
  }
  return edges;
}

/// Collective. Moves the mid nodes of interface edges onto the interface.
CurvedReport MidNodeBuilder::CurveEdges()
{
  Mesh& mesh = this->TheMesh;
  const std::vector<Index> edges = this->ListCurvedEdges();
  std::vector<EdgeIds> questions;
  for (Index edge : edges)
  {
    questions.push_back(KeyOf(mesh.CommonIds(), this->EndsAt(this->Edges.Places[edge])));
  }
  const std::vector<EdgeMove> moves = CombinePulls(mesh.Pulls, questions, this->Run.Group());
  std::vector<EdgePull>().swap(mesh.Pulls);
  CurvedEdges curved;
  curved.OfMidPoint.assign(this->Edges.Ids.size(), -1);
  for (std::size_t i = 0; i < moves.size(); ++i)
  {
    if (Norm(moves[i].Move) > 0.0)
    {
      curved.OfMidPoint[edges[i]] = static_cast<Index>(curved.Ids.size());
      curved.Ids.push_back(this->Edges.Ids[edges[i]]);
      curved.Groups.push_back(moves[i].Group);
      curved.Moves.push_back(moves[i].Move);
    }
  }
  const CurvedReport report = StraightenEdges(mesh, this->Corners, this->Images, this->Run, curved);
  for (std::size_t edge = 0; edge < curved.OfMidPoint.size(); ++edge)
  {
    for (int a = 0; curved.OfMidPoint[edge] >= 0 && a < 3; ++a)
    {
      mesh.Points[3 * (this->Corners + edge) + a] += curved.Moves[curved.OfMidPoint[edge]][a];
    }
  }
  return report;
}

/// Returns the sum of some points, at the images near to a point, in the order of their ids, with
/// pairs of equal coordinates added exactly.
Vector3 MidNodeBuilder::SumOf(const Index* points, int count, const Vector3& near) const
{
  const Buffer<Index>& ids = this->TheMesh.UnsplitPointIds();
  std::array<Index, 12> sorted;
  std::copy_n(points, count, sorted.begin());
  std::sort(
    sorted.begin(), sorted.begin() + count, [&ids](Index a, Index b) { return ids[a] < ids[b]; });
  const auto at = [&](int i) { return this->Images.Near(this->TheMesh.PointAt(sorted[i]), near); };
  Vector3 sum{ { 0.0, 0.0, 0.0 } };
  for (int i = 0; i < count; i += 2)
  {
    sum = sum + (at(i) + at(i + 1));
  }
  return sum;
}

/// Returns the position of the point with the lowest id.
Vector3 MidNodeBuilder::PlaceOfLowest(const Index* corners, int count) const
{
  const Buffer<Index>& ids = this->TheMesh.UnsplitPointIds();
  return this->TheMesh.PointAt(*std::min_element(
    corners, corners + count, [&ids](Index a, Index b) { return ids[a] < ids[b]; }));
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
      const Vector3 near = this->PlaceOfLowest(corners, 8);
      place(mids[this->Mids.Count - 1],
        0.25 * (this->SumOf(mids, 12, near) - this->SumOf(corners, 8, near)));
    });
  ForEach(this->Run, this->Faces.Places.size(),
    [&](Index i)
    {
      const Index element = this->Faces.Places[i] / this->Mids.Count;
      const int face =
        static_cast<int>(this->Faces.Places[i] % this->Mids.Count) - this->Mids.Edges;
      Index edges[4];
      for (int c = 0; c < 4; ++c)
      {
        edges[c] = this->MidsOf(element)[this->Mids.EdgeOfFace(face, c)];
      }
      const std::array<Index, 4> corners = faces.PointsOf(this->CornersOf(element), face);
      const Vector3 near = this->PlaceOfLowest(corners.data(), 4);
      place(this->FirstFace() + i,
        0.5 * this->SumOf(edges, 4, near) - 0.25 * this->SumOf(corners.data(), 4, near));
    });
}

/// Collective. Fills the geometry of mid nodes.
void MidNodeBuilder::FillGeometry()
{
  Mesh& mesh = this->TheMesh;
  PlacedKeys<EdgeIds> edges;
  PlacedKeys<FaceIds> faces;
  const SurfaceFacets& surfaces = mesh.Surfaces;
  const Buffer<Index>& ids = mesh.UnsplitPointIds();
  const int corners = mesh.CornersOfFacet();
  for (std::size_t f = 0; f < surfaces.SurfaceId.size(); ++f)
  {
    const Index* points = surfaces.Points.data() + corners * f;
    for (int c = 0; c < corners; ++c)
    {
      edges.Add(KeyOf(ids, std::array<Index, 2>{ { points[c], points[(c + 1) % corners] } }),
        DimensionOfSurfaces, surfaces.SurfaceId[f]);
    }
    if (this->Mids.HasFaces())
    {
      faces.Add(KeyOf(ids, FaceIds{ { points[0], points[1], points[2], points[3] } }),
        DimensionOfSurfaces, surfaces.SurfaceId[f]);
    }
  }
  for (std::size_t e = 0; e < mesh.Curves.CurveId.size(); ++e)
  {
    const Index* ends = mesh.Curves.Points.data() + 2 * e;
    edges.Add(KeyOf(ids, std::array<Index, 2>{ { ends[0], ends[1] } }), DimensionOfSurfaces - 1,
      mesh.Curves.CurveId[e]);
  }
  const auto unsplit = [&](const auto& keys)
  { return this->IsSplit ? this->KeysOf(keys, ids) : keys.Ids; };
  std::vector<Place> places = FindPlaces(edges, unsplit(this->Edges), this->Run.Group());
  const std::vector<Place> ofFaces = FindPlaces(faces, unsplit(this->Faces), this->Run.Group());
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
  const Buffer<Index>& ids = mesh.UnsplitPointIds();
  Buffer<Value> values(width * mesh.PointIds.size());
  std::copy_n(array.Values.data(), array.Values.size(), reinterpret_cast<char*>(values.data()));
  builder.ForCorners(
    [&](Index mid, const Index* corners, int count)
    {
      std::array<Index, 8> sorted;
      std::copy_n(corners, count, sorted.begin());
      std::sort(sorted.begin(), sorted.begin() + count,
        [&ids](Index a, Index b) { return ids[a] < ids[b]; });
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

FieldArrays AddMidNodes(InterpolationOrder order, const FieldArrays& fields, Runtime& runtime,
  Mesh& mesh, OutputState& state)
{
  MidNodeBuilder builder(order, fields, runtime, mesh);
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
