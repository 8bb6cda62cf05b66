/**
 * PackedLists: what a mesh and its facets have beside corners, in less memory while points move. Of
 * it only the initial places of points are read then.
 */
#pragma once

#include "Elements/Facet.h"
#include "Elements/Mesh.h"
#include "Smoothing/ActiveMesh.h"

#include <cstdint>
#include <vector>

namespace vfm
{

/// Whole numbers as differences, in one byte each if these are small.
class PackedNumbers
{
public:
  /// Appends a number.
  void Add(std::int64_t difference);
  /// Frees memory that is not used.
  void Finish() { this->Bytes.shrink_to_fit(); }

  /// Returns the numbers one after another.
  class Reader
  {
  public:
    explicit Reader(const PackedNumbers& numbers) : Byte(numbers.Bytes.data()) {}
    std::int64_t Next();

  private:
    const unsigned char* Byte;
  };

private:
  std::vector<unsigned char> Bytes;
};

/// An array of whole numbers of which most differ little from the one before.
template <class T>
class PackedArray
{
public:
  /// Takes the numbers.
  explicit PackedArray(Buffer<T>& numbers) : Count(numbers.size())
  {
    std::int64_t last = 0;
    for (T number : numbers)
    {
      this->Differences.Add(number - last);
      last = number;
    }
    this->Differences.Finish();
    numbers = Buffer<T>();
  }
  /// Returns the numbers.
  Buffer<T> Unpack() const
  {
    Buffer<T> numbers(this->Count);
    PackedNumbers::Reader reader(this->Differences);
    std::int64_t last = 0;
    for (T& number : numbers)
    {
      last += reader.Next();
      number = static_cast<T>(last);
    }
    return numbers;
  }

private:
  std::size_t Count;
  PackedNumbers Differences;
};

/// Facets in some 12 bytes each.
class PackedFacets
{
public:
  /// Takes the facets.
  /// @pre All cells of a fragment have one material, and cells without a fragment are void.
  explicit PackedFacets(std::vector<Facet>& facets);
  /// Returns the facets.
  std::vector<Facet> Unpack() const;

private:
  std::size_t Count;
  PackedNumbers Numbers;
  std::vector<int> Materials; // material of each fragment
};

/// Points of a mesh, apart from those of an active mesh.
class PackedPoints
{
public:
  /// Takes the points, and stores the starts of the active mesh in it. If the points are at too
  /// many different places, leaves them as they are.
  PackedPoints(Buffer<double>& points, ActiveMesh& active);
  /// Fills the points again, with equal values.
  /// @param active  mesh of the constructor
  void Unpack(Buffer<double>& points, ActiveMesh& active) const;

private:
  std::vector<int> ListOthers(const ActiveMesh& active) const;

  Index Count;        // number of points
  CodedPoints Others; // those that the active mesh does not have
};

/// What a mesh has beside corners and ids of points.
class PackedMesh
{
public:
  /// Takes it.
  /// @param active  active mesh of the mesh, which gets ActiveMesh::Starts
  PackedMesh(Mesh& mesh, ActiveMesh& active) :
    ElementIds(mesh.ElementIds),
    Material(mesh.Material),
    Fragment(mesh.Fragment),
    Dimension(mesh.GeometryDimension),
    Geometry(mesh.GeometryId),
    Points(mesh.Points, active)
  {
  }
  /// Gives it back.
  void Unpack(Mesh& mesh, ActiveMesh& active) const
  {
    mesh.ElementIds = this->ElementIds.Unpack();
    mesh.Material = this->Material.Unpack();
    mesh.Fragment = this->Fragment.Unpack();
    mesh.GeometryDimension = this->Dimension.Unpack();
    mesh.GeometryId = this->Geometry.Unpack();
    this->Points.Unpack(mesh.Points, active);
  }

private:
  PackedArray<Index> ElementIds;
  PackedArray<int> Material, Fragment, Dimension, Geometry;
  PackedPoints Points;
};

} // namespace vfm
