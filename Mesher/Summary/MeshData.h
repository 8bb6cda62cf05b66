/**
 * MeshData: one rank's mesh with its named arrays, in the form that reports and files are made from.
 *
 * All pointers are views: whoever made the MeshData owns the memory and keeps it. StoredMesh owns it.
 */
#pragma once

#include "Input/FieldArray.h"
#include "Input/ValueType.h"
#include "Mesh/MeshFacet.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vfm
{

/// Values of points or elements, shape (tuples, Components), row-major.
struct MeshArray
{
  std::string Name;
  int Type = ValueType::Double; ///< type of the numbers in memory, one of ValueType
  int Components = 1;
  std::vector<std::string> ComponentNames; ///< empty, or one per component
  const void* Values = nullptr;
};

/// Pointers to arrays that the mesh lacks, or has no values of, are null.
struct MeshData
{
  int Corners = 8; ///< of an element: 8 hexahedra, 4 tetrahedra
  Index NumberOfPoints = 0, NumberOfElements = 0;
  const double* Points = nullptr;         ///< (points, 3)
  const Index* Elements = nullptr;        ///< (elements, Corners), points from 0, VTK's order
  const Index* PointIds = nullptr;        ///< global, from 1
  const Index* ElementIds = nullptr;      ///< global, from 1
  const int* Material = nullptr;          ///< material id of each element; 0 void
  const int* Fragment = nullptr;          ///< of each element, from 1
  const int* GeometryDimension = nullptr; ///< of each point: 3 volume, 2 surface, 1 curve, 0 vertex
  const int* GeometryId = nullptr;        ///< of each point, from 1 within its dimension
  std::vector<MeshArray> PointArrays, ElementArrays; ///< all that files contain, those above too
  std::vector<FieldArray> Fields;                    ///< of the whole mesh, the same on all ranks
  std::optional<double> Time;
  /// Ascending by element and side, where the mesher made the mesh; else they are searched for (MeshFacets.h).
  const std::vector<MeshFacet>* Facets = nullptr;

  const Index* Element(Index element) const { return this->Elements + this->Corners * element; }
  const double* Point(Index point) const { return this->Points + 3 * point; }
};

/// A mesh with the memory that its pointers view.
struct StoredMesh
{
  MeshData Data;
  std::vector<std::shared_ptr<const void>> Memory;

  /// Keeps the values and returns a view of them.
  template <class T>
  const T* Store(std::vector<T> values)
  {
    auto kept = std::make_shared<const std::vector<T>>(std::move(values));
    this->Memory.push_back(kept);
    return kept->data();
  }
};

/// Sets the pointers of Data to its arrays of these names: views, or converted copies where their type is another. Arrays with several
/// components, and arrays without values, count as missing.
void FindKnownArrays(StoredMesh& mesh);

/// The array of that name, or null.
const MeshArray* FindArray(const std::vector<MeshArray>& arrays, const std::string& name);
/// The same; throws InputError without one.
const MeshArray& GetArray(const std::vector<MeshArray>& arrays, const std::string& name);
[[noreturn]] void RejectMissing(const std::string& name);
/// A pointer of MeshData; throws InputError when it is null, though there are elements.
template <class T>
const T* Require(const T* values, const char* name, const MeshData& mesh)
{
  if (!values && mesh.NumberOfElements > 0)
  {
    RejectMissing(name);
  }
  return values;
}

double ValueAt(const MeshArray& array, Index tuple, int component = 0);

/// The field of that name, or null.
const FieldArray* FindField(const std::vector<FieldArray>& fields, const std::string& name);
/// The numbers of a field tuple by tuple; none of texts and without such a field.
std::vector<double> NumbersOfField(const std::vector<FieldArray>& fields, const std::string& name);

} // namespace vfm
