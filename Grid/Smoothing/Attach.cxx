#include "Smoothing/Attach.h"

namespace vfm
{
namespace
{

/// The fragments below and above a face; 0 where not meshed, or far from the owned cells.
std::array<int, 2> FragmentsOfFace(
  const CartesianGrid& grid, const Fragments& fragments, const InterfaceFace& face)
{
  const Index3 upper = grid.Position(face.Node);
  Index3 lower = upper;
  --lower[face.Axis];
  if (!grid.HexBox().Contains(lower) || !grid.HexBox().Contains(upper))
  {
    return { { 0, 0 } };
  }
  return { { fragments.FragmentOfCell(lower), fragments.FragmentOfCell(upper) } };
}

void AddAttachments(const Interface& interface, const std::vector<int>& points, ActiveMesh& active)
{
  std::vector<Index> nodeOf(active.X.size(), -1);
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    if (points[n] >= 0)
    {
      nodeOf[points[n]] = static_cast<Index>(n);
    }
  }
  for (std::size_t p = 0; p < nodeOf.size(); ++p)
  {
    const Index n = nodeOf[p];
    for (Index t = n < 0 ? 0 : interface.PointOffset(n); n >= 0 && t < interface.PointOffset(n + 1);
         ++t)
    {
      active.Attachments.push_back({ t });
    }
    active.AttachmentOffset[p + 1] = static_cast<Index>(active.Attachments.size());
  }
}

} // namespace

void AttachToNodes(const Interface& interface, const std::vector<int>& points,
  const Fragments& fragments, const Partition& partition, ActiveMesh& active)
{
  AddAttachments(interface, points, active);
  for (std::size_t f = 0; f < interface.Faces().size(); ++f)
  {
    const InterfaceFace& face = interface.Faces()[f];
    const std::array<int, 2> sides = FragmentsOfFace(interface.Grid(), fragments, face);
    InterfaceFacet facet{ {}, sides[0], sides[1],
      partition.OwnsCell(interface.Grid().Position(face.Node)) };
    bool complete = true;
    for (int c = 0; c < 4; ++c)
    {
      const Index n = interface.NodesOfFace(static_cast<Index>(f))[c];
      const int point = points[n];
      facet.Points[c] = point;
      complete = complete && point >= 0;
      if (point < 0)
      {
        continue;
      }
      const bool ordered = face.LowerLabel < face.UpperLabel;
      const Index pair = interface.FindPoint(n, face.First(), face.Second()) -
        interface.Points().data() - interface.PointOffset(n);
      active.Attachments[active.AttachmentOffset[point] + pair].Fragments = {
        { sides[ordered ? 0 : 1], sides[ordered ? 1 : 0] }
      };
    }
    if (complete)
    {
      active.Facets.push_back(facet);
    }
  }
}

} // namespace vfm
