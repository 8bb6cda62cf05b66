#include "Meshes/Gmsh/WriteGmsh.h"

#include "Meshes/Files/ElementNodes.h"
#include "Meshes/Files/WriteWhole.h"
#include "Meshes/Gmsh/GmshFile.h"
#include "Meshes/Gmsh/GmshModel.h"
#include "Meshes/Gmsh/GmshPeriodic.h"
#include "Meshes/Particles/WriteParticles.h"
#include "Report/FlatData.h"
#include "Report/MeshFacets.h"

#include <iterator>
#include <limits>
#include <set>

namespace vfm
{
namespace
{

constexpr Index LargestInt = std::numeric_limits<std::int32_t>::max();
constexpr int NumberOfTags = 2; // of an element in version 2.2: group and entity

/// Numbers of types of elements in Gmsh.
int ElementType(const MeshData& mesh)
{
  if (IsFlat(mesh))
  {
    return mesh.Corners == 4 ? 3 : 2;
  }
  if (mesh.Corners == 4)
  {
    return mesh.MidsPerElement == 0 ? 4 : 11;
  }
  return mesh.MidsPerElement == 0 ? 5 : mesh.MidsPerElement == 12 ? 17 : 12;
}

int CohesiveType(int corners)
{
  return corners == 8 ? 5 : 6;
}

int FaceType(const MeshData& mesh)
{
  if (IsFlat(mesh))
  {
    return 1;
  }
  if (mesh.Corners == 4)
  {
    return mesh.MidsPerElement == 0 ? 2 : 9;
  }
  return mesh.MidsPerElement == 0 ? 3 : mesh.MidsPerElement == 12 ? 16 : 10;
}

/// Returns the nodes of elements in the order of Gmsh.
ElementNodes NodesFor(const MeshData& mesh)
{
  return ElementNodes(mesh,
    { { 0, 3, 8, 1, 9, 2, 10, 11, 4, 7, 5, 6 },
      { 0, 3, 8, 1, 9, 2, 10, 11, 4, 7, 5, 6, 16, 14, 12, 13, 15, 17, 18 }, { 0, 1, 2, 3, 5, 4 } });
}

Index LargestId(const Index* ids, Index count)
{
  return *std::max_element(ids, ids + count);
}

/// Returns the largest id of an element, also of cohesive elements, which follow the others.
Index LargestElementId(const GmshModel& model)
{
  const MeshData& mesh = model.Mesh;
  return LargestId(mesh.ElementIds, mesh.NumberOfElements) + CountElements(model.Cohesive);
}

/// Calls visit(id, points, volume, block) for each cohesive element.
template <class Visit>
void ForCohesive(const GmshModel& model, const Visit& visit)
{
  const int corners = CohesiveCorners(model.Mesh);
  int volume = model.FirstCohesiveVolume();
  for (const CohesiveBlock& block : model.Cohesive)
  {
    for (std::size_t e = 0; e < block.Ids.size(); ++e)
    {
      visit(block.Ids[e], block.Points.data() + corners * e, volume, block);
    }
    ++volume;
  }
}

/// Visits the faces of a surface with their ids.
class FaceIdCounter
{
public:
  explicit FaceIdCounter(const GmshModel& model) :
    TheMesh(model.Mesh), Next(LargestElementId(model) + 1)
  {
  }

