#include "Surfaces/ReadSurface.h"

#include "Base/ParseText.h"
#include "FileSuffix.h"
#include "Ranks/Errors.h"
#include "Surfaces/FileBytes.h"
#include "Surfaces/ObjFile.h"
#include "Surfaces/OffFile.h"
#include "Surfaces/PlyFile.h"
#include "Surfaces/StlFile.h"
#include "Surfaces/ThreeMfFile.h"
#include "Surfaces/VtpFile.h"

#include <utility>

namespace vfm
{
namespace
{

/// Reader of the bytes of a file.
struct SurfaceFormat
{
  std::string Suffix;
  std::vector<SurfaceFile> (*Read)(const std::string& bytes, const SurfaceTools& tools);
};

template <SurfaceFile (*ReadOne)(std::string_view)>
std::vector<SurfaceFile> ReadAlone(const std::string& bytes, const SurfaceTools&)
{
  return { ReadOne(bytes) };
}

const std::vector<SurfaceFormat>& ListFormats()
{
  static const std::vector<SurfaceFormat> formats{ { ".stl", ReadAlone<ReadStl> },
    { ".obj", ReadAlone<ReadObj> }, { ".ply", ReadAlone<ReadPly> }, { ".off", ReadAlone<ReadOff> },
    { ".vtp",
      [](const std::string& bytes, const SurfaceTools& tools)
      { return std::vector<SurfaceFile>{ ReadVtp(bytes, tools) }; } },
    { ".3mf", ReadThreeMf } };
  return formats;
}

const SurfaceFormat* FindFormat(const std::string& path)
{
  const std::string packed = ".gz";
  const std::string name =
    HasSuffix(path, packed) ? path.substr(0, path.size() - packed.size()) : path;
  for (const SurfaceFormat& format : ListFormats())
  {
    if (HasSuffix(name, format.Suffix))
    {
      return &format;
    }
  }
  return nullptr;
}

/// Appends a body; its patches get numbers behind those of the others.
void AppendBody(SurfaceFile&& body, SurfaceFile& all)
{
  const Index points = static_cast<Index>(all.Points.size());
  const int patches = static_cast<int>(all.PatchNames.size());
  all.Points.insert(all.Points.end(), body.Points.begin(), body.Points.end());
  for (const PointTriangle& t : body.Triangles)
  {
    all.Triangles.push_back({ { points + t[0], points + t[1], points + t[2] } });
  }
  for (int patch : body.Patches)
  {
    all.Patches.push_back(patches + patch);
  }
  for (const std::string& name : body.PatchNames)
  {
    all.PatchNames.push_back(name.empty() ? body.Name : name);
  }
  all.Note += (all.Note.empty() || body.Note.empty() ? "" : " ") + body.Note;
}

} // namespace

std::vector<SurfaceFile> ReadBodies(const std::string& path, const SurfaceTools& tools)
{
  const SurfaceFormat* format = FindFormat(path);
  if (!format)
  {
    throw InputError("it is not a file of a surface: supported are " +
      JoinTexts(GetSurfaceSuffixes()) + ", each also with .gz.");
  }
  std::vector<SurfaceFile> bodies = format->Read(ReadFileBytes(path, tools), tools);
  for (const SurfaceFile& body : bodies)
  {
    if (body.Triangles.empty())
    {
      throw InputError("the surface has no polygons.");
    }
  }
  return bodies;
}

SurfaceFile ReadSurface(const std::string& path, const SurfaceTools& tools)
{
  std::vector<SurfaceFile> bodies = ReadBodies(path, tools);
  SurfaceFile all = std::move(bodies.front());
  for (std::size_t b = 1; b < bodies.size(); ++b)
  {
    AppendBody(std::move(bodies[b]), all);
  }
  return all;
}

std::vector<std::string> GetSurfaceSuffixes()
{
  std::vector<std::string> suffixes;
  for (const SurfaceFormat& format : ListFormats())
  {
    suffixes.push_back(format.Suffix);
  }
  return suffixes;
}

bool IsSurfaceFile(const std::string& path)
{
  return FindFormat(path) != nullptr;
}

} // namespace vfm
