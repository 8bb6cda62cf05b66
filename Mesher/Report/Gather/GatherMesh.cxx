#include "Report/Gather/GatherMesh.h"

#include "Base/Sorted.h"
#include "Ranks/Agreement.h"
#include "Report/FragmentTargets.h"
#include "Report/Gather/PackMesh.h"
#include "Report/MeshFields.h"

#include <functional>
#include <limits>
#include <map>
#include <numeric>

namespace vfm
{
namespace
{

using Pieces = std::vector<const MeshData*>;

/// A point or an element of the whole mesh, and its source.
struct Item
{
  Index Id; ///< global id
  std::size_t Piece;
  Index Place; ///< index in the piece
};

bool IsBefore(const Item& item, const Item& other)
{
  return item.Id < other.Id;
}

/// Returns all points or elements ordered by id, each id once. ids, count: members of MeshData.
std::vector<Item> SortItems(
  const Pieces& pieces, const Index* MeshData::*ids, Index MeshData::*count)
{
  std::vector<Item> items;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    for (Index i = 0; i < pieces[p]->*count; ++i)
    {
      items.push_back({ (pieces[p]->*ids)[i], p, i });
    }
  }
  std::stable_sort(items.begin(), items.end(), IsBefore);
  items.erase(std::unique(items.begin(), items.end(),
                [](const Item& a, const Item& b) { return a.Id == b.Id; }),
    items.end());
  return items;
}

Index PlaceOf(const std::vector<Item>& items, Index id)
{
  return std::lower_bound(items.begin(), items.end(), Item{ id, 0, 0 }, IsBefore) - items.begin();
}

/// Returns whether ids are strictly ascending.
bool IsInOrder(const Index* ids, Index count)
{
  return std::adjacent_find(ids, ids + count, std::greater_equal<Index>()) == ids + count;
}

/// Merges the values of items; width: values per item; valuesOf(piece): values of a piece.
template <class T, class Values>
std::vector<T> MergeValues(
  const Pieces& pieces, const std::vector<Item>& items, Index width, const Values& valuesOf)
{
  std::vector<const T*> values;
  for (const MeshData* piece : pieces)
  {
    values.push_back(valuesOf(*piece));
  }
  std::vector<T> merged(width * items.size());
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    std::copy_n(values[items[i].Piece] + width * items[i].Place, width, merged.data() + width * i);
  }
  return merged;
}

/// Merges the arrays of pieces; arrays: a member of MeshData.
std::vector<MeshArray> MergeArrays(const Pieces& pieces, const std::vector<Item>& items,
  std::vector<MeshArray> MeshData::*arrays, StoredMesh& merged)
{
  std::vector<MeshArray> list = pieces[0]->*arrays;
  for (MeshArray& array : list)
  {
    const auto valuesOf = [&](const MeshData& piece)
    {
      const MeshArray* other = FindArray(piece.*arrays, array.Name);
      if (!other || other->Type != array.Type || other->Components != array.Components)
      {
        throw InputError("The parts of the mesh have different arrays " + array.Name + ".");
      }
      return other->Values;
    };
    array.Values = VisitType(array.Type,
      [&](auto tag) -> const void*
      {
        using Value = typename decltype(tag)::Type;
        return merged.Store(MergeValues<Value>(pieces, items, array.Components,
          [&](const MeshData& piece) { return static_cast<const Value*>(valuesOf(piece)); }));
      });
  }
  return list;
}

/// Merges the corners or mid nodes of elements; nodes, width: members of MeshData.
std::vector<Index> MergeNodes(const Pieces& pieces, const std::vector<Item>& points,
  const std::vector<Item>& elements, const Index* MeshData::*nodes, int MeshData::*width)
{
  std::vector<Index> merged;
  merged.reserve(pieces[0]->*width * elements.size());
  for (const Item& element : elements)
  {
    const MeshData& piece = *pieces[element.Piece];
    const Index* first = piece.*nodes + piece.*width * element.Place;
    std::transform(first, first + piece.*width, std::back_inserter(merged),
      [&](Index point) { return PlaceOf(points, piece.PointIds[point]); });
  }
  return merged;
}

void MergeFacets(const Pieces& pieces, const std::vector<Item>& elements, StoredMesh& merged)
{
  auto facets = std::make_shared<std::vector<MeshFacet>>();
  for (const MeshData* piece : pieces)
  {
    if (!piece->Facets)
    {
      return;
    }
    for (MeshFacet facet : *piece->Facets)
    {
      facet.Element = PlaceOf(elements, piece->ElementIds[facet.Element]);
      facets->push_back(facet);
    }
  }
  std::sort(facets->begin(), facets->end());
  merged.Data.Facets = facets.get();
  merged.Memory.push_back(std::move(facets));
}

