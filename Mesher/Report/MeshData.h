/**
 * MeshData: one rank's mesh with its named arrays, as input of reports and file writers.
 *
 * It is a view of a mesh: of a Mesh (ViewMesh), of VTK or NumPy arrays, or of arrays of a file.
 * Members that Mesh has, too, have its names, types and order of values; MeshArrays.h lists those
 * per point and element once for both. The creator of a MeshData owns the memory; StoredMesh owns
 * its memory. Only ModifyMesh, which changes the mesh, copies a MeshData to a Mesh (MakeMeshOf).
 */
#pragma once

#include "Elements/Mesh.h"
#include "Input/FieldArray.h"
#include "Input/ValueType.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
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

struct ParticleData;

/// A view of a mesh. Members that Mesh has are described there; materials have the ids of the user.
/// Pointers to missing arrays, and to arrays without values, are null.
struct MeshData : NodeCounts
{
  Index NumberOfPoints = 0, NumberOfElements = 0;
  const double* Points = nullptr;
  const Index *Elements = nullptr, *MidPoints = nullptr;
  ///@{ Values of points
  const Index *PointIds = nullptr, *PeriodicPartner = nullptr, *OriginalPointIds = nullptr;
  const int *GeometryDimension = nullptr, *GeometryId = nullptr;
  ///@}
  ///@{ Values of elements
  const Index* ElementIds = nullptr;
  const int *Material = nullptr, *Fragment = nullptr, *Layer = nullptr;
  const float* ScaledJacobian = nullptr;
  ///@}
  std::vector<MeshArray> PointArrays, ElementArrays; ///< all arrays of files, also the ones above
  /// Arrays of the whole mesh, equal on all ranks, except rows of a rank: tables with SurfaceIds
  /// (ListSides), and those for which IsFieldOfRank is true (FragmentTargets.h).
  std::vector<FieldArray> Fields;
  std::optional<double> Time;
  /// Facets ascending by element and side, if the mesher made the mesh; null: MeshFacets.h
  /// finds them.
  const std::vector<MeshFacet>* Facets = nullptr;
  const ParticleData* Particles = nullptr; ///< null: the mesh was made without particles

  const Index* Element(Index element) const { return this->Elements + this->Corners * element; }
  /// Calls visit(first, last) for the corners, then for the mid nodes of an element.
  template <class Visit>
  void ForNodes(Index element, const Visit& visit) const
  {
    visit(this->Element(element), this->Element(element + 1));
    const Index* mids = this->MidPoints + this->MidsPerElement * element;
    visit(mids, mids + this->MidsPerElement);
  }
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

/// Returns a view of a mesh with its arrays, without fields.
/// @param mesh  must outlive the result
MeshData ViewMesh(const Mesh& mesh);

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

/// Sets the pointers of Data to the arrays of MeshArrays.h: views, or converted copies if types
/// differ. Arrays with several components or without values count as missing.
void FindKnownArrays(StoredMesh& mesh);
/// Returns the mesh with only its known arrays, unless they are only shown, and the arrays for
/// which isTaken(array) is true.
MeshData TakeKnownArrays(MeshData mesh, const std::function<bool(const MeshArray&)>& isTaken = {});

/// Returns the array with a name, or null.
const MeshArray* FindArray(const std::vector<MeshArray>& arrays, std::string_view name);
/// Returns the array with a name. Throws InputError if it is missing.
const MeshArray& GetArray(const std::vector<MeshArray>& arrays, std::string_view name);
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
