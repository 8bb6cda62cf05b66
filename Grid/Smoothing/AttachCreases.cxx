#include "Smoothing/AttachCreases.h"

#include "Creases/CreasePlaces.h"
#include "Smoothing/CreaseRules.h"

namespace vfm
{
namespace
{

constexpr double FarthestSide = 1.5;    // from where a point started, in cells
constexpr double SheetCosine = -0.9;    // between the normals of surfaces that face each other
constexpr float SmallestDemand = 0.86f; // at hexes of acute edges, which they cannot fill well

/// Of squared distances, against 1 of quadrics.
struct CreaseWeights
{
  double Side, Carrier;
};
constexpr CreaseWeights HexWeights{ 4.0, 20.0 }, TetWeights{ 12.0, 30.0 };

/// The model that holds for an attachment, nullptr: none, and where its point started in the frame of the model.
struct ModelAt
{
  const NodeCrease* Crease;
  Vector3 Start;
};

/// Whether a model is two surfaces that face each other, with a thin gap or film between them.
bool IsSheet(const CreaseModel& model)
{
  Vector3 first, second;
  DistanceTo(model.Surfaces[0], {}, first);
  DistanceTo(model.Surfaces[1], {}, second);
  return model.Count == 2 && Dot(first, second) < SheetCosine;
}

class CreaseAttacher
{
public:
  CreaseAttacher(const InterfaceCreases& creases, SurfaceTargets& targets, ActiveMesh& active) :
    Creases(creases),
    Targets(targets),
    Active(active),
    IsOwned(active.X.size(), 0),
    Demands(active.X.size(), 1.0f)
  {
    active.ForOwned([this](int point) { this->IsOwned[point] = 1; });
  }

  std::array<int, 2> LabelsOf(const Attachment& attachment) const
  {
    const Index point = attachment.Target - this->Creases.FirstTarget;
    if (point < 0)
    {
      return { { -1, -1 } }; // of another level
    }
    const SurfacePoint& surface = this->Creases.Source.Points()[point];
    return { { surface.First, surface.Second } };
  }

  /// Of each attachment.
  std::vector<CreasePoint> Classify(Runtime& runtime) const
  {
    std::vector<CreasePoint> points(this->Active.Attachments.size());
    ForEach(runtime, this->Active.X.size(),
      [&](Index p)
      {
        for (Index i = this->Active.AttachmentOffset[p]; i < this->Active.AttachmentOffset[p + 1];
             ++i)
        {
          const ModelAt at = this->FindModel(p, i);
          if (at.Crease)
          {
            points[i] = PointOf(at);
          }
        }
      });
    return points;
  }

  /// Asks less of the hexes at acute edges. After Rewrite.
  void SetDemands()
  {
    std::vector<float>& ofPoints = this->Demands;
    this->Active.Exchange.SendAll([&](int mover) { return ofPoints[mover]; },
      [&](int mover, float demand) { ofPoints[mover] = demand; });
    std::vector<float> demands(this->Active.Elements.size() / this->Active.Corners, 1.0f);
    for (std::size_t at = 0; at < this->Active.Elements.size(); ++at)
    {
      float& demand = demands[at / this->Active.Corners];
      demand = std::min(demand, std::max(ofPoints[this->Active.Elements[at]], SmallestDemand));
    }
    if (std::any_of(demands.begin(), demands.end(), [](float demand) { return demand < 1.0f; }))
    {
      this->Active.Demands.swap(demands);
    }
  }

  /// Replaces the attachments that have a kind.
  void Rewrite(const std::vector<CreasePoint>& points)
  {
    std::vector<Attachment> attachments;
    std::vector<Index> offsets(1, 0);
    for (std::size_t p = 0; p < this->Active.X.size(); ++p)
    {
      for (Index i = this->Active.AttachmentOffset[p]; i < this->Active.AttachmentOffset[p + 1];
           ++i)
      {
        const ModelAt at = this->FindModel(p, i);
        if (at.Crease && points[i].Kind != CreaseKind::None)
        {
          const double bluntness =
            this->Add(at, points[i].Kind, this->Active.Attachments[i], attachments);
          this->Demands[p] = std::min(this->Demands[p], static_cast<float>(bluntness));
        }
        else
        {
          attachments.push_back(this->Active.Attachments[i]);
        }
      }
      offsets.push_back(static_cast<Index>(attachments.size()));
    }
    this->Active.Attachments.swap(attachments);
    this->Active.AttachmentOffset.swap(offsets);
  }

private:
  ModelAt FindModel(Index point, Index attachment) const
  {
    const Index target = this->Active.Attachments[attachment].Target;
    const NodeCrease* crease = this->IsOwned[point] && target >= this->Creases.FirstTarget
      ? this->Creases.Models.Find(target - this->Creases.FirstTarget)
      : nullptr;
    return crease
      ? ModelAt{ crease, Divided(this->Active.X[point] - crease->Origin, crease->Widths) }
      : ModelAt{ nullptr, {} };
  }

