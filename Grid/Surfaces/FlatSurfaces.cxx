#include "Surfaces/FlatSurfaces.h"

#include <algorithm>
#include <utility>

namespace vfm
{
namespace
{

void CheckNumbers(const std::vector<int>& numbers, std::size_t triangles, std::size_t count)
{
  const bool areValid = numbers.size() == triangles &&
    std::all_of(numbers.begin(), numbers.end(),
      [count](int number) { return number >= 0 && number < static_cast<int>(count); });
  if (!areValid)
  {
    throw InputError(
      "The arrays of the surfaces do not fit each other: each triangle needs one body and one "
      "patch, and these need names.");
  }
}

/// Body with the numbers that its points and patches have in it, -1 for those of other bodies.
struct Extract
{
  explicit Extract(const FlatSurfaces& flat) :
    NumberOfPoint(flat.Points.size(), -1), NumberOfPatch(flat.PatchNames.size(), -1)
  {
  }

  std::vector<Vector3> Points;
  std::vector<PointTriangle> Triangles;
  std::vector<int> Patches;
  std::vector<std::string> PatchNames;
  std::vector<Index> NumberOfPoint;
  std::vector<int> NumberOfPatch;

  Index AddPoint(const FlatSurfaces& flat, Index point)
  {
    if (point < 0 || point >= static_cast<Index>(flat.Points.size()))
    {
      throw InputError("A triangle of the surfaces refers to point " + std::to_string(point) +
        ", but there are " + std::to_string(flat.Points.size()) + " points.");
    }
    Index& number = this->NumberOfPoint[point];
    if (number < 0)
    {
      number = static_cast<Index>(this->Points.size());
      this->Points.push_back(flat.Points[point]);
    }
    return number;
  }
  void Add(const FlatSurfaces& flat, std::size_t triangle)
  {
    PointTriangle corners;
    for (int i = 0; i < 3; ++i)
    {
      corners[i] = this->AddPoint(flat, flat.Triangles[triangle][i]);
    }
    this->Triangles.push_back(corners);
    int& patch = this->NumberOfPatch[flat.Patches[triangle]];
    if (patch < 0)
    {
      patch = static_cast<int>(this->PatchNames.size());
      this->PatchNames.push_back(flat.PatchNames[flat.Patches[triangle]]);
    }
    this->Patches.push_back(patch);
  }
};

/// Returns texts as one text, each with a zero at its end.
Bytes JoinByZeros(const std::vector<std::string>& texts)
{
  Bytes joined;
  for (const std::string& text : texts)
  {
    joined.insert(joined.end(), text.c_str(), text.c_str() + text.size() + 1);
  }
  return joined;
}

std::vector<std::string> SplitAtZeros(const Bytes& joined)
{
  std::vector<std::string> texts;
  for (auto begin = joined.begin(); begin != joined.end();)
  {
    const auto end = std::find(begin, joined.end(), '\0');
    texts.emplace_back(begin, end);
    begin = end == joined.end() ? end : end + 1;
  }
  return texts;
}

} // namespace

FlatSurfaces FlattenSurfaces(const InputSurfaces& surfaces)
{
  FlatSurfaces flat;
  for (const BodySurface& body : surfaces.Bodies)
  {
    const auto points = static_cast<Index>(flat.Points.size());
    const int patches = static_cast<int>(flat.PatchNames.size());
    const ClosedSurface& boundary = body.Boundary;
    flat.Points.insert(flat.Points.end(), boundary.Points.begin(), boundary.Points.end());
    for (std::size_t t = 0; t < boundary.Triangles.size(); ++t)
    {
      const PointTriangle& corners = boundary.Triangles[t];
      flat.Triangles.push_back(
        { { points + corners[0], points + corners[1], points + corners[2] } });
      flat.Bodies.push_back(static_cast<int>(flat.Names.size()));
      flat.Patches.push_back(patches + body.Patches[t]);
    }
    flat.Names.push_back(body.Name);
    flat.PatchNames.insert(flat.PatchNames.end(), body.PatchNames.begin(), body.PatchNames.end());
  }
  return flat;
}

InputSurfaces RestoreSurfaces(const FlatSurfaces& flat)
{
  CheckNumbers(flat.Bodies, flat.Triangles.size(), flat.Names.size());
  CheckNumbers(flat.Patches, flat.Triangles.size(), flat.PatchNames.size());
  std::vector<std::vector<std::size_t>> members(flat.Names.size());
  for (std::size_t t = 0; t < flat.Triangles.size(); ++t)
  {
    members[flat.Bodies[t]].push_back(t);
  }
  InputSurfaces surfaces;
  for (std::size_t b = 0; b < members.size(); ++b)
  {
    Extract body(flat);
    for (std::size_t t : members[b])
    {
      body.Add(flat, t);
    }
    PrefixErrors("The surface of " + flat.Names[b] + ": ",
      [&]
      {
        surfaces.Bodies.push_back(MakeBody(flat.Names[b], std::move(body.Points),
          std::move(body.Triangles), std::move(body.Patches), std::move(body.PatchNames)));
      });
  }
  return surfaces;
}

FlatSurfaces ShareSurfaces(FlatSurfaces mine, Ranks& ranks)
{
  const bool hasAny = !mine.Triangles.empty();
  const int first = static_cast<int>(-ranks.Max(hasAny ? -ranks.Rank() : -ranks.Count()));
  if (ranks.Rank() != first)
  {
    mine = {};
  }
  if (first == ranks.Count() || ranks.Count() == 1)
  {
    return mine;
  }
  FlatSurfaces all;
  all.Points = GatherItems(ranks, mine.Points);
  all.Triangles = GatherItems(ranks, mine.Triangles);
  all.Bodies = GatherItems(ranks, mine.Bodies);
  all.Patches = GatherItems(ranks, mine.Patches);
  all.Names = SplitAtZeros(ranks.Gather(JoinByZeros(mine.Names))[first]);
  all.PatchNames = SplitAtZeros(ranks.Gather(JoinByZeros(mine.PatchNames))[first]);
  return all;
}

} // namespace vfm
