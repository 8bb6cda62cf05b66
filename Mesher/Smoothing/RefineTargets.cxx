#include "Smoothing/RefineTargets.h"

#include "Base/Sorted.h"
#include "SharpFeatures/FeatureData.h"
#include "SharpFeatures/FeatureFit.h"

namespace vfm
{
namespace
{

constexpr int Coefficients = 6, Iterations = 8;

/// Returns the targets of the interface that points of this rank follow, ascending.
std::vector<Index> ListTargets(const ActiveMesh& active, Index first, Index last)
{
  std::vector<Index> list;
  active.ForOwned(
    [&](int point)
    {
      for (CornerPosition i = active.AttachmentOffset[point];
           i < active.AttachmentOffset[point + 1]; ++i)
      {
        const Index target = active.Attachments[i].Target;
        if (target >= first && target < last)
        {
          list.push_back(target);
        }
      }
    });
  SortUnique(list);
  return list;
}

/// Returns the position in Interface::Nodes() of the node of a surface point.
Index NodeOf(const Interface& interface, Index point)
{
  Index low = 0, high = static_cast<Index>(interface.Nodes().size());
  while (high - low > 1)
  {
    const Index middle = (low + high) / 2;
    (interface.PointOffset(middle) <= point ? low : high) = middle;
  }
  return low;
}

} // namespace

void RefineTargets(const Interface& interface, const FractionField& fractions, Index firstTarget,
  const PairFilter& isSought, const ActiveMesh& active, Runtime& runtime, SurfaceTargets& targets)
{
  const auto points = static_cast<Index>(interface.Points().size());
  const std::vector<Index> list = ListTargets(active, firstTarget, firstTarget + points);
  ForEach(runtime, list.size(),
    [&](Index i)
    {
      const Index point = list[i] - firstTarget;
      const SurfacePoint& surface = interface.Points()[point];
      if (!isSought({ surface.First, surface.Second }))
      {
        return;
      }
      const NodeFrame frame = FrameOf(interface, NodeOf(interface, point));
      FeatureModel model = ModelOf(targets.QuadricOf(list[i], frame.Origin, frame.Widths));
      std::vector<SampleCell> cells;
      if (!GatherCells(interface, fractions, frame, { { surface.First, surface.Second } },
            NarrowStencil, cells))
      {
        return;
      }
      const PackedCells packed = cells;
      const double before = ResidualOf(model, packed);
      FitModel(model, packed, Coefficients, Iterations);
      if (ResidualOf(model, packed) < before)
      {
        targets.Replace(list[i], model.Surfaces[0], frame.Origin, frame.Widths);
      }
    });
}

} // namespace vfm
