#include "Modify/MeshOfData.h"

#include "Base/Sorted.h"
#include "Ranks/Agreement.h"
#include "Ranks/MergeByKey.h"
#include "Ranks/NumberKeys.h"
#include "Report/DomainSides.h"
#include "Report/FlatData.h"
#include "Report/MatchFaces.h"
#include "Report/MeshArrays.h"
#include "Report/MeshFacets.h"
#include "Report/MeshFields.h"
#include "Report/Sets/MeshSets.h"

namespace vfm
{
namespace
{

/// Copies an array. A view of a missing one must be null, which a buffer of size 0 is not.
template <class T>
Buffer<T> CopyOf(const T* values, Index count)
{
  if (!values)
  {
    return {};
  }
  Buffer<T> copy(count);
  std::copy(values, values + copy.size(), copy.begin());
  return copy;
}

template <class T>
Buffer<T> CopyOf(const std::vector<T>& values)
{
  return CopyOf(values.data(), static_cast<Index>(values.size()));
}

int NumberOf(const std::vector<int>& labels, int material)
{
  return static_cast<int>(
    std::lower_bound(labels.begin(), labels.end(), material) - labels.begin());
}

/// Sides of a surface: two fragments, the smaller first; 0: not meshed, -1 - DomainSide: outside.
using SurfaceSides = std::array<int, 2>;

/// Values of a facet whose sides are not on a surface: opposite sides of a periodic fragment.
constexpr SurfaceSides NoSurface{ { 0, 0 } };

/// Returns the fragments behind facets, also across a periodic side, or NothingBehind.
/// @pre Collective
std::vector<Index> FindFragmentsBehind(
  const MeshData& data, const std::vector<MeshFacet>& facets, Ranks& ranks)
{
  std::vector<std::size_t> inner, across;
  std::array<std::vector<FaceIds>, 2> ids;
  std::array<std::vector<Index>, 2> fragments;
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    const bool isAcross = facets[f].DomainSide != NoSide;
    if (isAcross && !data.PeriodicPartner)
    {
      continue;
    }
    (isAcross ? across : inner).push_back(f);
    ids[isAcross].push_back(
      SortedIds(PointsOfSide(data, facets[f]), isAcross ? data.PeriodicPartner : data.PointIds));
    fragments[isAcross].push_back(data.Fragment[facets[f].Element]);
  }
  std::vector<Index> behind(facets.size(), NothingBehind);
  const std::vector<Index> inside = MatchFaces(ids[0], fragments[0], ranks);
  const std::vector<Index> opposite = MatchFaces(ids[1], fragments[1], ranks);
  for (std::size_t i = 0; i < inner.size(); ++i)
  {
    behind[inner[i]] = inside[i];
  }
  for (std::size_t i = 0; i < across.size(); ++i)
  {
    behind[across[i]] = opposite[i];
  }
  return behind;
}

/// Returns the sides of the surface of each facet.
/// @pre Collective
std::vector<SurfaceSides> FindSurfaceSides(
  const MeshData& data, const std::vector<MeshFacet>& facets, Ranks& ranks)
{
  const std::vector<Index> behind = FindFragmentsBehind(data, facets, ranks);
  std::vector<SurfaceSides> sides;
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    const int own = data.Fragment[facets[f].Element];
    const int other = behind[f] != NothingBehind ? static_cast<int>(behind[f])
      : facets[f].DomainSide != NoSide           ? -1 - facets[f].DomainSide
                                                 : 0;
    sides.push_back(
      own == other ? NoSurface : SurfaceSides{ { std::min(own, other), std::max(own, other) } });
  }
  return sides;
}

/// Key of a surface: its sides, and the number of a smooth side, or 0.
using SurfaceKey = std::array<int, 3>;

SurfaceKey KeyOf(const SurfaceSides& sides, const MeshFacet& facet)
{
  return { { sides[0], sides[1], facet.Surface } };
}

/// Returns the numbers of surfaces from 0, as when the mesh was made: ascending by their sides; the
/// smooth sides of an interface follow each other.
/// @param keys  of this rank, ascending, each once
/// @throws InputError  on all ranks if parts of the mesh are missing
/// @pre Collective
std::vector<Index> NumberSurfaces(
  const std::vector<SurfaceKey>& keys, const MeshData& data, Ranks& ranks)
{
  int most = 0;
  for (const SurfaceKey& key : keys)
  {
    most = std::max(most, key[1]);
  }
  const auto width = static_cast<Index>(ranks.Max(most)) + 1;
  const KeyNumbers numbers = NumberKeys(
    keys, [width](const SurfaceKey& key) { return (key[0] + 6) * width + key[1]; }, ranks);
  WorkTogether(ranks,
    [&]
    {
      const std::vector<double> counts = NumbersOfField(data.Fields, "NumberOfSurfaces");
      if (counts.size() == 1 && counts[0] != static_cast<double>(numbers.Total))
      {
        throw InputError("The mesh has " + std::to_string(numbers.Total) + " surfaces, and " +
          std::to_string(static_cast<Index>(counts[0])) +
          " when it was made: parts of it are missing. Layers need the whole mesh.");
      }
    });
  return numbers.Numbers;
}

