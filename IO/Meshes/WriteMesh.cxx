#include "Meshes/WriteMesh.h"

#include "Meshes/Decks/WriteAbaqus.h"
#include "Meshes/Decks/WriteFebio.h"
#include "Meshes/Decks/WriteLsDyna.h"
#include "Meshes/Decks/WriteNastran.h"
#include "Meshes/Decks/WriteRadioss.h"
#include "Meshes/Exodus/WriteExodus.h"
#include "Meshes/OpenFoam/WriteFoam.h"
#include "Meshes/Particles/WriteParticles.h"
#include "Meshes/Surfaces/WriteObj.h"
#include "Meshes/Surfaces/WriteStl.h"
#include "Meshes/Vtk/WriteVtu.h"
#include "Meshes/Xdmf/WriteXdmf.h"
#include "Ranks/WorkTogether.h"
#include "Report/FlatData.h"

#include <cerrno>
#include <cstring>
#include <unistd.h>

namespace vfm
{
namespace
{

/// @pre Collective
void Write(MeshFormat format, const MeshData& mesh, const std::string& path, Ranks& ranks,
  const OutputForm& form)
{
  switch (format)
  {
    case MeshFormat::Vtu:
      return form.IsDual ? WritePolyhedra(mesh, path, ranks) : WriteVtu(mesh, path, ranks);
    case MeshFormat::Pvtu:
      return WritePvtu(mesh, path, ranks);
    case MeshFormat::Exodus:
      return WriteExodus(
        mesh, path, ranks, form.IsSingle ? ExodusParts::One : ExodusParts::OnePerRank);
    case MeshFormat::Abaqus:
      return WriteAbaqus(mesh, path, ranks, { form.IsReduced, form.IsPlaneStress });
    case MeshFormat::LsDyna:
      return WriteLsDyna(mesh, path, ranks, form.IsPlaneStress);
    case MeshFormat::Radioss:
      return WriteRadioss(mesh, path, ranks);
    case MeshFormat::Nastran:
      return WriteNastran(mesh, path, ranks, form.IsPlaneStress);
    case MeshFormat::Febio:
      return WriteFebio(mesh, path, ranks);
    case MeshFormat::Gmsh:
      return WriteGmsh(mesh, path, ranks, { form.Version, form.IsBinary, form.HasInterfaces });
    case MeshFormat::Xdmf:
      return WriteXdmf(mesh, path, ranks);
    case MeshFormat::Foam:
      return WriteFoam(mesh, path, ranks, { form.IsSingle, form.IsBinary, form.IsDual });
    case MeshFormat::Stl:
      return WriteStl(mesh, path, ranks);
    case MeshFormat::Obj:
      return WriteObj(mesh, path, ranks);
    case MeshFormat::Vtp:
      return WriteVtpParticles(mesh, path, ranks);
    case MeshFormat::Lammps:
      return WriteLammps(mesh, path, ranks);
  }
}

bool HoldsPlanes(MeshFormat format)
{
  switch (format)
  {
    case MeshFormat::Vtu:
    case MeshFormat::Pvtu:
    case MeshFormat::Exodus:
    case MeshFormat::Abaqus:
    case MeshFormat::LsDyna:
    case MeshFormat::Radioss:
    case MeshFormat::Nastran:
    case MeshFormat::Gmsh:
    case MeshFormat::Xdmf:
    case MeshFormat::Foam:
      return true;
    default:
      return false;
  }
}

void RequirePlanes(const MeshData& mesh, MeshFormat format)
{
  if (IsFlat(mesh) && !HoldsPlanes(format))
  {
    std::string suffixes;
    for (const FormatRow& row : GetFormatTable())
    {
      suffixes += HoldsPlanes(row.Format) ? (suffixes.empty() ? "" : ", ") + row.Suffixes[0] : "";
    }
    throw InputError("This format is not written for meshes of a plane (option Flat). Formats that "
                     "are: " +
      suffixes + ". Without Flat the layer has solid elements.");
  }
}

bool HoldsParticles(MeshFormat format)
{
  switch (format)
  {
    case MeshFormat::Vtu:
    case MeshFormat::Pvtu:
    case MeshFormat::Febio:
    case MeshFormat::Gmsh:
    case MeshFormat::Xdmf:
    case MeshFormat::Stl:
    case MeshFormat::Obj:
      return false;
    default:
      return true;
  }
}

} // namespace

std::string FindFolderProblem(const std::string& path)
{
  const std::size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  return access(folder.c_str(), W_OK | X_OK) == 0
    ? ""
    : "Cannot write the output " + path + ": " + std::strerror(errno) + ".";
}

std::string FindParticlesBeside(const std::string& path)
{
  const FormatRow* format = FindMeshFormat(path);
  return format && !HoldsParticles(format->Format) ? PathOfParticles(path) : "";
}

bool TakesRuns(const std::string& path)
{
  const FormatRow* format = FindMeshFormat(path);
  return format && (format->Format == MeshFormat::Vtu || format->Format == MeshFormat::Exodus);
}

void WriteMesh(const MeshData& mesh, const MeshWithRuns& whole, const std::string& path)
{
  const std::string problem = FindFolderProblem(path);
  if (!problem.empty())
  {
    throw InputError(problem);
  }
  PrefixErrors("Cannot write the output " + path + ": ",
    [&]
    {
      FindMeshFormat(path)->Format == MeshFormat::Vtu ? WriteVtu(mesh, whole, path)
                                                      : WriteExodus(mesh, whole, path);
    });
}

void WriteMesh(const MeshData& mesh, const std::string& path, Ranks& ranks, const OutputForm& form)
{
  WorkTogether(ranks,
    [&]
    {
      for (const std::string& problem : { FindOutputProblem(path, form), FindFolderProblem(path) })
      {
        if (!problem.empty())
        {
          throw InputError(problem);
        }
      }
      PrefixErrors("Cannot write the output " + path + ": ",
        [&]
        {
          const MeshFormat format = FindMeshFormat(path)->Format;
          RequirePlanes(mesh, format);
          Write(format, mesh, path, ranks, form);
        });
    });
}

} // namespace vfm