  /// Calls visit(id, points, number of points) for each face.
  template <class Visit>
  void ForFaces(const SurfaceEntity& surface, const Visit& visit)
  {
    for (const ElementSide& side : surface.Sides)
    {
      const std::vector<Index> points = NodesOfSide(this->TheMesh, side.Element, side.Side);
      visit(this->Next++, points.data(), static_cast<int>(points.size()));
    }
  }

private:
  const MeshData& TheMesh;
  Index Next;
};

/// Calls visit(surface) for the index of each surface whose faces are in the file.
template <class Visit>
void ForSurfaces(const GmshModel& model, const Visit& visit)
{
  for (std::size_t s = 0; s < model.Entities.Surfaces.size(); ++s)
  {
    if (model.HasFaces(s))
    {
      visit(s);
    }
  }
}

void WriteHeader(GmshFile& file, const char* version, bool isBinary)
{
  file.Begin("MeshFormat");
  file.Line(std::string(version) + (isBinary ? " 1 8" : " 0 8"));
  if (isBinary)
  {
    file.Int(1);
    file.Line("");
  }
  file.Line("$EndMeshFormat");
}

/// Returns the groups that have elements. In version 2.2 a face is only in the first of its groups.
std::vector<GmshGroup> ListGroups(const GmshModel& model, GmshVersion version)
{
  std::set<int> used;
  for (const std::vector<int>& tags : model.SurfaceGroups)
  {
    const bool hasOne = version == GmshVersion::V2_2 && !tags.empty();
    used.insert(tags.begin(), hasOne ? tags.begin() + 1 : tags.end());
  }
  const int highest = DimensionOfElements(model.Mesh);
  std::vector<GmshGroup> groups;
  std::copy_if(model.Groups.begin(), model.Groups.end(), std::back_inserter(groups),
    [&used, highest](const GmshGroup& group)
    { return group.Dimension == highest || used.count(group.Tag) > 0; });
  return groups;
}

void WriteGroups(GmshFile& file, const std::vector<GmshGroup>& groups)
{
  file.Begin("PhysicalNames");
  file.Line(std::to_string(groups.size()));
  for (const GmshGroup& group : groups)
  {
    file.Line(std::to_string(group.Dimension) + " " + std::to_string(group.Tag) + " \"" +
      group.Name + "\"");
  }
  file.Line("$EndPhysicalNames");
}

void WritePoint(GmshFile& file, const double* point)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    file.Real(point[axis]);
  }
}

// Version 2.2.

void WriteNodes2(GmshFile& file, const MeshData& mesh)
{
  file.Begin("Nodes");
  file.Line(std::to_string(mesh.NumberOfPoints));
  for (Index point = 0; point < mesh.NumberOfPoints; ++point)
  {
    file.Int(mesh.PointIds[point]);
    WritePoint(file, mesh.Point(point));
    file.EndLine();
  }
  file.End("Nodes");
}

/// Writes elements of one type in version 2.2. A binary file has one header for all of them.
class ElementWriter2
{
public:
  ElementWriter2(GmshFile& file, const MeshData& mesh, int type, Index count, bool isBinary) :
    File(file), TheMesh(mesh), Type(type), IsBinary(isBinary)
  {
    if (isBinary && count > 0)
    {
      file.Int(type);
      file.Int(count);
      file.Int(NumberOfTags);
    }
  }

  void Write(Index id, int group, int entity, const Index* points, int corners)
  {
    this->File.Int(id);
    if (!this->IsBinary)
    {
      this->File.Int(this->Type);
      this->File.Int(NumberOfTags);
    }
    this->File.Int(group);
    this->File.Int(entity);
    for (int c = 0; c < corners; ++c)
    {
      this->File.Int(this->TheMesh.PointIds[points[c]]);
    }
    this->File.EndLine();
  }

private:
  GmshFile& File;
  const MeshData& TheMesh;
  const int Type;
  const bool IsBinary;
};

void WriteElements2(GmshFile& file, const GmshModel& model, bool isBinary)
{
  const MeshData& mesh = model.Mesh;
  file.Begin("Elements");
  file.Line(
    std::to_string(model.NumberOfFaces + mesh.NumberOfElements + CountElements(model.Cohesive)));
  ElementWriter2 faces(file, mesh, FaceType(mesh), model.NumberOfFaces, isBinary);
  FaceIdCounter ids(model);
  ForSurfaces(model,
    [&](std::size_t s)
    {
      ids.ForFaces(model.Entities.Surfaces[s],
        [&](Index id, const Index* points, int corners) {
          faces.Write(id, model.SurfaceGroups[s].front(), static_cast<int>(s) + 1, points, corners);
        });
    });
  ElementWriter2 elements(file, mesh, ElementType(mesh), mesh.NumberOfElements, isBinary);
  ElementNodes nodes = NodesFor(mesh);
  for (Index element = 0; element < mesh.NumberOfElements; ++element)
  {
    const int volume = model.Entities.Volumes[element];
    elements.Write(mesh.ElementIds[element], model.Volumes.at(volume).Group, volume,
      nodes.Of(element), nodes.Count());
  }
  ElementWriter2 cohesive(
    file, mesh, CohesiveType(mesh.Corners), CountElements(model.Cohesive), isBinary);
  ForCohesive(model,
    [&](Index id, const Index* points, int volume, const CohesiveBlock& block)
    { cohesive.Write(id, block.Id, volume, points, CohesiveCorners(mesh)); });
  file.End("Elements");
}

