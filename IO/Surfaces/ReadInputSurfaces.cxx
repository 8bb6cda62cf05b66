#include "Surfaces/ReadInputSurfaces.h"

#include "FileSuffix.h"
#include "Ranks/Errors.h"
#include "Surfaces/ReadSurface.h"

#include <filesystem>
#include <map>
#include <set>

namespace vfm
{
namespace
{

/// Returns the name of a file without folder and suffixes.
std::string StemOf(const std::string& path)
{
  const std::filesystem::path name(path);
  return (HasSuffix(path, ".gz") ? name.stem() : name).stem().string();
}

/// Returns the names of the bodies of a file, all different.
std::vector<std::string> NameBodies(const std::string& path, const std::vector<SurfaceFile>& bodies)
{
  const std::string stem = StemOf(path);
  if (bodies.size() == 1)
  {
    return { stem };
  }
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const SurfaceFile& body : bodies)
  {
    const std::string first = body.Name.empty() ? stem + " 1" : body.Name;
    std::string name = first;
    for (int number = 2; !taken.insert(name).second; ++number)
    {
      name = (body.Name.empty() ? stem : body.Name) + " " + std::to_string(number);
    }
    names.push_back(name);
  }
  return names;
}

/// Reads the bodies of a file and appends them.
void AppendFile(const std::string& path, const std::function<void(const std::string&)>& warn,
  const SurfaceTools& tools, std::vector<BodySurface>& to)
{
  const auto pass = [&](const std::string& note)
  {
    if (!note.empty() && warn)
    {
      warn(path + ": " + note);
    }
  };
  std::vector<SurfaceFile> bodies = ReadBodies(path, tools);
  const std::vector<std::string> names = NameBodies(path, bodies);
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    SurfaceFile& body = bodies[b];
    std::string note;
    PrefixErrors(bodies.size() > 1 ? names[b] + ": " : std::string(),
      [&]
      {
        to.push_back(MakeBody(names[b], std::move(body.Points), std::move(body.Triangles),
          std::move(body.Patches), std::move(body.PatchNames), &note));
      });
    pass(body.Note);
    pass(note);
  }
}

} // namespace

InputSurfaces ReadInputSurfaces(const std::vector<std::string>& paths,
  const std::function<void(const std::string&)>& warn, const SurfaceTools& tools)
{
  InputSurfaces surfaces;
  std::map<std::string, std::string> files; // by the names of their bodies
  for (const std::string& path : paths)
  {
    const std::size_t before = surfaces.Bodies.size();
    PrefixErrors("Cannot read the surface " + path + ": ",
      [&] { AppendFile(path, warn, tools, surfaces.Bodies); });
    for (std::size_t b = before; b < surfaces.Bodies.size(); ++b)
    {
      const std::string& name = surfaces.Bodies[b].Name;
      const auto [found, isNew] = files.emplace(name, path);
      if (!isNew)
      {
        throw InputError("The surfaces " + found->second + " and " + path +
          " would both be the material " + name + ": rename one of the files.");
      }
    }
  }
  return surfaces;
}

} // namespace vfm
