#include "GivenSurfaces/EdgeModels.h"

#include <algorithm>

namespace vfm
{
namespace
{

constexpr FitRange SideRange{ 2.0, 1.0 };
constexpr double LeastArea = 0.5;    // of a side around its place, cells^2
constexpr double FacingCosine = 0.2; // between the interface and a side of its edge
constexpr double LeastGain = 0.01;   // of the missed share, for a third side
constexpr std::size_t MostThirds = 3, MostSheets = 4;
constexpr double SmallMiss = 0.1;  // other sheets are tried above this missed share
constexpr double NearOther = 0.05; // samples so near to another surface do not count, in cells
constexpr double NoModel = 1e30;
constexpr int Intersection = 0, Union = 1; // compositions of two surfaces

/// Returns the nearest edge with a side that faces as the interface does, or null.
const NearEdge* FindNearest(const std::vector<NearEdge>& edges, const Vector3& normal)
{
  const NearEdge* nearest = nullptr;
  for (const NearEdge& edge : edges)
  {
    const double facing = std::max(Dot(edge.Normals[0], normal), Dot(edge.Normals[1], normal));
    if (facing > FacingCosine && (!nearest || edge.Distance < nearest->Distance))
    {
      nearest = &edge;
    }
  }
  return nearest;
}

/// Fits a side unless it is a sliver between edges, which the mesh cannot show.
std::optional<SampleFit> FitSide(const std::vector<NearSample>& samples, const SurfacePart& side)
{
  double area = 0.0;
  for (const NearSample& sample : samples)
  {
    const Vector3 from = sample.At - side.Centre;
    const bool counts =
      sample.Sheet == side.Sheet && Dot(from, from) <= SideRange.Radius * SideRange.Radius;
    area += counts ? sample.Weight : 0.0;
  }
  return area < LeastArea ? std::nullopt : FitSamples(samples, side, SideRange);
}

/// A model and the sheets of its surfaces.
struct SheetModel
{
  FeatureModel Model{};
  std::array<int, FeatureModel::MaximumSurfaces> Sheets{};