/// Returns the point arrays that are not part of Mesh.
std::vector<MeshArray> ListOtherPointArrays(const MeshData& mesh)
{
  std::vector<MeshArray> others;
  std::copy_if(mesh.PointArrays.begin(), mesh.PointArrays.end(), std::back_inserter(others),
    [](const MeshArray& array) { return !FindKnownArray(array.Name); });
  return others;
}

/// Throws InputError if a mesh cannot get layers.
void CheckForLayers(const MeshData& mesh, const MesherOptions& options)
{
  if (FindArray(mesh.ElementArrays, "Layer"))
  {
    throw InputError("The mesh has layers already (array Layer).");
  }
  if (options.FirstLayer > 0.0 && options.FirstLayerUnit == ThicknessUnit::Cells)
  {
    throw InputError("FirstLayerUnit must be Length: a mesh does not know the width of its cells.");
  }
  if (FindField(mesh.Fields, "PeriodLengths"))
  {
    if (!mesh.PeriodicPartner && mesh.NumberOfPoints > 0)
    {
      throw InputError("Opposite sides of the mesh are joined: layers must be cut before, by the "
                       "filter that makes the mesh.");
    }
    if (FindField(mesh.Fields, "DomainFrame"))
    {
      throw InputError("The mesh is periodic along the axes of a rotated image: layers must be "
                       "cut by the filter that makes the mesh.");
    }
  }
  for (const MeshArray& array : ListOtherPointArrays(mesh))
  {
    throw InputError("The mesh has the point array " + array.Name +
      ", of which layers would have no values. Remove it first.");
  }
}

} // namespace

Mesh MakeMeshOf(const MeshData& data, const std::vector<int>& labels, Ranks& ranks)
{
  Mesh mesh;
  const Index points = data.NumberOfPoints, elements = data.NumberOfElements;
  mesh.Corners = data.Corners;
  mesh.Ids = data.HasHexes() || IsFlat(data) ? HexIds : TetIds;
  mesh.Points = CopyOf(data.Points, 3 * points);
  mesh.Elements = CopyOf(data.Elements, data.Corners * elements);
  const auto copy = [](Index count)
  {
    return [count](const KnownArray&, const auto* values, auto& buffer)
    { buffer = CopyOf(values, count); };
  };
  VisitPointArrays(copy(points), data, mesh);
  VisitElementArrays(copy(elements), data, mesh);
  mesh.Facets = FindMeshFacets(data, ranks);
  for (int& material : mesh.Material)
  {
    material = NumberOf(labels, material);
  }
  for (MeshFacet& facet : mesh.Facets)
  {
    facet.Behind = facet.Behind > 0 ? NumberOf(labels, facet.Behind) : facet.Behind;
  }
  const std::vector<double> parts = NumbersOfField(data.Fields, "SurfaceParts");
  mesh.Tables.SurfaceParts.assign(parts.begin(), parts.end());
  const std::vector<double> ids = NumbersOfField(data.Fields, "SurfaceIds");
  mesh.Tables.SurfaceIds.assign(ids.begin(), ids.end());
  mesh.Tables.HasAllSurfaces = FindField(data.Fields, "SurfaceIds") == nullptr;
  mesh.Tables.EdgeFacets = ReadEdgeFacets(data.Fields);
  return mesh;
}

void SetGeometry(
  const std::vector<int>& labels, SurfaceFacets surfaces, CurveEdges curves, Mesh& mesh)
{
  for (int& material : surfaces.MaterialPair)
  {
    material = NumberOf(labels, material);
  }
  surfaces.IsOwned.assign(surfaces.SurfaceId.size(), 1);
  mesh.Surfaces = std::move(surfaces);
  mesh.Curves = std::move(curves);
}

OutputState MakeStateOf(const MeshData& mesh, const std::vector<std::string>& extensive)
{
  OutputState state;
  for (const MeshArray& array : mesh.ElementArrays)
  {
    if (FindKnownArray(array.Name))
    {
      continue;
    }
    const Index bytes = mesh.NumberOfElements * array.Components * WidthOfType(array.Type);
    const bool isExtensive =
      std::find(extensive.begin(), extensive.end(), array.Name) != extensive.end();
    if (isExtensive && array.Type != ValueType::Double)
    {
      throw InputError("The extensive array " + array.Name + " must be of type double, not " +
        NameOfType(array.Type) + ".");
    }
    state.Arrays.push_back({ array.Name, array.Type, array.Components, array.ComponentNames,
      isExtensive, CopyOf(static_cast<const char*>(array.Values), bytes) });
  }
  for (const std::string& name : extensive)
  {
    if (std::none_of(state.Arrays.begin(), state.Arrays.end(),
          [&name](const TransferredArray& array) { return array.Name == name; }))
    {
      throw InputError("The mesh has no state array " + name + ", which is to be extensive.");
    }
  }
  return state;
}

