/**
 * Meshes of many fragments of two hexahedra, some of which touch, some on two ranks.
 */
#pragma once

#include "Report/MeshData.h"

namespace vfm
{
namespace testing
{

/// Elements of a rank. Fragment d + 1 has two of them in a row along x, and those of drops 2 d and
/// 2 d + 1 touch.
struct Drops
{
  std::vector<double> Points;
  std::vector<Index> PointIds, Elements, ElementIds;
  std::vector<int> Material, Fragment;
  std::vector<double> Density; ///< of each element

  /// Adds half of a drop.
  void Add(Index drop, int half)
  {
    const Index row = drop / 2, first = 2 * (drop % 2) + half; // a row has four elements
    for (int c = 0; c < 8; ++c)
    {
      const int x = c % 4 == 1 || c % 4 == 2, y = c % 4 >= 2, z = c / 4;
      this->Elements.push_back(static_cast<Index>(this->PointIds.size()));
      this->PointIds.push_back(1 + 20 * row + 4 * (first + x) + 2 * z + y);
      const double at[] = { static_cast<double>(first + x), static_cast<double>(2 * row + y),
        static_cast<double>(z) };
      this->Points.insert(this->Points.end(), at, at + 3);
    }
    this->ElementIds.push_back(1 + 4 * row + first);
    this->Material.push_back(static_cast<int>(1 + drop % 2));
    this->Fragment.push_back(static_cast<int>(drop + 1));
    this->Density.push_back(static_cast<double>(1 + drop % 7 + half));
  }
};

/// Makes the elements of a rank: all ranks have about as many, and every third drop is on two of
/// them.
inline Drops MakeDrops(Index count, int rank, int ranks)
{
  Drops drops;
  for (Index drop = 0; drop < count; ++drop)
  {
    const auto owner = static_cast<int>(drop * ranks / count);
    const int other = drop % 3 == 0 ? (owner + 1) % ranks : owner;
    for (int half = 0; half < 2; ++half)
    {
      if ((half == 0 ? owner : other) == rank)
      {
        drops.Add(drop, half);
      }
    }
  }
  return drops;
}

/// Returns a view of drops.
/// @param drops  must outlive the result
inline MeshData ViewDrops(const Drops& drops)
{
  MeshData mesh;
  mesh.Corners = 8;
  mesh.NumberOfPoints = static_cast<Index>(drops.PointIds.size());
  mesh.NumberOfElements = static_cast<Index>(drops.ElementIds.size());
  mesh.Points = drops.Points.data();
  mesh.PointIds = drops.PointIds.data();
  mesh.Elements = drops.Elements.data();
  mesh.ElementIds = drops.ElementIds.data();
  mesh.Material = drops.Material.data();
  mesh.Fragment = drops.Fragment.data();
  mesh.ElementArrays = { { "density", ValueType::Double, 1, {}, drops.Density.data() } };
  mesh.Fields = { { "MaterialNames", std::vector<std::string>{ "one", "two" } },
    { "MaterialIds", std::vector<int>{ 1, 2 } } };
  return mesh;
}

} // namespace testing
} // namespace vfm
