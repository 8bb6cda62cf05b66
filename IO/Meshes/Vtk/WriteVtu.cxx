#include "Meshes/Vtk/WriteVtu.h"

#include "Meshes/Files/OutputFile.h"
#include "Meshes/Files/WriteWhole.h"
#include "Meshes/Particles/GatherParticles.h"
#include "Meshes/Particles/WriteParticles.h"
#include "Meshes/Polyhedra/WriteDual.h"
#include "Meshes/Vtk/VtuText.h"
#include "Ranks/Agreement.h"
#include "Report/FlatData.h"
#include "Report/FragmentTargets.h"
#include "Report/Gather/GatherMesh.h"

#include <exception>
#include <filesystem>

namespace vfm
{
namespace
{

/// @param whole  nothing, or the mesh with the hexes that it leaves out
template <class... Whole>
void WritePiece(const MeshData& mesh, Index points, Index elements, const std::string& path,
  OutputSet& files, const Whole&... whole)
{
  OutputFile file(path, files);
  file.Add(VtuHead("UnstructuredGrid") + "<UnstructuredGrid>\n");
  AddVtuFields(file, mesh);
  file.Add("<Piece NumberOfPoints=\"" + std::to_string(points) + "\" NumberOfCells=\"" +
    std::to_string(elements) + "\">\n");
  AddVtuMesh(file, mesh, whole...);
  file.Add("<Cells>\n");
  AddVtuElements(file, mesh, whole...);
  AddVtuArray(file, "type=\"UInt8\" Name=\"types\"", static_cast<std::size_t>(elements),
    [&](const AddBytes& add)
    {
      const std::string type(1, static_cast<char>(ShapeOf(mesh).VtkType));
      for (Index element = 0; element < elements; ++element)
      {
        add(type);
      }
    });
  file.Add("</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
  file.Close();
}

void WritePiece(const MeshData& mesh, const std::string& path, OutputSet& files)
{
  WritePiece(mesh, mesh.NumberOfPoints, mesh.NumberOfElements, path, files);
}

void AddArrayList(OutputFile& file, const char* element, const std::vector<MeshArray>& arrays)
{
  file.Add(std::string("<") + element + DescribeVtuRoles(arrays) + ">\n");
  for (const MeshArray& array : arrays)
  {
    file.Add("<PDataArray " + DescribeVtuArray(array) + "/>\n");
  }
  file.Add(std::string("</") + element + ">\n");
}

/// Writes the file that lists the pieces with elements.
void WriteSummary(const MeshData& mesh, const std::string& path,
  const std::vector<std::string>& pieces, const std::vector<char>& isFilled, OutputSet& files)
{
  OutputFile file(path, files);
  file.Add(VtuHead("PUnstructuredGrid") + "<PUnstructuredGrid GhostLevel=\"0\">\n");
  MeshData head = mesh;
  std::erase_if(head.Fields, [](const FieldArray& field) { return IsFieldOfRank(field.Name); });
  AddVtuFields(file, head);
  AddArrayList(file, "PPointData", mesh.PointArrays);
  AddArrayList(file, "PCellData", mesh.ElementArrays);
  file.Add(std::string("<PPoints>\n<PDataArray ") + VtuPointAttributes + "/>\n</PPoints>\n");
  for (std::size_t rank = 0; rank < pieces.size(); ++rank)
  {
    file.Add(isFilled[rank] ? "<Piece Source=\"" + XmlText(pieces[rank]) + "\"/>\n" : "");
  }
  file.Add("</PUnstructuredGrid>\n</VTKFile>\n");
  file.Close();
}

/// Calls write() on all ranks. What it throws on a rank is thrown there after all have called it:
/// the rank that made their common folder removes it then, while no other rank writes into it.
/// @pre Collective
template <class Write>
void WriteOnAll(Ranks& ranks, const Write& write)
{
  std::exception_ptr problem;
  try
  {
    write();
  }
  catch (...)
  {
    problem = std::current_exception();
  }
  ranks.Any(problem != nullptr); // waits for all
  if (problem)
  {
    std::rethrow_exception(problem);
  }
}

} // namespace

void WriteVtu(const MeshData& mesh, const std::string& path, Ranks& ranks)
{
  StoredMesh whole = GatherMesh(mesh, ranks);
  const std::shared_ptr<const ParticleData> particles = GatherParticles(mesh.Particles, ranks);
  whole.Data.Particles = particles.get();
  WorkTogether(ranks,
    [&]
    {
      if (ranks.Rank() == 0)
      {
        OutputSet files(path);
        WritePiece(whole.Data, path, files);
        WriteParticlesBeside(whole.Data, path, files);
        files.Rename();
      }
    });
}

void WriteVtu(const MeshData& mesh, const MeshWithRuns& whole, const std::string& path)
{
  OutputSet files(path);
  WritePiece(mesh, whole.NumberOfPoints(), whole.NumberOfElements(), path, files, whole);
  files.Rename();
}

void WritePolyhedra(const MeshData& mesh, const std::string& path, Ranks& ranks)
{
  WriteWhole(
    mesh, ranks,
    [&path](const MeshData& whole)
    {
      RequireDual(whole);
      OutputSet files(path);
      WriteDualVtu(whole, path, files);
      WriteParticlesBeside(whole, path, files);
      files.Rename();
    },
    [](const MeshArray&) { return true; });
}

void WritePvtu(const MeshData& mesh, const std::string& path, Ranks& ranks)
{
  const bool isEmpty = !ranks.Any(mesh.NumberOfElements > 0);
  MeshData part = isEmpty ? mesh : ShareHead(mesh, ranks);
  const std::shared_ptr<const ParticleData> particles = GatherParticles(mesh.Particles, ranks);
  part.Particles = particles.get();
  const std::vector<char> isFilled =
    GatherItems(ranks, std::vector<char>{ static_cast<char>(part.NumberOfElements > 0) });
  const std::filesystem::path folder = std::filesystem::path(path).replace_extension();
  const std::string name = folder.filename().string();
  std::vector<std::string> pieces;
  for (int rank = 0; rank < ranks.Count(); ++rank)
  {
    pieces.push_back(name + "/" + name + "_" + std::to_string(rank) + ".vtu");
  }
  OutputSet files(path);
  WorkTogether(ranks,
    [&]
    {
      WriteOnAll(ranks,
        [&]
        {
          if (isFilled[ranks.Rank()])
          {
            files.MakeFolder(folder);
            WritePiece(part, (folder.parent_path() / pieces[ranks.Rank()]).string(), files);
          }
          if (ranks.Rank() == 0)
          {
            WriteSummary(part, path, pieces, isFilled, files);
            WriteParticlesBeside(part, path, files);
          }
        });
      files.Rename(ranks);
    });
}

} // namespace vfm
