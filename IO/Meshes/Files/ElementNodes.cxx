#include "Meshes/Files/ElementNodes.h"

#include "Ranks/Errors.h"
#include "Report/FlatData.h"
#include "Report/Sets/MeshSets.h"

#include <algorithm>
#include <numeric>

namespace vfm
{
namespace
{

std::vector<int> ChooseOrder(const MeshData& mesh, const MidOrders& orders)
{
  const int mids = mesh.MidsPerElement;
  std::vector<int> order = mids == 12 ? orders.Of20 : mids == 19 ? orders.Of27 : orders.Of10;
  if (order.empty() || mids == 0)
  {
    order.resize(mids);
    std::iota(order.begin(), order.end(), 0);
  }
  return order;
}

} // namespace

ElementNodes::ElementNodes(const MeshData& mesh, const MidOrders& orders) :
  TheMesh(mesh), Order(ChooseOrder(mesh, orders)), Points(mesh.NodesPerElement())
{
}

const Index* ElementNodes::Of(Index element)
{
  const MeshData& mesh = this->TheMesh;
  auto next = std::copy(mesh.Element(element), mesh.Element(element + 1), this->Points.begin());
  const Index* mids = mesh.MidPoints + mesh.MidsPerElement * element;
  std::transform(
    this->Order.begin(), this->Order.end(), next, [mids](int mid) { return mids[mid]; });
  return this->Points.data();
}

std::vector<Index> NodesOfSide(const MeshData& mesh, Index element, int side)
{
  const FaceIds corners = PointsOfSide(mesh, { element, side });
  std::vector<Index> points(corners.begin(), corners.begin() + CornersOfSide(mesh));
  const std::vector<Index> mids = MidsOfFace(mesh, element, side);
  points.insert(points.end(), mids.begin(), mids.end());
  return points;
}

void RequireNodes(const MeshData& mesh, std::initializer_list<int> mids, const char* format)
{
  if (mesh.MidsPerElement > 0 &&
    std::find(mids.begin(), mids.end(), mesh.MidsPerElement) == mids.end())
  {
    const bool isFull = mesh.MidsPerElement == 19;
    throw InputError("Files of " + std::string(format) + " are not written with elements of " +
      std::to_string(mesh.NodesPerElement()) + " nodes. Formats that are: .vtu, .e, .msh" +
      (isFull ? "" : ", .inp, .k") + ". ElementOrder Linear has no mid nodes.");
  }
}

} // namespace vfm