void AddSurfaces(const MeshData& data, Ranks& ranks, Mesh& mesh)
{
  const std::vector<SurfaceSides> sides = FindSurfaceSides(data, mesh.Facets, ranks);
  std::vector<SurfaceKey> keys;
  for (std::size_t f = 0; f < sides.size(); ++f)
  {
    if (sides[f] != NoSurface)
    {
      keys.push_back(KeyOf(sides[f], mesh.Facets[f]));
    }
  }
  SortUnique(keys);
  const std::vector<Index> numbers = NumberSurfaces(keys, data, ranks);
  std::vector<Index> points;
  std::vector<int> ids, materials, domainSides;
  const ElementFaces faces(mesh.Corners);
  for (std::size_t f = 0; f < mesh.Facets.size(); ++f)
  {
    const MeshFacet& facet = mesh.Facets[f];
    if (sides[f] == NoSurface)
    {
      continue;
    }
    const std::array<Index, 4> face = faces.PointsOf(data.Element(facet.Element), facet.Side);
    points.insert(points.end(), face.begin(), face.begin() + faces.Corners);
    ids.push_back(facet.Surface > 0
        ? facet.Surface
        : static_cast<int>(numbers[FindSorted(keys, KeyOf(sides[f], facet))]) + 1);
    const int own = mesh.Material[facet.Element], other = std::max(facet.Behind, 0);
    materials.insert(materials.end(), { std::min(own, other), std::max(own, other) });
    domainSides.push_back(facet.DomainSide);
  }
  mesh.Surfaces = { CopyOf(points), CopyOf(ids), CopyOf(materials),
    std::vector<unsigned char>(ids.size(), 1), CopyOf(domainSides) };
}

void CheckMesh(const MeshData& mesh, const MesherOptions& options)
{
  Require(mesh.Material, "MaterialId", mesh);
  Require(mesh.Fragment, "FragmentId", mesh);
  Require(mesh.GeometryDimension, "GeometryDimension", mesh);
  Require(mesh.GeometryId, "GeometryId", mesh);
  if (mesh.MidsPerElement > 0)
  {
    throw InputError("The mesh has elements of second order. Layers are cut and interfaces are "
                     "split before mid nodes are added: set Element Order where it is meshed.");
  }
  if (mesh.OriginalPointIds)
  {
    throw InputError("The interfaces of the mesh are split already (OriginalPointIds).");
  }
  if (options.Layers > 1)
  {
    CheckForLayers(mesh, options);
  }
}

void CheckElementIds(const MeshData& mesh, Ranks& ranks)
{
  std::vector<std::array<Index, 1>> keys;
  for (Index e = 0; e < mesh.NumberOfElements; ++e)
  {
    keys.push_back({ { mesh.ElementIds[e] } });
  }
  const std::vector<int> counts =
    MergeByKey(keys, std::vector<int>(keys.size(), 1), std::plus<int>(), ranks);
  WorkTogether(ranks,
    [&]
    {
      const auto repeated = std::find_if(counts.begin(), counts.end(), [](int n) { return n > 1; });
      if (repeated != counts.end())
      {
        throw InputError("The element " + std::to_string(keys[repeated - counts.begin()][0]) +
          " (GlobalCellIds) is on several ranks.");
      }
    });
}

std::vector<TransferredArray> CopyPointArrays(const MeshData& before, const Mesh& mesh)
{
  std::vector<Index> sources;
  for (Index id : mesh.UnsplitPointIds())
  {
    sources.push_back(
      std::lower_bound(before.PointIds, before.PointIds + before.NumberOfPoints, id) -
      before.PointIds);
  }
  std::vector<TransferredArray> copies;
  for (const MeshArray& array : ListOtherPointArrays(before))
  {
    const Index width = array.Components * WidthOfType(array.Type);
    Buffer<char> values(sources.size() * width);
    for (std::size_t p = 0; p < sources.size(); ++p)
    {
      const char* from = static_cast<const char*>(array.Values) + width * sources[p];
      std::copy_n(from, width, values.data() + width * p);
    }
    copies.push_back(
      { array.Name, array.Type, array.Components, array.ComponentNames, false, std::move(values) });
  }
  return copies;
}

} // namespace vfm
