#include "Geometry/GatherTables.h"

#include "Base/Sorted.h"
#include "Ranks/Agreement.h"

namespace vfm
{
namespace
{

/// Row of a surface as ranks send it. Ranks have equal rows of the same surface.
struct SurfaceRow
{
  int Id;
  GeometryTables::Pair Volumes, Materials;
  int Side, Part, Name; ///< Name: place in the names of patches of all ranks
  double Area;
  std::array<double, 3> Centroid, Normal;
  bool operator<(const SurfaceRow& other) const { return this->Id < other.Id; }
  bool operator==(const SurfaceRow& other) const { return this->Id == other.Id; }
};

/// Returns the names of patches of all ranks, ascending, each once.
/// @pre Collective.
std::vector<std::string> GatherNames(Ranks& ranks, std::vector<std::string> names)
{
  SortUnique(names);
  Bytes mine;
  for (const std::string& name : names)
  {
    mine.insert(mine.end(), name.c_str(), name.c_str() + name.size() + 1); // with a zero
  }
  names.clear();
  for (const Bytes& bytes : ranks.Gather(mine))
  {
    for (auto at = bytes.begin(); at != bytes.end();)
    {
      const auto end = std::find(at, bytes.end(), '\0');
      names.emplace_back(at, end);
      at = end + 1;
    }
  }
  SortUnique(names);
  return names;
}

/// @param names  of patches of all ranks
std::vector<SurfaceRow> PackRows(const GeometryTables& t, const std::vector<std::string>& names)
{
  std::vector<SurfaceRow> rows;
  for (std::size_t s = 0; s < t.SurfaceVolumes.size(); ++s)
  {
    const int id = t.HasAllSurfaces ? static_cast<int>(s) + 1 : t.SurfaceIds[s];
    const auto name =
      t.PatchNames.empty() ? -1 : static_cast<int>(FindSorted(names, t.PatchNames[s]));
    rows.push_back({ id, t.SurfaceVolumes[s], t.SurfaceMaterials[s], t.SurfaceSides[s],
      t.SurfaceParts[s], name, t.SurfaceAreas[s], t.SurfaceCentroids[s], t.SurfaceNormals[s] });
  }
  return rows;
}

/// Returns a column of rows.
template <class Row, class Value>
std::vector<Value> ColumnOf(const std::vector<Row>& rows, Value Row::*value)
{
  std::vector<Value> column;
  column.reserve(rows.size());
  for (const Row& row : rows)
  {
    column.push_back(row.*value);
  }
  return column;
}

} // namespace

void GatherSurfaceTables(Ranks& ranks, GeometryTables& tables)
{
  if (ranks.Count() == 1)
  {
    return;
  }
  const std::vector<std::string> names = GatherNames(ranks, tables.PatchNames);
  const std::vector<SurfaceRow> rows = UnionOverRanks(ranks, PackRows(tables, names));
  tables.HasAllSurfaces = true;
  tables.SurfaceIds.clear();
  tables.SurfaceVolumes = ColumnOf(rows, &SurfaceRow::Volumes);
  tables.SurfaceMaterials = ColumnOf(rows, &SurfaceRow::Materials);
  tables.SurfaceSides = ColumnOf(rows, &SurfaceRow::Side);
  tables.SurfaceParts = ColumnOf(rows, &SurfaceRow::Part);
  tables.SurfaceAreas = ColumnOf(rows, &SurfaceRow::Area);
  tables.SurfaceCentroids = ColumnOf(rows, &SurfaceRow::Centroid);
  tables.SurfaceNormals = ColumnOf(rows, &SurfaceRow::Normal);
  tables.PatchNames.clear();
  for (std::size_t s = 0; s < rows.size() && !names.empty(); ++s)
  {
    tables.PatchNames.push_back(names[rows[s].Name]);
  }
  tables.VolumeSurfaces = UnionOverRanks(ranks, std::move(tables.VolumeSurfaces));
  tables.EdgeFacets = UnionOverRanks(ranks, std::move(tables.EdgeFacets));
}

void GatherCurveTables(Ranks& ranks, GeometryTables& tables)
{
  if (ranks.Count() == 1)
  {
    return;
  }
  std::vector<GeometryTables::Pair> rows; // number and ends
  for (std::size_t c = 0; c < tables.CurveEnds.size(); ++c)
  {
    const int id = tables.HasAllCurves ? static_cast<int>(c) + 1 : tables.CurveIds[c];
    rows.push_back({ { id, tables.CurveEnds[c] } });
  }
  tables.HasAllCurves = true;
  tables.CurveIds.clear();
  tables.CurveEnds.clear();
  for (const GeometryTables::Pair& row : UnionOverRanks(ranks, std::move(rows)))
  {
    tables.CurveEnds.push_back(row[1]);
  }
  tables.SurfaceCurves = UnionOverRanks(ranks, std::move(tables.SurfaceCurves));
  tables.CurveVertices = UnionOverRanks(ranks, std::move(tables.CurveVertices));
}

} // namespace vfm
