/**
 * SculptorSession: what stands behind a handle of the C interface: the fields that a host gave, the mesh made of them
 * by the mesher, and the arrays that the host asks for. Throws InputError, without a code on wrong arguments.
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

class SculptorSession
{
public:
  void SetCommunicator(int communicator) { this->Communicator.Set(communicator); }
  /// Of the mesher, or IndexBase.
  void SetOption(const std::string& name, const std::string& value);
  /// Null: not known.
  void SetNeighbours(const int* ranks);
  HostBlocks Blocks;       ///< what is missing or wrong there is told by MakeMesh, on all ranks
  HostRefinement Requests; ///< for the next mesh, of its blocks
  /// Collective. prepare: sets fields and options; when it fails on any rank, all fail.
  void MakeMesh(bool tets, const std::function<void()>& prepare);

  ///@{ Throw InputError when there is no mesh.
  const Mesh& GetMesh() const { return this->GetResult().TheMesh; }
  const FragmentParts& GetFragmentParts();
  int GetNumberOfFragments() const;
  /// A table of integers, of what bounds what, by its name.
  const FieldArray& GetGeometryTable(const std::string& name);
  /// A state of doubles that was carried along, of the elements or of the points.
  const TransferredArray& GetState(const std::string& name) const;
  const TransferredArray& GetPointState(const std::string& name) const;
  double GetNumber(const std::string& name, int index) const;
  /// Collective.
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
  std::map<std::string, std::string> Texts; // options set by name, to compare between ranks
  int IndexBase = 0;
  std::optional<std::array<int, 6>> Neighbours;
  std::optional<MesherResult> Result;
  std::optional<FragmentParts> Parts; // these when first asked for
  FieldArrays Tables;
  std::string WarningText;
};

} // namespace vfm
