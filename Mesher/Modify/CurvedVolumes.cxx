#include "Modify/CurvedVolumes.h"

#include "Base/ExactSum.h"
#include "Modify/CurvedElement.h"
#include "Octree/RefinedGrid.h"
#include "Report/ElementMoments.h"
#include "State/ViewMesh.h"

#include <cmath>
#include <map>

namespace vfm
{
namespace
{

/// Returns the nodes of an element without those of faces and the centre, and whether a mid node of
/// an edge is off the middle.
bool FindNodes(
  const Mesh& mesh, Index element, const PeriodImages& images, CurvedElement::Nodes& nodes)
{
  const MidNodes mids(mesh.Corners, mesh.MidsPerElement);
  const Index* corners = mesh.Elements.data() + mesh.Corners * element;
  const Index* points = mesh.MidPoints.data() + mesh.MidsPerElement * element;
  const Vector3 first = mesh.PointAt(corners[0]);
  const auto at = [&](Index point) { return images.Near(mesh.PointAt(point), first); };
  std::transform(corners, corners + mesh.Corners, nodes.begin(), at);
  bool isCurved = false;
  for (int e = 0; e < mids.Edges; ++e)
  {
    const int(&ends)[2] = mids.EdgeCorners[e];
    const Vector3 x = at(points[e]);
    nodes[mesh.Corners + e] = x;
    isCurved |= x != 0.5 * (nodes[ends[0]] + nodes[ends[1]]);
  }
  return isCurved;
}

} // namespace

std::vector<double> MeasureCurvedVolumes(
  const Mesh& mesh, const std::vector<int>& labels, const FieldArrays& fields, Runtime& runtime)
{
  Ranks& ranks = runtime.Group();
  const PeriodImages images(fields, ranks.Any(!mesh.PeriodicPartner.empty()));
  const CurvedElement& shape = GetCurvedElement(mesh.Corners);
  std::vector<double> volumes;
  for (const ElementMoments& element : FindElementMoments(ViewMesh(mesh, {}, fields)))
  {
    volumes.push_back(element.Volume);
  }
  ForEach(runtime, volumes.size(),
    [&](Index element)
    {
      CurvedElement::Nodes nodes;
      if (FindNodes(mesh, element, images, nodes))
      {
        volumes[element] = shape.Volume(nodes);
      }
    });
  std::map<int, std::size_t> materials;
  for (std::size_t m = 0; m < labels.size(); ++m)
  {
    materials[labels[m]] = m;
  }
  const int exponent =
    3 * std::ilogb(mesh.Levels->Finest().MeanWidth()); // sums are of numbers near 1
  std::vector<ExactSum> sums(labels.size());
  for (std::size_t e = 0; e < volumes.size(); ++e)
  {
    sums[materials.at(mesh.Material[e])].Add(std::ldexp(volumes[e], -exponent));
  }
  std::vector<double> all = SumOverRanks(sums, ranks);
  for (double& volume : all)
  {
    volume = std::ldexp(volume, exponent);
  }
  return all;
}

} // namespace vfm