/// Returns the fields of the whole mesh: those that each piece has, and rows of all pieces where a
/// piece only has its own (JoinFields, ListSides).
FieldArrays MergeFields(const Pieces& pieces)
{
  std::vector<const FieldArrays*> ofPieces;
  for (const MeshData* piece : pieces)
  {
    ofPieces.push_back(&piece->Fields);
  }
  FieldArrays fields = JoinFields(ofPieces);
  std::map<int, int> parts; // by surface
  std::vector<std::array<Index, 5>> facets;
  for (const MeshData* piece : pieces)
  {
    const std::vector<double> ids = NumbersOfField(piece->Fields, "SurfaceIds");
    const std::vector<double> own = NumbersOfField(piece->Fields, "SurfaceParts");
    for (std::size_t s = 0; s < std::min(ids.size(), own.size()); ++s)
    {
      parts[static_cast<int>(ids[s])] = static_cast<int>(own[s]);
    }
    if (!ids.empty())
    {
      const std::vector<std::array<Index, 5>> more = ReadEdgeFacets(piece->Fields);
      facets.insert(facets.end(), more.begin(), more.end());
    }
  }
  if (parts.empty())
  {
    return fields;
  }
  GeometryTables tables;
  tables.HasAllSurfaces = false;
  for (const auto& [surface, part] : parts)
  {
    tables.SurfaceIds.push_back(surface);
    tables.SurfaceParts.push_back(part);
  }
  SortUnique(facets);
  tables.EdgeFacets = std::move(facets);
  FieldArrays sides = ListSides(tables);
  fields.erase(std::remove_if(fields.begin(), fields.end(),
                 [&sides](const FieldArray& field) { return FindField(sides, field.Name); }),
    fields.end());
  AppendFields(std::move(sides), fields);
  return fields;
}

/// Merges one or more pieces, all with elements.
StoredMesh MergePieces(const Pieces& pieces)
{
  const std::vector<Item> points =
    SortItems(pieces, &MeshData::PointIds, &MeshData::NumberOfPoints);
  const std::vector<Item> elements =
    SortItems(pieces, &MeshData::ElementIds, &MeshData::NumberOfElements);
  StoredMesh merged;
  MeshData& data = merged.Data;
  static_cast<NodeCounts&>(data) = *pieces[0];
  data.NumberOfPoints = static_cast<Index>(points.size());
  data.NumberOfElements = static_cast<Index>(elements.size());
  data.Points = merged.Store(
    MergeValues<double>(pieces, points, 3, [](const MeshData& piece) { return piece.Points; }));
  data.Elements =
    merged.Store(MergeNodes(pieces, points, elements, &MeshData::Elements, &MeshData::Corners));
  data.MidPoints = merged.Store(
    MergeNodes(pieces, points, elements, &MeshData::MidPoints, &MeshData::MidsPerElement));
  data.PointArrays = MergeArrays(pieces, points, &MeshData::PointArrays, merged);
  data.ElementArrays = MergeArrays(pieces, elements, &MeshData::ElementArrays, merged);
  data.Fields = MergeFields(pieces);
  FindKnownArrays(merged);
  MergeFacets(pieces, elements, merged);
  return merged;
}

void RequireIds(const MeshData& mesh)
{
  Require(mesh.PointIds, "GlobalPointIds", mesh);
  Require(mesh.ElementIds, "GlobalCellIds", mesh);
}

StoredMesh OrderAlone(const MeshData& mesh)
{
  const bool isInOrder = IsInOrder(mesh.PointIds, mesh.NumberOfPoints) &&
    IsInOrder(mesh.ElementIds, mesh.NumberOfElements);
  StoredMesh ordered = isInOrder ? StoredMesh{ mesh, {} } : MergePieces({ &mesh });
  ordered.Data.Time = mesh.Time;
  return ordered;
}

void CheckIds(const char* name, const Index* ids, Index count)
{
  if (count > 0 && *std::min_element(ids, ids + count) < 1)
  {
    throw InputError(std::string(name) + " must be 1 or more.");
  }
}

/// Collective. Checks that all ranks have the same kind of elements.
void CheckCorners(const MeshData& mesh, Ranks& ranks)
{
  const auto has = [&](int corners)
  { return ranks.Any(mesh.NumberOfElements > 0 && mesh.Corners == corners); };
  if (const bool hasHexes = has(8), hasTets = has(4); hasHexes && hasTets)
  {
    throw InputError("The mesh must be all hexahedra or all tetrahedra.");
  }
  const double own = mesh.NumberOfElements > 0 ? mesh.MidsPerElement : -1.0;
  const double most = ranks.Max(own);
  if (ranks.Any(own >= 0.0 && own != most))
  {
    throw InputError("All elements of the mesh must have the same number of nodes.");
  }
}

