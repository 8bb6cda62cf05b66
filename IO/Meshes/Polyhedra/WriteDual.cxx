#include "Meshes/Polyhedra/WriteDual.h"

#include "Meshes/Files/MeshModel.h"
#include "Meshes/OpenFoam/FoamFile.h"
#include "Meshes/OpenFoam/FoamFolder.h"
#include "Meshes/Polyhedra/DualMeasures.h"
#include "Meshes/Vtk/VtuText.h"
#include "Report/FlatData.h"
#include "Report/MeshArrays.h"
#include "Report/Sets/NamedSurfaces.h"

#include <cstring>
#include <limits>
#include <numeric>

namespace vfm
{
namespace
{

/// Patches and zones of a dual mesh, and the order of its faces.
struct DualFoam
{
  std::vector<Index> Faces; ///< of the dual mesh, in the order of patches
  std::vector<FoamPatch> Patches;
  std::vector<FoamZone> CellZones, FaceZones;
};

ElementSide SideOf(Index wallSide)
{
  return { wallSide / 4, static_cast<int>(wallSide % 4) };
}

/// Returns the surface of a side on a wall.
WallSurface FindSurface(const FoamSurfaces& surfaces, const ElementSide& side)
{
  const SideSurface* found = surfaces.Find(side);
  if (!found)
  {
    return { -1, -1, true };
  }
  const FoamSurface& surface = surfaces.Surfaces[found->Surface];
  return { found->Surface, surface.Interface, surface.IsDomainSide };
}

void AddPatches(const DualMesh& dual, const FoamSurfaces& surfaces, DualFoam& foam)
{
  UniqueNames used;
  std::vector<FoamPatch> patches = ListPatches(surfaces, used);
  std::vector<std::vector<Index>> faces(patches.size());
  for (Index face = dual.NumberOfInnerFaces(); face < dual.NumberOfFaces(); ++face)
  {
    const SideSurface* side = surfaces.Find(SideOf(dual.WallSides[face]));
    (side ? faces[side->Surface] : faces.back()).push_back(face);
  }
  for (std::size_t p = 0; p < patches.size(); ++p)
  {
    if (!faces[p].empty())
    {
      patches[p].Count = static_cast<Index>(faces[p].size());
      foam.Patches.push_back(patches[p]);
      foam.Faces.insert(foam.Faces.end(), faces[p].begin(), faces[p].end());
    }
  }
  RemoveEqualGroups(foam.Patches);
}

void AddFaceZones(const DualMesh& dual, const FoamSurfaces& surfaces, DualFoam& foam)
{
  std::vector<FoamZone> zones(surfaces.Surfaces.size());
  for (Index face = 0; face < dual.NumberOfInnerFaces(); ++face)
  {
    const Index wall = dual.WallSides[face];
    if (const SideSurface* side = wall < 0 ? nullptr : surfaces.Find(SideOf(wall)))
    {
      FoamZone& zone = zones[surfaces.Surfaces[side->Surface].Interface];
      zone.Members.push_back(face);
      zone.IsFlipped.push_back(side->IsFlipped);
    }
  }
  for (std::size_t z = 0; z < zones.size(); ++z)
  {
    if (!zones[z].Members.empty())
    {
      zones[z].Name = surfaces.Surfaces[z].Name;
      foam.FaceZones.push_back(std::move(zones[z]));
    }
  }
}

void AddCellZones(const MeshData& mesh, const DualMesh& dual, Ranks& ranks, DualFoam& foam)
{
  UniqueNames used;
  std::map<int, std::size_t> zones; // by material
  for (const MaterialPart& part : FindMaterialParts(mesh, ranks))
  {
    zones[part.Material] = foam.CellZones.size();
    foam.CellZones.push_back({ used.Add(FoamWord(part.Name)), {}, {} });
  }
  for (Index cell = 0; cell < dual.NumberOfCells(); ++cell)
  {
    const int material = mesh.Material[dual.Cells.Tets[cell]];
    foam.CellZones[zones.at(material)].Members.push_back(cell);
  }
}

void CheckLabels(const DualMesh& dual)
{
  const Index largest = std::max(
    { dual.NumberOfPoints(), dual.NumberOfFaces(), static_cast<Index>(dual.FacePoints.size()) });
  if (largest > std::numeric_limits<std::int32_t>::max())
  {
    throw InputError("The mesh has " + std::to_string(dual.NumberOfFaces()) + " faces with " +
      std::to_string(dual.FacePoints.size()) +
      " corners. OpenFOAM's labels of 32 bits count at most 2147483647.");
  }
}

/// Returns arrays of one value per cell from those of the tetrahedra's points.
std::vector<MeshArray> TakePointArrays(
  const MeshData& mesh, const std::vector<Index>& nodes, StoredMesh& kept)
{
  std::vector<MeshArray> arrays;
  for (const MeshArray& array : mesh.PointArrays)
  {
    if (!FindKnownArray(array.Name) && array.Values)
    {
      const std::size_t width = static_cast<std::size_t>(WidthOfType(array.Type)) *
        static_cast<std::size_t>(array.Components);
      std::vector<char> values(width * nodes.size());
      for (std::size_t cell = 0; cell < nodes.size(); ++cell)
      {
        std::memcpy(values.data() + width * cell,
          static_cast<const char*>(array.Values) + width * static_cast<std::size_t>(nodes[cell]),
          width);
      }
      arrays.push_back(array);
      arrays.back().Values = kept.Store(std::move(values));
    }
  }
  return arrays;
}

/// Returns the value of each cell's lowest tetrahedron or node.
template <class Value>
std::vector<Value> TakeValues(const Value* values, const std::vector<Index>& places)
{
  std::vector<Value> taken(places.size());
  std::transform(
    places.begin(), places.end(), taken.begin(), [values](Index place) { return values[place]; });
  return taken;
}

/// Returns the polyhedra as a mesh without corners: points, arrays and fields.
StoredMesh DescribeCells(const MeshData& mesh, const DualMesh& dual)
{
  StoredMesh cells;
  MeshData& data = cells.Data;
  data.Points = dual.Points.data();
  data.NumberOfPoints = dual.NumberOfPoints();
  data.NumberOfElements = dual.NumberOfCells();
  data.Time = mesh.Time;
  data.Fields = mesh.Fields;
  const DualCells& parts = dual.Cells;
  data.Material = cells.Store(TakeValues(mesh.Material, parts.Tets));
  data.ElementArrays.push_back({ "MaterialId", ValueType::Int, 1, {}, data.Material });
  if (mesh.Fragment)
  {
    data.Fragment = cells.Store(TakeValues(mesh.Fragment, parts.Tets));
    data.ElementArrays.push_back({ "FragmentId", ValueType::Int, 1, {}, data.Fragment });
  }
  std::vector<Index> ids(parts.Nodes.size());
  std::iota(ids.begin(), ids.end(), Index(1));
  data.ElementArrays.push_back(
    { "GlobalCellIds", ValueType::Id, 1, {}, cells.Store(std::move(ids)) });
  data.ElementArrays.push_back(
    { "NodeId", ValueType::Id, 1, {}, cells.Store(TakeValues(mesh.PointIds, parts.Nodes)) });
  for (MeshArray& array : TakePointArrays(mesh, parts.Nodes, cells))
  {
    data.ElementArrays.push_back(std::move(array));
  }
  return cells;
}

/// The lists of corners and faces of VTK's polyhedra.
struct VtkPolyhedra
{
  std::vector<Index> Corners, CornerEnds;
  std::vector<Index>
    Faces; ///< of each cell: number of faces; of each face: number of points, points
  std::vector<Index> FaceEnds;
};

VtkPolyhedra ListPolyhedra(const DualMesh& dual)
{
  VtkPolyhedra lists;
  std::vector<Index> corners;
  for (const std::vector<CellFace>& faces : FacesOfCells(dual))
  {
    corners.clear();
    lists.Faces.push_back(static_cast<Index>(faces.size()));
    for (const CellFace& face : faces)
    {
      const std::span<const Index> points = dual.PointsOf(face.Face);
      lists.Faces.push_back(static_cast<Index>(points.size()));
      if (face.Sign < 0.0)
      {
        lists.Faces.insert(lists.Faces.end(), points.rbegin(), points.rend());
      }
      else
      {
        lists.Faces.insert(lists.Faces.end(), points.begin(), points.end());
      }
      corners.insert(corners.end(), points.begin(), points.end());
    }
    std::sort(corners.begin(), corners.end());
    lists.Corners.insert(
      lists.Corners.end(), corners.begin(), std::unique(corners.begin(), corners.end()));
    lists.CornerEnds.push_back(static_cast<Index>(lists.Corners.size()));
    lists.FaceEnds.push_back(static_cast<Index>(lists.Faces.size()));
  }
  return lists;
}

void AddIds(OutputFile& file, const char* name, const std::vector<Index>& ids)
{
  AddVtuArray(file, std::string("type=\"Int64\" Name=\"") + name + "\"",
    { reinterpret_cast<const char*>(ids.data()), sizeof(Index) * ids.size() });
}

} // namespace

void RequireDual(const MeshData& mesh)
{
  constexpr const char* need =
    "Polyhedra are made around the nodes of linear tetrahedra that share "
    "their nodes (tetrahedra of the method lattice): ";
  if (IsFlat(mesh))
  {
    throw InputError(std::string(need) + "this is a mesh of a plane (option Flat).");
  }
  if (mesh.HasHexes())
  {
    throw InputError(std::string(need) + "this mesh has hexahedra.");
  }
  if (mesh.MidsPerElement > 0)
  {
    throw InputError(std::string(need) + "this mesh is of second order.");
  }
  if (mesh.OriginalPointIds)
  {
    throw InputError(std::string(need) + "this mesh has split interfaces.");
  }
}

void WriteDualFoam(const MeshData& mesh, const std::string& folder, bool isBinary, OutputSet& files)
{
  if (mesh.PeriodicPartner)
  {
    throw InputError("Polyhedra of a periodic mesh are not written for OpenFOAM, because their "
                     "faces on opposite sides are not made in pairs. Write the tetrahedra, or a "
                     ".vtu file.");
  }
  Ranks alone;
  const FoamSurfaces surfaces = FindFoamSurfaces(mesh, alone);
  const DualMesh dual = MakeDualMesh(
    mesh, [&surfaces](const ElementSide& side) { return FindSurface(surfaces, side); });
  CheckLabels(dual);
  DualFoam foam;
  foam.Faces.resize(dual.NumberOfInnerFaces());
  std::iota(foam.Faces.begin(), foam.Faces.end(), Index(0));
  AddPatches(dual, surfaces, foam);
  AddCellZones(mesh, dual, alone, foam);
  AddFaceZones(dual, surfaces, foam);
  const auto addFaces = [&](FoamFile& file)
  {
    file.Polygons(
      dual.NumberOfFaces(), [&](Index face) { return dual.PointsOf(foam.Faces[face]); });
  };
  WritePolyMesh(
    { dual.Points.data(), dual.NumberOfPoints(), dual.NumberOfCells(), dual.NumberOfFaces(),
      addFaces, [&](Index face) { return dual.Owners[foam.Faces[face]]; }, dual.Neighbours,
      foam.Patches, foam.CellZones, foam.FaceZones },
    folder, isBinary, files);
}

void WriteDualVtu(const MeshData& mesh, const std::string& path, OutputSet& files)
{
  Ranks alone;
  const FoamSurfaces surfaces = FindFoamSurfaces(mesh, alone);
  const DualMesh dual = MakeDualMesh(
    mesh, [&surfaces](const ElementSide& side) { return FindSurface(surfaces, side); });
  const StoredMesh cells = DescribeCells(mesh, dual);
  OutputFile file(path, files);
  file.Add(VtuHead("UnstructuredGrid") + "<UnstructuredGrid>\n");
  AddVtuFields(file, cells.Data);
  file.Add("<Piece NumberOfPoints=\"" + std::to_string(dual.NumberOfPoints()) +
    "\" NumberOfCells=\"" + std::to_string(dual.NumberOfCells()) + "\">\n");
  AddVtuMesh(file, cells.Data);
  const VtkPolyhedra lists = ListPolyhedra(dual);
  file.Add("<Cells>\n");
  AddIds(file, "connectivity", lists.Corners);
  AddIds(file, "offsets", lists.CornerEnds);
  AddVtuArray(file, "type=\"UInt8\" Name=\"types\"",
    std::string(static_cast<std::size_t>(dual.NumberOfCells()), '\x2a')); // VTK_POLYHEDRON
  AddIds(file, "faces", lists.Faces);
  AddIds(file, "faceoffsets", lists.FaceEnds);
  file.Add("</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
  file.Close();
}

} // namespace vfm
