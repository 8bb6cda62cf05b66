/**
 * SculptorSession: the work of a handle of the C interface. It stores the fields of a host, makes a
 * mesh of them with the mesher and returns its arrays.
 */
#pragma once

#include "FragmentParts.h"
#include "HostBlocks.h"
#include "HostCommunicator.h"
#include "HostRefinement.h"
#include "Mesher.h"

#include <functional>
#include <map>
#include <optional>
#include <stdexcept>

namespace vfm
{

/// Fields, options and mesh of one handle. Owns the mesh and the duplicate of the communicator; the
/// values of fields belong to the host. Methods throw InputError; its code is ErrorCode::Unknown
/// for wrong arguments. One thread at a time may use a session.
class SculptorSession
{
public:
  /// Sets the communicator from a Fortran handle (HostCommunicator::Set).
  void SetCommunicator(int communicator) { this->Communicator.Set(communicator); }
  /// Sets an option of the mesher, or IndexBase.
  void SetOption(const std::string& name, const std::string& value);
  /// Sets the ranks across the faces -x +x -y +y -z +z, -1 at the ends of the grid.
  /// @param ranks  6 values, or null if they are not known
  void SetNeighbours(const int* ranks);
  HostBlocks Blocks;       ///< fields of this rank; MakeMesh checks them and reports on all ranks
  HostRefinement Requests; ///< selected cells of Blocks, for the next mesh only
  /// Makes the mesh and replaces the previous one. After an error there is no mesh on any rank.
  /// @param prepare  sets fields and options before they are checked
  /// @throws InputError  on all ranks, if prepare or the mesher fails on any rank
  /// @pre Collective
  void MakeMesh(bool tets, const std::function<void()>& prepare);

  ///@{ Throws InputError if there is no mesh, or if it lacks the named values.
  const Mesh& GetMesh() const { return this->GetResult().TheMesh; }
  const CohesiveElements& GetCohesive();
  const FragmentParts& GetFragmentParts();
  int GetNumberOfFragments() const;
  /// Returns a table of adjacency with integer values (ListSurfaces, ListCurves, ListVertices).
  const FieldArray& GetGeometryTable(const std::string& name);
  /// Return a transferred state of type double, of the elements, of the points or of the particles.
  const TransferredArray& GetState(const std::string& name) const;
  const TransferredArray& GetPointState(const std::string& name) const;
  const TransferredArray& GetParticleState(const std::string& name) const;
  /// Returns a view of the particles; empty without the option.
  ParticleData GetParticles() const;
  /// Returns entry `index` of an array of field data, counted from 0 over rows and components.
  double GetNumber(const std::string& name, int index) const;
  /// Writes the mesh of all ranks to a file whose suffix selects the format.
  /// @pre Collective
  void Write(const char* path);
  ///@}

  int GetIndexBase() const { return this->IndexBase; }
  const std::string& GetWarningText() const { return this->WarningText; }

private:
  const MesherResult& GetResult() const;
  void CheckNeighbours() const;
  std::string Describe(bool tets) const;
  MesherResult Run(
    bool tets, bool areCellsNamed, const FieldNames& names, const HostGrid& grid, Ranks& ranks);

  HostCommunicator Communicator;
  MesherOptions Options;
  std::map<std::string, std::string> Texts; // values of options by name, compared between ranks
  int IndexBase = 0;
  std::optional<std::array<int, 6>> Neighbours;
  std::optional<MesherResult> Result;
  std::optional<CohesiveElements> Cohesive; // Cohesive, Parts and Tables are made at first use
  std::optional<FragmentParts> Parts;
  FieldArrays Tables;
  std::string WarningText;
};

} // namespace vfm
