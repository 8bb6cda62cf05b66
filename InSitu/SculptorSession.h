/**
 * SculptorSession: what stands behind a handle of the C interface: the fields that a host gave, the mesh made of them
 * by the filters, and the arrays that the host asks for. Throws InputError on wrong arguments and SculptorError on the rest.
 */
#pragma once

#include "FragmentParts.h"
#include "GeometryParts.h"
#include "HostBlocks.h"
#include "HostCommunicator.h"
#include "HostWishes.h"
#include "VtkMessages.h"

#include "vtkNew.h"

#include <functional>
#include <map>
#include <optional>
#include <stdexcept>

class vtkDoubleArray;
class vtkIntArray;
class vtkUnstructuredGrid;
class vtkVolumeFractionMeshAlgorithm;
class vtkVolumeFractionToHex;
class vtkVolumeFractionToTet;

namespace vfm
{

/// A failure that is no wrong argument, with its SculptorCode.
struct SculptorError : std::runtime_error
{
  SculptorError(int code, const std::string& message) : std::runtime_error(message), Code(code) {}
  int Code;
};

class SculptorSession
{
public:
  SculptorSession();
  ~SculptorSession();

  void SetCommunicator(int communicator) { this->Communicator.Set(communicator); }
  /// Of the filters, or IndexBase.
  void SetOption(const std::string& name, const std::string& value);
  /// Null: not known.
  void SetNeighbours(const int* ranks);
  HostBlocks Blocks; ///< what is missing or wrong there is told by MakeMesh, on all ranks
  HostWishes Wishes; ///< for the next mesh, of its blocks
  /// Collective. prepare: sets fields and options; when it fails on any rank, all fail.
  void MakeMesh(bool tets, const std::function<void()>& prepare);

  /// The mesh and its parts; throw SculptorError when there is none.
  vtkUnstructuredGrid* GetMesh() const;
  const FragmentParts& GetFragmentParts();
  /// dimension: 2 facets, 1 edges of curves, 0 vertices.
  GeometryParts::Cells GetGeometryCells(int dimension);
  vtkIntArray* GetGeometryTable(const std::string& name) const;
  int GetNumberOfFragments() const;
  /// The values of a cell or point array by name, of the type T that it must have.
  template <class T>
  const T* GetCellValues(const char* name) const;
  template <class T>
  const T* GetPointValues(const char* name) const;
  /// A state that was carried along, of the elements or of the points.
  vtkDoubleArray* GetState(const std::string& name) const;
  vtkDoubleArray* GetPointState(const std::string& name) const;
  double GetNumber(const std::string& name, int index) const;
  /// Collective.
  void Write(const char* path);

  int GetIndexBase() const { return this->IndexBase; }
  const std::string& GetWarningText() const { return this->WarningText; }

private:
  vtkVolumeFractionMeshAlgorithm* GetMesher(bool tets) const;
  void CheckNeighbours() const;
  std::string Describe(bool tets) const;
  void Configure(vtkVolumeFractionMeshAlgorithm* mesher, const FieldNames& names,
    vtkMultiProcessController* controller);
  void Run(vtkVolumeFractionMeshAlgorithm* mesher, const HostGrid& grid);

  HostCommunicator Communicator;
  vtkNew<vtkVolumeFractionToHex> Hexes;
  vtkNew<vtkVolumeFractionToTet> Tets;
  std::map<std::string, std::string> Options; // set by name, to compare between ranks
  int IndexBase = 0;
  std::optional<std::array<int, 6>> Neighbours;
  vtkSmartPointer<vtkUnstructuredGrid> Mesh;
  std::optional<FragmentParts> Parts; // made when first asked for
  std::optional<GeometryParts> Geometry;
  std::string WarningText;
};

} // namespace vfm