// Version 4.1.

/// Bounding box of points.
class BoundingBox
{
public:
  explicit BoundingBox(const MeshData& mesh) : TheMesh(mesh) {}

  void Add(const Index* points, int count)
  {
    for (int p = 0; p < count; ++p)
    {
      const double* x = this->TheMesh.Point(points[p]);
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Low[axis] = std::min(this->Low[axis], x[axis]);
        this->High[axis] = std::max(this->High[axis], x[axis]);
      }
    }
  }

  void Write(GmshFile& file) const
  {
    WritePoint(file, this->Low.data());
    WritePoint(file, this->High.data());
  }

private:
  static constexpr double Infinity = std::numeric_limits<double>::infinity();
  const MeshData& TheMesh;
  std::array<double, 3> Low{ { Infinity, Infinity, Infinity } };
  std::array<double, 3> High{ { -Infinity, -Infinity, -Infinity } };
};

void WriteTags(GmshFile& file, const std::vector<int>& tags)
{
  file.Size(static_cast<Index>(tags.size()));
  for (int tag : tags)
  {
    file.Int(tag);
  }
}

/// Writes an entity of dimension 1 to 3.
void WriteEntity(GmshFile& file, int tag, const BoundingBox& box, const std::vector<int>& groups,
  const std::vector<int>& bounds)
{
  file.Int(tag);
  box.Write(file);
  WriteTags(file, groups);
  WriteTags(file, bounds);
  file.EndLine();
}

void WriteVertices(GmshFile& file, const GmshModel& model)
{
  int tag = 0;
  for (Index point : model.Entities.Vertices)
  {
    file.Int(++tag);
    WritePoint(file, model.Mesh.Point(point));
    WriteTags(file, {});
    file.EndLine();
  }
}

void WriteCurves(GmshFile& file, const GmshModel& model)
{
  int tag = 0;
  for (const CurveEntity& curve : model.Entities.Curves)
  {
    BoundingBox box(model.Mesh);
    for (const std::array<Index, 2>& edge : curve.Edges)
    {
      box.Add(edge.data(), 2);
    }
    WriteEntity(file, ++tag, box, {}, curve.Vertices);
  }
}

void WriteSurfaces(GmshFile& file, const GmshModel& model)
{
  const MeshEntities& entities = model.Entities;
  std::vector<std::vector<int>> curves(entities.Surfaces.size());
  for (std::size_t c = 0; c < entities.Curves.size(); ++c)
  {
    for (int surface : entities.Curves[c].Surfaces)
    {
      curves[surface - 1].push_back(static_cast<int>(c) + 1);
    }
  }
  FaceIdCounter ids(model);
  for (std::size_t s = 0; s < entities.Surfaces.size(); ++s)
  {
    BoundingBox box(model.Mesh);
    ids.ForFaces(entities.Surfaces[s],
      [&box](Index, const Index* points, int corners) { box.Add(points, corners); });
    WriteEntity(file, static_cast<int>(s) + 1, box, model.SurfaceGroups[s], curves[s]);
  }
}

