/**
 * MeshData: one rank's mesh with its named arrays, as input of reports and file writers.
 *
 * All pointers are views; the creator of a MeshData owns the memory. StoredMesh owns its memory.
 */
#pragma once

#include "Base/Vector3.h"
#include "Elements/ElementShape.h"
#include "Elements/MeshFacet.h"
#include "Input/FieldArray.h"
#include "Input/ValueType.h"

#include <functional>
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

/// A view of a mesh. Pointers to missing arrays, and to arrays without values, are null.
struct MeshData
{
  int Corners = 8; ///< corners of an element: 8 hexahedra, 4 tetrahedra
  Index NumberOfPoints = 0, NumberOfElements = 0;
  const double* Points = nullptr;   ///< (points, 3)
  const Index* Elements = nullptr;  ///< (elements, Corners), points from 0, VTK's order
  int MidsPerElement = 0;           ///< mid nodes of an element (MidNodes.h): 0, 12, 19 or 6
  const Index* MidPoints = nullptr; ///< (elements, MidsPerElement), points from 0, VTK's order
  const Index* PointIds = nullptr;  ///< global ids of points, from 1
  /// Lowest global id among the copies of each point on opposite sides of a periodic mesh.
  const Index* PeriodicPartner = nullptr;
  /// Global ids of points before interfaces were split (Modify/SplitInterfaces.h).
  const Index* OriginalPointIds = nullptr;
  const Index* ElementIds = nullptr;      ///< global ids of elements, from 1
  const int* Material = nullptr;          ///< material id of each element; 0 void
  const int* Fragment = nullptr;          ///< fragment of each element, from 1
  const int* GeometryDimension = nullptr; ///< each point: 3 volume, 2 surface, 1 curve, 0 vertex
  const int* GeometryId = nullptr;        ///< id of each point, from 1 within its dimension
  std::vector<MeshArray> PointArrays, ElementArrays; ///< all arrays of files, also the ones above
  std::vector<FieldArray> Fields; ///< arrays of the whole mesh, equal on all ranks
  std::optional<double> Time;
  /// Facets ascending by element and side, if the mesher made the mesh; null: MeshFacets.h
  /// finds them.
  const std::vector<MeshFacet>* Facets = nullptr;

  const Index* Element(Index element) const { return this->Elements + this->Corners * element; }
  /// Calls visit(first, last) for the corners, then for the mid nodes of an element.
  template <class Visit>
  void ForNodes(Index element, const Visit& visit) const
  {
    visit(this->Element(element), this->Element(element + 1));
    const Index* mids = this->MidPoints + this->MidsPerElement * element;
    visit(mids, mids + this->MidsPerElement);
  }
  const ElementShape& Shape() const { return ShapeOf(this->Corners, this->MidsPerElement); }
  bool HasHexes() const { return AreHexes(this->Corners); }
  int NodesPerElement() const { return this->Corners + this->MidsPerElement; }
  const double* Point(Index point) const { return this->Points + 3 * point; }
  /// Returns the global ids of points before interfaces were split.
  const Index* UnsplitPointIds() const
  {
    return this->OriginalPointIds ? this->OriginalPointIds : this->PointIds;
  }
  Vector3 PointAt(Index point) const
  {
    const double* x = this->Point(point);
    return { { x[0], x[1], x[2] } };
  }
};

/// Returns the mid nodes of a face of an element: of its edges in the order of its corners
/// (ElementFaces), then its centre; none for linear elements.
std::vector<Index> MidsOfFace(const MeshData& mesh, Index element, int face);

/// A mesh that shares ownership of the memory of its pointers.
struct StoredMesh
{
  MeshData Data;
  std::vector<std::shared_ptr<const void>> Memory;

  /// Stores the values and returns a view of them.
  template <class T>
  const T* Store(std::vector<T> values)
  {
    auto kept = std::make_shared<const std::vector<T>>(std::move(values));
    this->Memory.push_back(kept);
    return kept->data();
  }
};

/// Sets the pointers of Data to its named arrays: views, or converted copies if types differ.
/// Arrays with several components or without values count as missing.
void FindKnownArrays(StoredMesh& mesh);
/// Returns whether an array is one of the arrays that FindKnownArrays looks for.
bool IsKnownArray(const MeshArray& array);
/// Returns the mesh with only its known arrays and the arrays for which isTaken(array) is true.
MeshData TakeKnownArrays(MeshData mesh, const std::function<bool(const MeshArray&)>& isTaken = {});

/// Returns the array with a name, or null.
const MeshArray* FindArray(const std::vector<MeshArray>& arrays, const std::string& name);
/// Returns the array with a name. Throws InputError if it is missing.
const MeshArray& GetArray(const std::vector<MeshArray>& arrays, const std::string& name);
/// Throws InputError for a missing array.
[[noreturn]] void RejectMissing(const std::string& name);
/// Returns a pointer of MeshData. Throws InputError if it is null and the mesh has elements.
template <class T>
const T* Require(const T* values, const char* name, const MeshData& mesh)
{
  if (!values && mesh.NumberOfElements > 0)
  {
    RejectMissing(name);
  }
  return values;
}

/// Returns a value of an array as double.
double ValueAt(const MeshArray& array, Index tuple, int component = 0);

/// Returns the field with a name, or null.
const FieldArray* FindField(const std::vector<FieldArray>& fields, const std::string& name);
/// Returns the numbers of a field, row-major; empty if it has texts or does not exist.
std::vector<double> NumbersOfField(const std::vector<FieldArray>& fields, const std::string& name);

} // namespace vfm