  static CreasePoint PointOf(const ModelAt& at)
  {
    const CreaseModel& model = at.Crease->Model;
    const SidePlace side = FindSide(model, at.Start);
    const std::optional<EdgePlace> edge = FindEdge(model, at.Start);
    const std::optional<CornerPlace> corner = FindCorner(model, at.Start);
    CreasePoint point;
    point.Kind = side.Distance < FarthestSide ? CreaseKind::Side : CreaseKind::None;
    point.Normal = side.Normal;
    point.IsSheet = IsSheet(model);
    if (edge)
    {
      point.EdgeDistance = BluntnessOf(edge->Normals[0], edge->Normals[1]) * edge->Distance;
      point.EdgeNormals = edge->Normals;
    }
    if (corner)
    {
      point.Corner = at.Crease->Origin + Scaled(corner->Point, at.Crease->Widths);
      point.CornerDistance = corner->Bluntness * corner->Distance;
    }
    return point;
  }

  /// Returns how blunt the edge is that a carrier is drawn to.
  double Add(
    const ModelAt& at, CreaseKind kind, const Attachment& old, std::vector<Attachment>& attachments)
  {
    const CreaseModel& model = at.Crease->Model;
    const CreaseWeights& weights = this->Active.Corners == 8 ? HexWeights : TetWeights;
    const auto add = [&](int surface, const Vector3& place)
    {
      attachments.push_back(old);
      attachments.back().Target = this->Targets.Add(
        Recentred(model.Surfaces[surface], place), at.Crease->Origin, at.Crease->Widths);
      attachments.back().Weight = kind == CreaseKind::Side ? weights.Side : weights.Carrier;
    };
    if (kind == CreaseKind::Corner)
    {
      const CornerPlace corner = *FindCorner(model, at.Start);
      for (int surface = 0; surface < 3; ++surface)
      {
        add(surface, corner.Point);
      }
      return corner.Bluntness;
    }
    if (kind == CreaseKind::Edge)
    {
      const EdgePlace edge = *FindEdge(model, at.Start);
      add(edge.Surfaces[0], edge.Point);
      add(edge.Surfaces[1], edge.Point);
      return BluntnessOf(edge.Normals[0], edge.Normals[1]);
    }
    const SidePlace side = FindSide(model, at.Start);
    add(side.Surface, side.Foot);
    return 1.0;
  }

  const InterfaceCreases& Creases;
  SurfaceTargets& Targets;
  ActiveMesh& Active;
  std::vector<unsigned char> IsOwned; // of each point: this rank moves it
  std::vector<float> Demands;         // of each point: of the hexes there
};

} // namespace

std::vector<CreaseKind> AttachCreases(const InterfaceCreases& creases,
  const std::vector<Facet>& facets, const Mesh& mesh, SurfaceTargets& targets, ActiveMesh& active,
  Runtime& runtime)
{
  if (!runtime.Group().Any(!creases.Models.IsEmpty()))
  {
    return std::vector<CreaseKind>(active.X.size(), CreaseKind::None);
  }
  CreaseAttacher attacher(creases, targets, active);
  std::vector<CreasePoint> points = attacher.Classify(runtime);
  CreaseRules rules(
    facets, mesh, active, [&](const Attachment& a) { return attacher.LabelsOf(a); }, points);
  rules.Run();
  std::vector<CreaseKind> kinds = rules.KindsOfPoints();
  attacher.Rewrite(points);
  if (active.Corners == 8) // tets come near enough
  {
    attacher.SetDemands();
  }
  return kinds;
}

} // namespace vfm