/// Writes the volumes. A surface has a negative tag where its normal points into the volume.
void WriteVolumes(GmshFile& file, const GmshModel& model)
{
  std::map<int, std::vector<int>> surfaces;
  for (std::size_t s = 0; s < model.Entities.Surfaces.size(); ++s)
  {
    const std::array<int, 2>& volumes = model.Entities.Surfaces[s].Volumes;
    surfaces[volumes[0]].push_back(static_cast<int>(s) + 1);
    surfaces[volumes[1]].push_back(-static_cast<int>(s) - 1);
  }
  for (const auto& [tag, volume] : model.Volumes)
  {
    BoundingBox box(model.Mesh);
    for (Index element : volume.Elements)
    {
      model.Mesh.ForNodes(element,
        [&box](const Index* first, const Index* last)
        { box.Add(first, static_cast<int>(last - first)); });
    }
    WriteEntity(file, tag, box, { volume.Group }, surfaces[tag]);
  }
  int tag = model.FirstCohesiveVolume();
  for (const CohesiveBlock& block : model.Cohesive)
  {
    BoundingBox box(model.Mesh);
    box.Add(block.Points.data(), static_cast<int>(block.Points.size()));
    WriteEntity(file, tag++, box, { block.Id }, {});
  }
}

void WriteEntities(GmshFile& file, const GmshModel& model)
{
  const MeshEntities& entities = model.Entities;
  std::vector<std::size_t> counts{ entities.Vertices.size(), entities.Curves.size(),
    entities.Surfaces.size(), model.Volumes.size() + model.Cohesive.size() };
  if (IsFlat(model.Mesh))
  {
    counts = { 0, entities.Surfaces.size(), model.Volumes.size(), 0 };
  }
  file.Begin("Entities");
  for (std::size_t count : counts)
  {
    file.Size(static_cast<Index>(count));
  }
  file.EndLine();
  WriteVertices(file, model);
  WriteCurves(file, model);
  WriteSurfaces(file, model);
  WriteVolumes(file, model);
  file.End("Entities");
}

/// Writes the line with the number of blocks and of items and the range of ids.
void WriteTotals(GmshFile& file, std::size_t blocks, Index items, Index first, Index last)
{
  file.Size(static_cast<Index>(blocks));
  file.Size(items);
  file.Size(first);
  file.Size(last);
  file.EndLine();
}

void WriteBlock(GmshFile& file, int dimension, int tag, int type, std::size_t count)
{
  file.Int(dimension);
  file.Int(tag);
  file.Int(type);
  file.Size(static_cast<Index>(count));
  file.EndLine();
}

void WriteNodes4(GmshFile& file, const GmshModel& model)
{
  const MeshData& mesh = model.Mesh;
  std::map<std::array<int, 2>, std::vector<Index>> blocks; // points by dimension and entity
  for (Index point = 0; point < mesh.NumberOfPoints; ++point)
  {
    const MeshEntities& entities = model.Entities;
    const int dimension = entities.PointDimension[point] - (IsFlat(mesh) ? 1 : 0);
    blocks[{ { dimension, entities.PointEntity[point] } }].push_back(point);
  }
  file.Begin("Nodes");
  WriteTotals(file, blocks.size(), mesh.NumberOfPoints, mesh.PointIds[0],
    LargestId(mesh.PointIds, mesh.NumberOfPoints));
  for (const auto& [entity, points] : blocks)
  {
    WriteBlock(file, entity[0], entity[1], 0, points.size());
    for (Index point : points)
    {
      file.Size(mesh.PointIds[point]);
      file.EndLine();
    }
    for (Index point : points)
    {
      WritePoint(file, mesh.Point(point));
      file.EndLine();
    }
  }
  file.End("Nodes");
}

void WriteElement4(GmshFile& file, const MeshData& mesh, Index id, const Index* points, int corners)
{
  file.Size(id);
  for (int c = 0; c < corners; ++c)
  {
    file.Size(mesh.PointIds[points[c]]);
  }
  file.EndLine();
}

