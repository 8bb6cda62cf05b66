#include "GivenSurfaces/EdgeModels.h"

#include "SharpFeatures/FeatureFit.h"

#include <algorithm>

namespace vfm
{
namespace
{

constexpr FitRange SideRange{ 2.0, 1.0 };
constexpr double LeastArea = 0.5;    // of a side around its place, cells^2
constexpr double FacingCosine = 0.2; // between the interface and a side of its edge
constexpr double LeastGain = 1e-4;   // of the residual, for a third side
constexpr std::size_t MostThirds = 3, MostSheets = 4;
constexpr double GoodResidual = 0.05; // other sheets are tried above it
constexpr double NoResidual = 1e30;
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
std::optional<SampleFit> FitSide(const std::vector<SurfaceSample>& samples, const SurfacePart& side)
{
  double area = 0.0;
  for (const SurfaceSample& sample : samples)
  {
    const Vector3 from = sample.At - side.Centre;
    const bool counts =
      sample.Sheet == side.Sheet && Dot(from, from) <= SideRange.Radius * SideRange.Radius;
    area += counts ? sample.Weight : 0.0;
  }
  return area < LeastArea ? std::nullopt : FitSamples(samples, side, SideRange);
}

/// Returns the model of both sides of an edge.
std::optional<FeatureModel> ModelOfSides(
  const std::vector<SurfaceSample>& samples, const NearEdge& edge)
{
  FeatureModel model;
  model.Count = 2;
  model.Composition = edge.IsConvex ? Intersection : Union;
  const bool isFading = edge.Sheets[0] == edge.Sheets[1];
  for (int k = 0; k < 2; ++k)
  {
    SurfacePart side{ edge.At, edge.Normals[k], edge.Sheets[k], {} };
    side.Other = isFading ? edge.Normals[1 - k] : Vector3{};
    const std::optional<SampleFit> fit = FitSide(samples, side);
    if (!fit)
    {
      return std::nullopt;
    }
    model.Surfaces[k] = fit->Surface;
  }
  return model;
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

/// Replaces a model by the best composition of more surfaces, if the fractions fit better.
void TryCompositions(FeatureModel model, const PackedCells& cells, EdgeModel& best)
{
  for (model.Composition = 0; model.Composition < NumberOfCompositions(model.Count);
       ++model.Composition)
  {
    const double residual = ResidualOf(model, cells);
    if (residual < best.Residual - LeastGain)
    {
      best = { model, residual };
    }
  }
}

FeatureModel With(FeatureModel model, const LocalQuadric& surface)
{
  model.Surfaces[model.Count++] = surface;
  return model;
}

/// Tries the sides of an edge, then also each third side.
void TryEdge(
  const NodeSurroundings& around, const NearEdge& edge, const PackedCells& cells, EdgeModel& best)
{
  const std::optional<FeatureModel> two = ModelOfSides(around.Samples, edge);
  if (!two)
  {
    return;
  }
  best = { *two, ResidualOf(*two, cells) };
  for (const ThirdSide& third : ListThirds(around, edge))
  {
    const std::optional<SampleFit> fit = FitSide(around.Samples, third.Part);
    if (fit)
    {
      TryCompositions(With(*two, fit->Surface), cells, best);
    }
  }
}

/// Fits the sheets at the nearest edges, at most MostSheets. Slivers between edges have no fit.
std::vector<LocalQuadric> FitSheets(const NodeSurroundings& around)
{
  std::vector<NearEdge> edges = around.Edges;
  std::stable_sort(edges.begin(), edges.end(),
    [](const NearEdge& a, const NearEdge& b) { return a.Distance < b.Distance; });
  std::vector<int> seen;
  std::vector<LocalQuadric> surfaces;
  for (const NearEdge& edge : edges)
  {
    for (int k = 0; k < 2 && surfaces.size() < MostSheets; ++k)
    {
      if (std::find(seen.begin(), seen.end(), edge.Sheets[k]) == seen.end())
      {
        seen.push_back(edge.Sheets[k]);
        const std::optional<SampleFit> fit =
          FitSide(around.Samples, { edge.At, edge.Normals[k], edge.Sheets[k], {} });
        if (fit)
        {
          surfaces.push_back(fit->Surface);
        }
      }
    }
  }
  return surfaces;
}

/// Tries all pairs and triples of sheets.
void TrySheets(const NodeSurroundings& around, const PackedCells& cells, EdgeModel& best)
{
  const std::vector<LocalQuadric> surfaces = FitSheets(around);
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    for (std::size_t j = i + 1; j < surfaces.size(); ++j)
    {
      const FeatureModel two = With(ModelOf(surfaces[i]), surfaces[j]);
      TryCompositions(two, cells, best);
      for (std::size_t k = j + 1; k < surfaces.size(); ++k)
      {
        TryCompositions(With(two, surfaces[k]), cells, best);
      }
    }
  }
}

} // namespace

std::optional<EdgeModel> MakeEdgeModel(
  const NodeSurroundings& around, const Vector3& normal, const PackedCells& cells)
{
  const NearEdge* edge = FindNearest(around.Edges, normal);
  if (!edge)
  {
    return std::nullopt;
  }
  EdgeModel best{ {}, NoResidual };
  TryEdge(around, *edge, cells, best);
  if (best.Residual > GoodResidual)
  {
    TrySheets(around, cells, best);
  }
  return best.Residual < NoResidual ? std::optional(best) : std::nullopt;
}

} // namespace vfm
