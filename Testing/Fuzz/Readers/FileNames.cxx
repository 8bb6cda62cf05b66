/**
 * What the command line asks about names of files, without the readers of VTK and the writers of
 * meshes, which the build of libFuzzer does not contain (FuzzArguments).
 */
#include "FileSuffix.h"
#include "ImageInput.h"
#include "Meshes/Gmsh/WriteGmsh.h"
#include "Meshes/Surfaces/MaterialSkins.h"
#include "Meshes/Vtk/WriteGeometry.h"
#include "Ranks/Errors.h"
#include "ReadInput.h"
#include "Report/WriteReport.h"

namespace vfm
{
namespace
{

std::string FindProblem(const std::string& path, const std::vector<std::string>& suffixes)
{
  return HasSuffix(path, suffixes) ? "" : path + " is of an unknown format.";
}

} // namespace

std::vector<std::string> GetInputSuffixes()
{
  return { ".vti", ".nrrd", ".spn", ".npy", ".e" };
}

void CheckInputSuffix(const std::string& path)
{
  if (!HasSuffix(path, GetInputSuffixes()))
  {
    throw InputError(ErrorCode::WrongArguments, path + " is of an unknown format.");
  }
}

bool IsVoxelFile(const std::string& path)
{
  return HasSuffix(path, std::vector<std::string>{ ".spn", ".npy" });
}

std::string FindSurfaceFolder(const std::string&)
{
  return "";
}

std::string FindSurfaceProblem(const std::string& path)
{
  return FindProblem(path, { ".stl", ".obj" });
}

std::string FindGeometryProblem(const std::string& path)
{
  return FindProblem(path, { ".vtm" });
}

std::string FindReportProblem(const std::string& path)
{
  return FindProblem(path, { ".html" });
}

std::optional<GmshVersion> ParseGmshVersion(const std::string& name)
{
  return name == "2.2" ? std::optional<GmshVersion>(GmshVersion::V2_2) : std::nullopt;
}

} // namespace vfm