void WriteElements4(GmshFile& file, const GmshModel& model)
{
  const MeshData& mesh = model.Mesh;
  file.Begin("Elements");
  std::size_t blocks = model.Volumes.size() + model.Cohesive.size();
  ForSurfaces(model, [&blocks](std::size_t) { ++blocks; });
  WriteTotals(file, blocks,
    model.NumberOfFaces + mesh.NumberOfElements + CountElements(model.Cohesive), mesh.ElementIds[0],
    LargestElementId(model) + model.NumberOfFaces);
  const int dimension = DimensionOfElements(mesh);
  FaceIdCounter ids(model);
  ForSurfaces(model,
    [&](std::size_t s)
    {
      const SurfaceEntity& surface = model.Entities.Surfaces[s];
      WriteBlock(
        file, dimension - 1, static_cast<int>(s) + 1, FaceType(mesh), surface.Sides.size());
      ids.ForFaces(surface,
        [&](Index id, const Index* points, int corners)
        { WriteElement4(file, mesh, id, points, corners); });
    });
  ElementNodes nodes = NodesFor(mesh);
  for (const auto& [tag, volume] : model.Volumes)
  {
    WriteBlock(file, dimension, tag, ElementType(mesh), volume.Elements.size());
    for (Index element : volume.Elements)
    {
      WriteElement4(file, mesh, mesh.ElementIds[element], nodes.Of(element), nodes.Count());
    }
  }
  ForCohesive(model,
    [&](Index id, const Index* points, int volume, const CohesiveBlock& block)
    {
      if (id == block.Ids.front())
      {
        WriteBlock(file, 3, volume, CohesiveType(mesh.Corners), block.Ids.size());
      }
      WriteElement4(file, mesh, id, points, CohesiveCorners(mesh));
    });
  file.End("Elements");
}

/// Returns the version to write. Version 2.2 has ids of 32 bits.
GmshVersion ChooseVersion(const GmshModel& model, GmshVersion version)
{
  const MeshData& mesh = model.Mesh;
  const Index largest = std::max(
    LargestId(mesh.PointIds, mesh.NumberOfPoints), LargestElementId(model) + model.NumberOfFaces);
  if (version == GmshVersion::V2_2 && largest > LargestInt)
  {
    throw InputError("The id " + std::to_string(largest) +
      " exceeds 2147483647, the largest one in version 2.2 of Gmsh's format. Write version 4.1.");
  }
  const bool fits = largest <= LargestInt && version != GmshVersion::V4_1;
  return fits ? GmshVersion::V2_2 : GmshVersion::V4_1;
}

void WriteFile(MeshData mesh, const std::string& path, const GmshForm& form)
{
  Ranks alone;
  const std::vector<MeshFacet> facets = FindMeshFacets(mesh, alone);
  mesh.Facets = &facets;
  const GmshModel model = MakeGmshModel(mesh, form.HasInterfaces);
  const GmshVersion version = ChooseVersion(model, form.Version);
  OutputSet files(path);
  GmshFile file(path, form.IsBinary, files);
  WriteHeader(file, version == GmshVersion::V2_2 ? "2.2" : "4.1", form.IsBinary);
  WriteGroups(file, ListGroups(model, version));
  if (version == GmshVersion::V2_2)
  {
    WriteNodes2(file, mesh);
    WriteElements2(file, model, form.IsBinary);
  }
  else
  {
    WriteEntities(file, model);
    WriteNodes4(file, model);
    WriteElements4(file, model);
    WriteLinks(file, mesh, FindGmshLinks(model));
  }
  file.Close();
  WriteParticlesBeside(mesh, path, files);
  files.Rename();
}

} // namespace

std::optional<GmshVersion> ParseGmshVersion(const std::string& name)
{
  if (name == "2.2")
  {
    return GmshVersion::V2_2;
  }
  return name == "4.1" ? std::optional<GmshVersion>(GmshVersion::V4_1) : std::nullopt;
}

void WriteGmsh(const MeshData& mesh, const std::string& path, Ranks& ranks, const GmshForm& form)
{
  WriteWhole(mesh, ranks, [&](const MeshData& whole) { WriteFile(whole, path, form); });
}

} // namespace vfm