  SheetModel With(const LocalQuadric& surface, int sheet) const
  {
    SheetModel more = *this;
    more.Sheets[more.Model.Count] = sheet;
    more.Model.Surfaces[more.Model.Count++] = surface;
    return more;
  }
};

bool Fades(const NearEdge& edge)
{
  return edge.Sheets[0] == edge.Sheets[1];
}

/// Returns the model of both sides of an edge.
std::optional<SheetModel> ModelOfSides(const std::vector<NearSample>& samples, const NearEdge& edge)
{
  SheetModel sides;
  for (int k = 0; k < 2; ++k)
  {
    SurfacePart side{ edge.At, edge.Normals[k], edge.Sheets[k], {} };
    side.Other = Fades(edge) ? edge.Normals[1 - k] : Vector3{};
    const std::optional<SampleFit> fit = FitSide(samples, side);
    if (!fit)
    {
      return std::nullopt;
    }
    sides = sides.With(fit->Surface, edge.Sheets[k]);
  }
  sides.Model.Composition = edge.IsConvex ? Intersection : Union;
  return sides;
}

/// A sample and the surfaces of a model.
struct SampleSides
{
  int Surface; ///< surface on which it lies, or -1
  int Inside;  ///< bits of the surfaces that have it inside
  double Weight;
};

/// Returns the surface of a model that has the sheet of a sample, or -1. Of both sides of a fading
/// edge, the one with the nearer normal.
int SurfaceOf(const NearSample& sample, const SheetModel& model)
{
  int best = -1;
  double most = -2.0;
  for (int k = 0; k < model.Model.Count; ++k)
  {
    Vector3 normal;
    DistanceTo(model.Model.Surfaces[k], sample.At, normal);
    const double cosine = Dot(normal, sample.Normal);
    if (model.Sheets[k] == sample.Sheet && cosine > most)
    {
      best = k;
      most = cosine;
    }
  }
  return best;
}

/// Lists the samples near the node, except those near an edge of the model.
std::vector<SampleSides> ListSides(const std::vector<NearSample>& samples, const SheetModel& model)
{
  std::vector<SampleSides> sides;
  for (const NearSample& sample : samples)
  {
    if (Dot(sample.At, sample.At) > EdgeReach * EdgeReach)
    {
      continue;
    }
    SampleSides side{ SurfaceOf(sample, model), 0, sample.Weight };
    bool isNearOther = false;
    for (int k = 0; k < model.Model.Count; ++k)
    {
      Vector3 normal;
      const double distance = DistanceTo(model.Model.Surfaces[k], sample.At, normal);
      side.Inside |= distance > 0.0 ? 1 << k : 0;
      isNearOther = isNearOther || (k != side.Surface && std::fabs(distance) < NearOther);
    }
    if (side.Surface < 0 || !isNearOther)
    {
      sides.push_back(side);
    }
  }
  return sides;
}

/// Returns the share of the samples at which the second label does not end in a composition.
double MissedShare(const FeatureModel& model, const std::vector<SampleSides>& samples)
{
  double missed = 0.0, sum = 0.0;
  for (const SampleSides& sample : samples)
  {
    const int own = sample.Surface < 0 ? 0 : 1 << sample.Surface;
    const bool ends =
      own != 0 && IsInside(model, sample.Inside | own) != IsInside(model, sample.Inside & ~own);
    missed += ends ? 0.0 : sample.Weight;
    sum += sample.Weight;
  }
  return sum > 0.0 ? missed / sum : 0.0;
}

/// A third side near an edge, the nearest first; those of corners come before others.
struct ThirdSide
{
  double Distance;
  SurfacePart Part;
  bool operator<(const ThirdSide& other) const { return this->Distance < other.Distance; }
};

bool HasSheet(const NearEdge& edge, int sheet)
{
  return edge.Sheets[0] == sheet || edge.Sheets[1] == sheet;
}

void AddOfCorners(
  const std::vector<NearCorner>& corners, const NearEdge& edge, std::vector<ThirdSide>& thirds)
{
  for (const NearCorner& corner : corners)
  {
    int shared = 0;
    std::size_t other = 0;
    for (std::size_t k = 0; k < corner.Sheets.size(); ++k)
    {
      const bool has = HasSheet(edge, corner.Sheets[k]);
      shared += has;
      other = has ? other : k;
    }
    if (corner.Sheets.size() == 3 && shared == 2)
    {
      thirds.push_back({ corner.Distance - CornerReach,
        { corner.At, corner.Normals[other], corner.Sheets[other], {} } });
    }
  }
}

void AddOfEdges(
  const std::vector<NearEdge>& edges, const NearEdge& edge, std::vector<ThirdSide>& thirds)
{
  for (const NearEdge& near : edges)
  {
    for (int k = 0; k < 2; ++k)
    {
      if (!HasSheet(edge, near.Sheets[k]) && HasSheet(edge, near.Sheets[1 - k]))
      {
        thirds.push_back({ near.Distance, { near.At, near.Normals[k], near.Sheets[k], {} } });
      }
    }
  }
}

/// Returns the nearest part of each third sheet, at most MostThirds.
std::vector<ThirdSide> ListThirds(const NodeSurroundings& around, const NearEdge& edge)
{
  std::vector<ThirdSide> all, nearest;
  AddOfCorners(around.Corners, edge, all);
  AddOfEdges(around.Edges, edge, all);
  std::stable_sort(all.begin(), all.end());
  for (const ThirdSide& third : all)
  {
    const bool isNew = std::none_of(nearest.begin(), nearest.end(),
      [&](const ThirdSide& other) { return other.Part.Sheet == third.Part.Sheet; });
    if (isNew && nearest.size() < MostThirds)
    {
      nearest.push_back(third);
    }
  }
  return nearest;
}

/// The best model so far.
struct BestModel
{
  FeatureModel Model;
  double Missed = NoModel;
};

/// Replaces the best model by the best composition of another one that misses less.
void TryCompositions(SheetModel other, const std::vector<NearSample>& samples, BestModel& best)
{
  const std::vector<SampleSides> sides = ListSides(samples, other);
  FeatureModel& model = other.Model;
  for (model.Composition = 0; model.Composition < NumberOfCompositions(model.Count);
       ++model.Composition)
  {
    const double missed = MissedShare(model, sides);
    if (missed < best.Missed - LeastGain)
    {
      best = { model, missed };
    }
  }
}

/// Tries the sides of an edge, then also each third side.
void TryEdge(const NodeSurroundings& around, const NearEdge& edge, BestModel& best)
{
  const std::optional<SheetModel> two = ModelOfSides(around.Samples, edge);
  if (!two)
  {
    return;
  }
  best = { two->Model, MissedShare(two->Model, ListSides(around.Samples, *two)) };
  for (const ThirdSide& third : ListThirds(around, edge))
  {
    const std::optional<SampleFit> fit = FitSide(around.Samples, third.Part);
    if (fit)
    {
      TryCompositions(two->With(fit->Surface, third.Part.Sheet), around.Samples, best);
    }
  }
}

/// Fits the sheets at the nearest edges, at most MostSheets. Slivers between edges have no fit.
std::vector<SheetModel> FitSheets(const NodeSurroundings& around)
{
  std::vector<NearEdge> edges = around.Edges;
  std::stable_sort(edges.begin(), edges.end(),
    [](const NearEdge& a, const NearEdge& b) { return a.Distance < b.Distance; });
  std::vector<int> seen;
  std::vector<SheetModel> sheets;
  for (const NearEdge& edge : edges)
  {
    for (int k = 0; k < 2 && sheets.size() < MostSheets; ++k)
    {
      const int sheet = edge.Sheets[k];
      if (std::find(seen.begin(), seen.end(), sheet) == seen.end())
      {
        seen.push_back(sheet);
        const std::optional<SampleFit> fit =
          FitSide(around.Samples, { edge.At, edge.Normals[k], sheet, {} });
        if (fit)
        {
          sheets.push_back(SheetModel().With(fit->Surface, sheet));
        }
      }
    }
  }
  return sheets;
}

/// Tries all pairs and triples of sheets.
void TrySheets(const NodeSurroundings& around, BestModel& best)
{
  const std::vector<SheetModel> sheets = FitSheets(around);
  const auto with = [&](const SheetModel& model, std::size_t i)
  { return model.With(sheets[i].Model.Surfaces[0], sheets[i].Sheets[0]); };
  for (std::size_t i = 0; i < sheets.size(); ++i)
  {
    for (std::size_t j = i + 1; j < sheets.size(); ++j)
    {
      const SheetModel two = with(sheets[i], j);
      TryCompositions(two, around.Samples, best);
      for (std::size_t k = j + 1; k < sheets.size(); ++k)
      {
        TryCompositions(with(two, k), around.Samples, best);
      }
    }
  }
}

} // namespace

std::optional<EdgeModel> MakeEdgeModel(const NodeSurroundings& around, const Vector3& normal)
{
  const NearEdge* edge = FindNearest(around.Edges, normal);
  if (!edge)
  {
    return std::nullopt;
  }
  BestModel best;
  TryEdge(around, *edge, best);
  if (best.Missed > SmallMiss)
  {
    TrySheets(around, best);
  }
  return best.Missed < NoModel ? std::optional<EdgeModel>({ best.Model, Fades(*edge) })
                               : std::nullopt;
}

} // namespace vfm
