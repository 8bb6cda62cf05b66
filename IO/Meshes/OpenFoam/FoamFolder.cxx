#include "Meshes/OpenFoam/FoamFolder.h"

#include "Meshes/OpenFoam/FoamFile.h"
#include "Meshes/OpenFoam/FoamLayer.h"

#include <filesystem>

namespace vfm
{
namespace
{

constexpr const char* MeshFolder = "constant/polyMesh";

/// Writes the files of a polyMesh.
class PolyMeshWriter
{
public:
  PolyMeshWriter(
    const FoamLists& lists, const std::string& folder, bool isBinary, OutputSet& files) :
    Lists(lists), Folder(folder), IsBinary(isBinary), Files(files)
  {
  }

  void WriteMesh() const;
  void WriteAddressing(const FoamAddressing& addressing) const;

private:
  template <class Write>
  void WriteFile(const std::string& name, const std::string& type, const Write& write,
    const std::string& note = "") const;
  void WriteLabels(const std::string& name, const std::vector<Index>& labels) const;
  void WriteOwners() const;
  void WriteBoundary() const;
  void WriteZones(const std::string& name, const std::string& type, const std::string& entry,
    const std::vector<FoamZone>& zones) const;

  const FoamLists& Lists;
  const std::string& Folder;
  const bool IsBinary;
  OutputSet& Files;
};

/// Writes a file by write(file).
template <class Write>
void PolyMeshWriter::WriteFile(const std::string& name, const std::string& type, const Write& write,
  const std::string& note) const
{
  FoamFile file(this->Folder, { type, MeshFolder, name, note }, this->IsBinary, this->Files);
  write(file);
  file.Close();
}

void PolyMeshWriter::WriteLabels(const std::string& name, const std::vector<Index>& labels) const
{
  this->WriteFile(name, "labelList",
    [&labels](FoamFile& file)
    { file.Labels(static_cast<Index>(labels.size()), [&labels](Index i) { return labels[i]; }); });
}

void PolyMeshWriter::WriteOwners() const
{
  const Index faces = this->Lists.NumberOfFaces;
  const std::string note = "nPoints:" + std::to_string(this->Lists.NumberOfPoints) +
    "  nCells:" + std::to_string(this->Lists.NumberOfCells) + "  nFaces:" + std::to_string(faces) +
    "  nInternalFaces:" + std::to_string(this->Lists.Neighbours.size());
  this->WriteFile(
    "owner", "labelList", [&](FoamFile& file) { file.Labels(faces, this->Lists.OwnerOf); }, note);
  this->WriteFile(
    "neighbour", "labelList",
    [&](FoamFile& file)
    {
      file.Labels(static_cast<Index>(this->Lists.Neighbours.size()),
        [this](Index face) { return this->Lists.Neighbours[face]; });
    },
    note);
}

std::string DescribeGroups(const FoamPatch& patch)
{
  std::string groups = patch.Type == "patch" ? "" : patch.Type;
  groups += patch.Group.empty() ? "" : " " + patch.Group;
  return groups.empty() ? "" : "        inGroups        (" + groups + ");\n";
}

void PolyMeshWriter::WriteBoundary() const
{
  this->WriteFile("boundary", "polyBoundaryMesh",
    [this](FoamFile& file)
    {
      file.Text(std::to_string(this->Lists.Patches.size()) + "\n(\n");
      Index first = static_cast<Index>(this->Lists.Neighbours.size());
      for (const FoamPatch& patch : this->Lists.Patches)
      {
        file.Text("    " + patch.Name + "\n    {\n        type            " + patch.Type + ";\n" +
          DescribeGroups(patch) + "        nFaces          " + std::to_string(patch.Count) +
          ";\n        startFace       " + std::to_string(first) + ";\n");
        if (!patch.Opposite.empty())
        {
          file.Text(
            "        matchTolerance  0.0001;\n        neighbourPatch  " + patch.Opposite + ";\n");
        }
        if (patch.Neighbour >= 0)
        {
          file.Text("        matchTolerance  0.0001;\n        myProcNo        " +
            std::to_string(this->Lists.Rank) + ";\n        neighbProcNo    " +
            std::to_string(patch.Neighbour) + ";\n" +
            (patch.Refer.empty() ? "" : "        referPatch      " + patch.Refer + ";\n"));
        }
        file.Text("    }\n");
        first += patch.Count;
      }
      file.Text(")\n");
    });
}

/// @param type  of a zone, such as "cellZone"
/// @param entry  name of the list of its members
void PolyMeshWriter::WriteZones(const std::string& name, const std::string& type,
  const std::string& entry, const std::vector<FoamZone>& zones) const
{
  this->WriteFile(name, "regIOobject",
    [&](FoamFile& file)
    {
      file.Text(std::to_string(zones.size()) + "\n(\n");
      for (const FoamZone& zone : zones)
      {
        file.Text(zone.Name + "\n{\n    type " + type + ";\n    " + entry + " List<label>\n");
        file.Labels(
          static_cast<Index>(zone.Members.size()), [&zone](Index i) { return zone.Members[i]; });
        file.Text(";\n");
        if (type == "faceZone")
        {
          file.Text("    flipMap List<bool>\n");
          file.Flags(static_cast<Index>(zone.IsFlipped.size()),
            [&zone](Index i) { return zone.IsFlipped[i]; });
          file.Text(";\n");
        }
        file.Text("}\n");
      }
      file.Text(")\n");
    });
}

void PolyMeshWriter::WriteMesh() const
{
  this->WriteFile("points", "vectorField",
    [this](FoamFile& file) { file.Points(this->Lists.Points, this->Lists.NumberOfPoints); });
  this->WriteFile("faces", this->IsBinary ? "faceCompactList" : "faceList", this->Lists.AddFaces);
  this->WriteOwners();
  this->WriteBoundary();
  this->WriteZones("cellZones", "cellZone", "cellLabels", this->Lists.CellZones);
  this->WriteZones("faceZones", "faceZone", "faceLabels", this->Lists.FaceZones);
  this->WriteZones("pointZones", "pointZone", "pointLabels", {});
}

void PolyMeshWriter::WriteAddressing(const FoamAddressing& addressing) const
{
  this->WriteLabels("pointProcAddressing", addressing.Points);
  this->WriteLabels("faceProcAddressing", addressing.Faces);
  this->WriteLabels("cellProcAddressing", addressing.Cells);
  this->WriteLabels("boundaryProcAddressing", addressing.Patches);
}

/// A dictionary in the folder system.
struct Dictionary
{
  std::string Name, Text;
};

/// @param ranks  number of meshes of the case
std::vector<Dictionary> ListDictionaries(int ranks)
{
  std::vector<Dictionary> list{
    { "controlDict",
      "startFrom       startTime;\nstartTime       0;\nstopAt          endTime;\n"
      "endTime         1;\ndeltaT          1;\nwriteControl    timeStep;\nwriteInterval   1;\n"
      "writePrecision  12;\n" },
    { "fvSchemes",
      "ddtSchemes { default steadyState; }\ngradSchemes { default Gauss linear; }\n"
      "divSchemes { default none; }\nlaplacianSchemes { default Gauss linear corrected; }\n"
      "interpolationSchemes { default linear; }\nsnGradSchemes { default corrected; }\n" },
    { "fvSolution", "solvers {}\n" },
  };
  if (ranks > 1)
  {
    list.push_back({ "decomposeParDict",
      "numberOfSubdomains " + std::to_string(ranks) + ";\nmethod scotch;\n" });
  }
  return list;
}

} // namespace

void WritePolyMesh(
  const FoamLists& lists, const std::string& folder, bool isBinary, OutputSet& files)
{
  files.MakeFolder(folder);
  files.MakeFolder(folder + "/constant");
  files.MakeFolder(folder + "/" + MeshFolder);
  PolyMeshWriter(lists, folder, isBinary, files).WriteMesh();
}

void WritePolyMesh(const FoamMesh& foam, const FoamAddressing* addressing,
  const std::string& folder, bool isBinary, OutputSet& files)
{
  const MeshData& mesh = foam.Mesh;
  const bool isFlat = IsFlat(mesh);
  const std::vector<double> ofLayer = isFlat ? PointsOfLayer(mesh) : std::vector<double>();
  const auto addFaces = [&](FoamFile& file)
  {
    if (isFlat)
    {
      file.Polygons(
        foam.NumberOfFaces(), [&](Index face) { return PointsOfLayerFace(foam, face); });
      return;
    }
    file.Faces(foam.NumberOfSides(), CornersOfSide(mesh),
      [&](Index face) { return PointsOfSide(mesh, foam.Sides[face]); });
  };
  const FoamLists lists{ isFlat ? ofLayer.data() : mesh.Points,
    (isFlat ? 2 : 1) * mesh.NumberOfPoints, mesh.NumberOfElements, foam.NumberOfFaces(), addFaces,
    [&foam](Index face) { return foam.Owner(face); }, foam.Neighbours, foam.Patches, foam.CellZones,
    foam.FaceZones, foam.Rank };
  WritePolyMesh(lists, folder, isBinary, files);
  if (addressing)
  {
    PolyMeshWriter(lists, folder, isBinary, files).WriteAddressing(*addressing);
  }
}

void WriteCaseFiles(const std::string& folder, const std::string& path, int ranks, OutputSet& files)
{
  files.MakeFolder(folder + "/system");
  for (const Dictionary& dictionary : ListDictionaries(ranks))
  {
    const std::string name = folder + "/system/" + dictionary.Name;
    if (!std::filesystem::exists(name))
    {
      FoamFile file(folder, { "dictionary", "system", dictionary.Name, "" }, false, files);
      file.Text(dictionary.Text);
      file.Close();
    }
  }
  OutputFile stub(path, files);
  stub.Close();
}

} // namespace vfm
