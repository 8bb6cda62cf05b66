#include "Surfaces/ThreeMfFile.h"

#include "Ranks/Errors.h"
#include "Surfaces/PatchList.h"
#include "Surfaces/ThreeMfModel.h"
#include "Surfaces/XmlTags.h"
#include "Surfaces/ZipFile.h"

#include <utility>

namespace vfm
{
namespace
{

constexpr int Deepest = 32;                                 // components of components
constexpr Index MostUses = 1 << 16;                         // of objects
constexpr std::size_t MostTriangles = std::size_t(1) << 26; // of a body

/// Returns the transform that moves by the inner one first.
ThreeMfTransform Combine(const ThreeMfTransform& inner, const ThreeMfTransform& outer)
{
  ThreeMfTransform both{};
  for (int row = 0; row < 4; ++row)
  {
    for (int a = 0; a < 3; ++a)
    {
      both[3 * row + a] = inner[3 * row] * outer[a] + inner[3 * row + 1] * outer[3 + a] +
        inner[3 * row + 2] * outer[6 + a] + (row == 3 ? outer[9 + a] : 0.0);
    }
  }
  return both;
}

Vector3 Move(const Vector3& x, const ThreeMfTransform& by)
{
  Vector3 moved{};
  for (int a = 0; a < 3; ++a)
  {
    moved[a] = x[0] * by[a] + x[1] * by[3 + a] + x[2] * by[6 + a] + by[9 + a];
  }
  return moved;
}

/// Model parts of an archive, read when they are needed.
class ModelParts
{
public:
  ModelParts(const ZipFile& archive, const SurfaceTools& tools) : Archive(archive), Tools(tools) {}

  /// @param path  of a part; a slash at its begin is dropped
  const ThreeMfModel& Find(const std::string& path)
  {
    const std::string name = path.substr(path.find_first_not_of('/') == 1 ? 1 : 0);
    const auto found = this->Models.find(name);
    return found != this->Models.end()
      ? found->second
      : this->Models.emplace(name, ReadThreeMfModel(this->Archive.Read(name, this->Tools)))
          .first->second;
  }

private:
  const ZipFile& Archive;
  const SurfaceTools& Tools;
  std::map<std::string, ThreeMfModel> Models;
};

/// Returns the path of the part that lists what is built.
std::string FindRootPart(const ZipFile& archive, const SurfaceTools& tools)
{
  const std::string relations = "_rels/.rels";
  if (archive.Has(relations))
  {
    const std::string text = archive.Read(relations, tools);
    XmlTag tag;
    for (XmlTags tags(text); tags.Next(tag);)
    {
      const std::string target = tag.Get("Target");
      if (tag.Get("Type").find("3dmodel") != std::string::npos && !target.empty())
      {
        return target;
      }
    }
  }
  const std::string name = archive.FindEnding(".model");
  if (name.empty())
  {
    throw InputError("it is not a 3MF file: its archive has no model.");
  }
  return name;
}

/// Makes bodies of objects with their components.
class BodyBuilder
{
public:
  explicit BodyBuilder(ModelParts& parts) : Parts(parts) {}

  /// @param path  part of the archive with the item
  SurfaceFile Build(const std::string& path, const ThreeMfUse& item)
  {
    this->Body = {};
    this->Patches = {};
    this->Add(path, item, NoTransform, 0);
    this->Patches.Finish(this->Body);
    return std::move(this->Body);
  }

private:
  void Add(
    const std::string& path, const ThreeMfUse& use, const ThreeMfTransform& outer, int depth);
  void AddTriangles(
    const ThreeMfObject& object, const ThreeMfModel& model, const ThreeMfTransform& transform);

  ModelParts& Parts;
  Index Uses = 0; // of objects by all items
  SurfaceFile Body;
  PatchList Patches;
};

/// Appends the triangles of an object and of its components.
/// @param path  part of the archive that uses the object
void BodyBuilder::Add(
  const std::string& path, const ThreeMfUse& use, const ThreeMfTransform& outer, int depth)
{
  if (depth > Deepest || ++this->Uses > MostUses)
  {
    throw InputError("its objects contain each other too deeply or too often.");
  }
  const std::string& place = use.Path.empty() ? path : use.Path;
  const ThreeMfModel& model = this->Parts.Find(place);
  const auto found = model.Objects.find(use.Object);
  if (found == model.Objects.end())
  {
    throw InputError("it is truncated or damaged: it has no object " + use.Object + ".");
  }
  const ThreeMfTransform transform = Combine(use.Transform, outer);
  this->AddTriangles(found->second, model, transform);
  for (const ThreeMfUse& component : found->second.Components)
  {
    this->Add(place, component, transform, depth + 1);
  }
}

void BodyBuilder::AddTriangles(
  const ThreeMfObject& object, const ThreeMfModel& model, const ThreeMfTransform& transform)
{
  if (this->Body.Triangles.size() + object.Triangles.size() > MostTriangles)
  {
    throw InputError("it has more than 2^26 triangles.");
  }
  const Index first = static_cast<Index>(this->Body.Points.size());
  for (const Vector3& x : object.Points)
  {
    this->Body.Points.push_back(Move(x, transform));
  }
  for (std::size_t t = 0; t < object.Triangles.size(); ++t)
  {
    const PointTriangle& c = object.Triangles[t];
    this->Body.Triangles.push_back({ { first + c[0], first + c[1], first + c[2] } });
    const int property = object.Properties[t];
    this->Body.Patches.push_back(
      this->Patches.Find(property < 0 ? object.Name : model.PropertyNames[property]));
  }
}

std::string NameItem(ModelParts& parts, const std::string& path, const ThreeMfUse& item)
{
  const auto& objects = parts.Find(item.Path.empty() ? path : item.Path).Objects;
  const auto found = objects.find(item.Object);
  return found == objects.end() || found->second.Name.empty() ? item.Name : found->second.Name;
}

} // namespace

std::vector<SurfaceFile> ReadThreeMf(const std::string& bytes, const SurfaceTools& tools)
{
  const ZipFile archive(bytes);
  ModelParts parts(archive, tools);
  const std::string root = FindRootPart(archive, tools);
  BodyBuilder builder(parts);
  std::vector<SurfaceFile> bodies;
  for (const ThreeMfUse& item : parts.Find(root).Items)
  {
    bodies.push_back(builder.Build(root, item));
    bodies.back().Name = NameItem(parts, root, item);
  }
  if (bodies.empty())
  {
    throw InputError("it builds no object.");
  }
  return bodies;
}

} // namespace vfm