/// Collective. Checks that the parts of a mesh can be one mesh: lists of it have at most 2^31 - 1
/// entries.
void CheckLength(const MeshData& mesh, Ranks& ranks)
{
  if (ranks.Count() == 1)
  {
    return;
  }
  constexpr std::int64_t longest = std::numeric_limits<std::int32_t>::max();
  std::vector<std::int64_t> counts{ mesh.NumberOfElements, mesh.NumberOfPoints };
  ranks.Sum(counts);
  if (counts[0] > longest || counts[1] > longest)
  {
    throw InputError("The mesh has " + std::to_string(counts[0]) + " elements and up to " +
      std::to_string(counts[1]) + " points. One file holds the mesh of several ranks up to " +
      std::to_string(longest) +
      " of each: choose files per rank (.pvtu, or Exodus with one file per rank).");
  }
}

/// Collective. Returns the latest time of all ranks, or 0.
double AgreeOnTime(const MeshData& mesh, Ranks& ranks)
{
  constexpr double none = -std::numeric_limits<double>::infinity();
  const double time = ranks.Max(mesh.Time.value_or(none));
  return time == none ? 0.0 : time;
}

} // namespace

MeshData ShareHead(const MeshData& mesh, Ranks& ranks)
{
  const bool isFilled = mesh.NumberOfElements > 0;
  const double first = -ranks.Max(isFilled ? -ranks.Rank() : -ranks.Count());
  if (first >= ranks.Count())
  {
    throw InputError("The mesh is empty.");
  }
  if (!ranks.Any(!isFilled))
  {
    return mesh;
  }
  Bytes head;
  WorkTogether(ranks,
    [&]
    {
      if (ranks.Rank() == static_cast<int>(first))
      {
        head = PackHead(mesh);
      }
    });
  const std::vector<Bytes> heads = ranks.Gather(head);
  if (isFilled)
  {
    return mesh;
  }
  MeshData empty = UnpackMesh(heads[static_cast<std::size_t>(first)]).Data;
  empty.Points = nullptr;
  empty.Elements = nullptr;
  empty.MidPoints = nullptr;
  empty.Time = mesh.Time;
  return empty;
}

StoredMesh OrderMesh(const MeshData& mesh, Ranks& ranks)
{
  const double time = AgreeOnTime(mesh, ranks);
  MeshData shared = ShareHead(mesh, ranks);
  shared.Time = time;
  CheckCorners(shared, ranks);
  StoredMesh ordered;
  WorkTogether(ranks,
    [&]
    {
      RequireIds(shared);
      CheckIds("GlobalPointIds", shared.PointIds, shared.NumberOfPoints);
      CheckIds("GlobalCellIds", shared.ElementIds, shared.NumberOfElements);
      ordered = shared.NumberOfElements > 0 ? OrderAlone(shared) : StoredMesh{ shared, {} };
    });
  return ordered;
}

std::vector<Bytes> SendToFirst(Bytes mine, Ranks& ranks)
{
  if (ranks.Rank() > 0)
  {
    std::vector<Bytes> outgoing(1);
    outgoing[0] = std::move(mine); // an initializer list would copy it
    ranks.Exchange({ 0 }, outgoing);
    return {};
  }
  std::vector<int> others(ranks.Count() - 1);
  std::iota(others.begin(), others.end(), 1);
  return ranks.Exchange(others, std::vector<Bytes>(others.size()));
}

StoredMesh GatherMesh(const MeshData& mesh, Ranks& ranks)
{
  CheckLength(mesh, ranks);
  CheckCorners(mesh, ranks);
  Bytes mine;
  WorkTogether(ranks,
    [&]
    {
      RequireIds(mesh);
      if (ranks.Rank() > 0 && mesh.NumberOfElements > 0)
      {
        mine = PackMesh(mesh);
      }
    });
  std::vector<Bytes> incoming = SendToFirst(std::move(mine), ranks);
  StoredMesh whole;
  WorkTogether(ranks,
    [&]
    {
      std::vector<StoredMesh> others;
      for (Bytes& bytes : incoming)
      {
        if (!bytes.empty())
        {
          others.push_back(UnpackMesh(bytes));
          bytes = Bytes();
        }
      }
      if (ranks.Rank() > 0)
      {
        return;
      }
      Pieces pieces;
      if (mesh.NumberOfElements > 0)
      {
        pieces.push_back(&mesh);
      }
      for (const StoredMesh& other : others)
      {
        pieces.push_back(&other.Data);
      }
      whole = pieces.empty() ? StoredMesh{ mesh, {} }
        : others.empty()     ? OrderAlone(mesh)
                             : MergePieces(pieces);
      if (others.empty() && ranks.Count() > 1)
      {
        whole.Data.Fields = JoinFields({ &whole.Data.Fields });
      }
      whole.Data.Time = mesh.Time;
    });
  return whole;
}

} // namespace vfm
