/**
 * A block of unit cubes as an active mesh, all of whose points may move.
 */
#pragma once

#include "Smoothing/ActiveMesh.h"

namespace vfm
{
namespace testing
{

/// Returns a block of cubes with `points` points along each axis, x fastest.
inline ActiveMesh MakeHexBlock(int points)
{
  ActiveMesh mesh;
  mesh.Widths = { { { 1.0, 1.0, 1.0 } } };
  std::vector<MoveOrder::Node> nodes;
  const int count = points * points * points;
  for (int p = 0; p < count; ++p)
  {
    const int x = p % points, y = p / points % points, z = p / points / points;
    mesh.X.push_back({ { double(x), double(y), double(z) } });
    nodes.push_back({ { { x, y, z } }, (x & 1) + 2 * (y & 1) + 4 * (z & 1), { p, p + 1 } });
    for (int c = 0; c < 8 && std::max({ x, y, z }) + 1 < points; ++c)
    {
      mesh.Elements.push_back(p + (c & 1) + points * (c >> 1 & 1) + points * points * (c >> 2 & 1));
    }
  }
  mesh.IsActive.assign(count, 1);
  mesh.Fixed.assign(count, 0);
  mesh.AttachmentOffset.assign(count + 1, 0);
  mesh.Order = MoveOrder::ByPlanes(nodes, PointExchange());
  mesh.ListCorners();
  Runtime serial;
  mesh.Rings = HexRings(mesh, serial);
  return mesh;
}

} // namespace testing
} // namespace vfm
