#include "Smoothing/AttachFeatures.h"

#include "Elements/PeriodicIds.h"
#include "GivenSurfaces/FollowSurfaces.h"
#include "Smoothing/RefineTargets.h"

namespace vfm
{
namespace
{

constexpr float SmallestDemand =
  0.86f; // target of hexes at acute edges, which they cannot fill well

SurfacePairs ListPairs(
  const InterfaceFeatures& features, const Mesh& mesh, const ActiveMesh& active)
{
  SurfacePairs pairs{ active.HasHexes(), active.X, active.AttachmentOffset, active.PointOf,
    active.Exchange, {}, std::vector<unsigned char>(active.X.size(), 0), {}, {} };
  active.ForOwned([&](int point) { pairs.IsOwned[point] = 1; });
  for (Index meshPoint : active.MeshPoint)
  {
    pairs.Ids.push_back(IdOfOwner(mesh, mesh.PointIds[meshPoint]));
  }
  for (const Attachment& attachment : active.Attachments)
  {
    pairs.Target.push_back(attachment.Target);
    pairs.Labels.push_back(features.LabelsOf(attachment.Target));
  }
  return pairs;
}

/// Replaces the attachments of the pairs that are attracted to sharp features.
void Rewrite(const std::vector<FeaturePull>& pulls, ActiveMesh& active)
{
  std::vector<Attachment> attachments;
  std::vector<CornerPosition> offsets(1, 0);
  for (std::size_t p = 0; p < active.X.size(); ++p)
  {
    for (CornerPosition i = active.AttachmentOffset[p]; i < active.AttachmentOffset[p + 1]; ++i)
    {
      const FeaturePull& pull = pulls[i];
      Attachment own = active.Attachments[i];
      own.Weight = pull.Count > 0 ? pull.Weight : own.Weight;
      for (int n = 0; n < std::max(pull.Count, 1); ++n)
      {
        own.Target = pull.Count > 0 ? static_cast<int>(pull.Targets[n]) : own.Target;
        attachments.push_back(own);
      }
    }
    offsets.push_back(static_cast<CornerPosition>(attachments.size()));
  }
  active.Attachments.swap(attachments);
  active.AttachmentOffset.swap(offsets);
}

/// Lowers the target quality of the hexes at acute edges.
/// @param bluntness  value of each point
void SetDemands(std::vector<float> bluntness, ActiveMesh& active)
{
  active.Exchange.SendAll([&](int mover) { return bluntness[mover]; },
    [&](int mover, float demand) { bluntness[mover] = demand; });
  std::vector<float> demands = active.Demands; // of the barrier
  demands.resize(active.Elements.size() / active.Corners, 1.0f);
  for (std::size_t at = 0; at < active.Elements.size(); ++at)
  {
    float& demand = demands[at / active.Corners];
    demand = std::min(demand, std::max(bluntness[active.Elements[at]], SmallestDemand));
  }
  if (std::any_of(demands.begin(), demands.end(), [](float demand) { return demand < 1.0f; }))
  {
    active.Demands.swap(demands);
  }
}

/// Reports the numbers of points on edges and corners.
void CountCarriers(const std::vector<FeatureKind>& kinds, const ActiveMesh& active, MeshRun& run)
{
  std::vector<std::int64_t> counts(2, 0);
  active.ForOwned(
    [&](int point)
    {
      counts[0] += kinds[point] == FeatureKind::Edge;
      counts[1] += kinds[point] == FeatureKind::Corner;
    });
  run.Group().Sum(counts);
  run.Report.EdgePoints = counts[0];
  run.Report.CornerPoints = counts[1];
}

} // namespace

std::vector<FeatureKind> AttachFeatures(const InterfaceFeatures& features,
  const std::vector<Facet>& facets, const Mesh& mesh, SurfaceTargets& targets, ActiveMesh& active,
  Runtime& runtime)
{
  if (!runtime.Group().Any(!features.Models.IsEmpty()))
  {
    return std::vector<FeatureKind>(active.X.size(), FeatureKind::None);
  }
  FeaturePulls pulls =
    PullToFeatures(features, ListPairs(features, mesh, active), facets, targets, runtime);
  Rewrite(pulls.OfPairs, active);
  active.AtFadingEdge = std::move(pulls.Fade);
  if (active.HasHexes()) // tets fill acute edges well enough
  {
    SetDemands(std::move(pulls.Bluntness), active);
  }
  return std::move(pulls.Kinds);
}

std::vector<FeatureKind> AttachToFeatures(const MeshCells& cells,
  const std::vector<const Interface*>& interfaces, const std::vector<Facet>& facets,
  const Mesh& mesh, MeshRun& run, SurfaceTargets& targets, ActiveMesh& active)
{
  const MeshOptions& options = cells.Options;
  const bool hasQuadrics =
    options.IsoValue == 0.5 && options.Smoothing == SmoothingMethod::QuadricSurface;
  const BodySurfaces* surfaces = hasQuadrics ? cells.Surfaces : nullptr;
  const Interface& finest = *interfaces.back();
  const Index ofFinest = targets.Count() - static_cast<Index>(finest.Points().size());
  std::vector<FeatureKind> kinds(active.X.size(), FeatureKind::None);
  const PairFilter hasNoSurface = [surfaces](const LabelPair& pair)
  { return !surfaces || surfaces->FindOfInterface(pair.first, pair.second) < 0; };
  SharpFeatures features;
  if (surfaces)
  {
    run.Clock.Start("Following surfaces", 0.21);
    features = FollowSurfaces(
      *surfaces, interfaces, options.SharpEdges != SharpEdgeMode::Off, run.TheRuntime, targets);
  }
  if (options.SharpEdges != SharpEdgeMode::Off && hasQuadrics)
  {
    run.Clock.Start("Finding sharp features", 0.22);
    features.Add(SharpFeatures(finest, cells.Fractions, targets, ofFinest, hasNoSurface,
      options.SharpEdges, run.Parts, run.TheRuntime));
    const InterfaceFeatures all = surfaces ? InterfaceFeatures{ features, interfaces, 0 }
                                           : InterfaceFeatures{ features, { &finest }, ofFinest };
    kinds = AttachFeatures(all, facets, mesh, targets, active, run.TheRuntime);
    CountCarriers(kinds, active, run);
  }
  if (HasCurvedEdges(options) && hasQuadrics)
  {
    RefineTargets(finest, cells.Fractions, ofFinest, hasNoSurface, active, run.TheRuntime, targets);
  }
  return kinds;
}

} // namespace vfm
