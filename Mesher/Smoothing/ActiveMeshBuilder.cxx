#include "Smoothing/ActiveMeshBuilder.h"

#include "Base/Groups.h"

namespace vfm
{
namespace
{

constexpr Index ElementsOfBlock = 4096; // elements per task

} // namespace

ActiveMeshBuilder::ActiveMeshBuilder(int corners, std::size_t points, std::vector<Mover> movers) :
  Movers(std::move(movers))
{
  std::sort(this->Movers.begin(), this->Movers.end(),
    [](const Mover& a, const Mover& b)
    { return a.Node != b.Node ? a.Node < b.Node : a.Id < b.Id; });
  this->Result.Corners = corners;
  this->Result.PointOf.assign(points, -1);
  this->Result.MeshPoint.reserve(this->Movers.size());
  for (const Mover& mover : this->Movers)
  {
    this->AddPoint(mover.MeshPoint);
  }
}

int ActiveMeshBuilder::AddPoint(Index meshPoint)
{
  const int point = static_cast<int>(this->Result.MeshPoint.size());
  this->Result.MeshPoint.push_back(static_cast<int>(meshPoint));
  return this->Result.PointOf[meshPoint] = point;
}

std::vector<Index> ActiveMeshBuilder::AddAround(const Mesh& mesh, Runtime& runtime)
{
  std::vector<Index> elements =
    CollectItems<Index>(runtime, mesh.ElementIds.size(), ElementsOfBlock,
      [&](Index e, std::vector<Index>& found)
      {
        if (this->HasMover(mesh.Elements.data() + mesh.Corners * e))
        {
          found.push_back(e);
        }
      });
  this->Result.Elements.reserve(mesh.Corners * elements.size());
  for (Index e : elements)
  {
    this->Add(mesh.Elements.data() + mesh.Corners * e);
  }
  return elements;
}

/// Lists the nodes of the owned movers, because only they move on this rank. Frees the movers,
/// which would add to the peak of memory.
std::vector<MoveOrder::Node> ActiveMeshBuilder::TakeNodes(const Partition* partition)
{
  std::vector<MoveOrder::Node> nodes;
  const int count = static_cast<int>(this->Movers.size());
  nodes.reserve(count); // an upper bound; unused memory is never touched
  for (int first = 0, last = 0; first < count; first = last)
  {
    const Mover& mover = this->Movers[first];
    while (last < count && this->Movers[last].Node == mover.Node)
    {
      ++last;
    }
    if (!partition || partition->OwnsNode(mover.Owner))
    {
      nodes.push_back({ mover.Owner, mover.Colour, { first, last } });
    }
  }
  std::vector<Mover>().swap(this->Movers);
  return nodes;
}

/// Requests the flags only of ghost movers that share an element with an owned mover; most do not.
void ActiveMeshBuilder::RequestFlags(const std::vector<MoveOrder::Node>& nodes)
{
  const ActiveMesh& mesh = this->Result;
  std::vector<unsigned char> isOwned(mesh.MeshPoint.size(), 0), isNear(isOwned);
  for (const MoveOrder::Node& node : nodes)
  {
    std::fill(isOwned.begin() + node.Points.First, isOwned.begin() + node.Points.Last, 1);
  }
  for (auto points = mesh.Elements.begin(); points != mesh.Elements.end(); points += mesh.Corners)
  {
    if (std::any_of(points, points + mesh.Corners, [&](int point) { return isOwned[point]; }))
    {
      std::for_each(points, points + mesh.Corners, [&](int point) { isNear[point] = 1; });
    }
  }
  this->Result.Exchange.RequestFlags(isNear);
}

/// Returns the result with the arrays that have one entry per point.
ActiveMesh ActiveMeshBuilder::TakeResult(std::size_t movers)
{
  const std::size_t points = this->Result.MeshPoint.size();
  this->Result.X.resize(points);
  this->Result.Fixed.assign(points, 0);
  this->Result.IsActive.assign(points, 0);
  std::fill_n(this->Result.IsActive.begin(), movers, 1);
  this->Result.AttachmentOffset.assign(points + 1, 0);
  return std::move(this->Result);
}

ActiveMesh ActiveMeshBuilder::FinishAlone()
{
  const std::size_t movers = this->Movers.size();
  this->Result.Order = MoveOrder::ByColour(this->TakeNodes(nullptr), 8);
  return this->TakeResult(movers);
}

ActiveMesh ActiveMeshBuilder::Finish(
  const Partition& partition, const MoverCopies& copies, int colours, Nodes which)
{
  const std::size_t movers = this->Movers.size();
  this->Result.Exchange = PointExchange(this->Movers, partition, colours, copies);
  const std::vector<MoveOrder::Node> nodes = this->TakeNodes(&partition);
  if (this->Result.Exchange.HasPeers() &&
    this->Result.HasHexes()) // tets may get other points (DiagonalFlips)
  {
    this->RequestFlags(nodes);
  }
  this->Result.Order = which == Nodes::OfGrid ? MoveOrder::ByPlanes(nodes, this->Result.Exchange)
                                              : MoveOrder::ByColour(nodes, colours);
  return this->TakeResult(movers);
}

} // namespace vfm
