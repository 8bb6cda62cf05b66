/**
 * ExodusModel: a rank's part of a mesh in the numbering of Exodus, where elements stand block by block, and what it must know of
 * the other parts.
 */
#pragma once

#include "ExodusVariables.h"
#include "Summary/MeshSets.h"
#include "Summary/SharedPoints.h"

#include "vtkSmartPointer.h"

class vtkIdTypeArray;
class vtkUnstructuredGrid;

namespace vfm
{

struct ExodusBlock
{
  int Id; ///< the material's; of the void, material 0, FindVoidId()
  std::string Name;
  std::vector<vtkIdType> Cells; ///< of the mesh of this rank, ascending
  Index Total = 0;              ///< elements on all ranks
};

struct ExodusModel
{
  vtkSmartPointer<vtkUnstructuredGrid>
    Mesh; ///< of this rank; points and cells in the order of their ids
  vtkSmartPointer<vtkIdTypeArray> PointIds, CellIds;
  bool IsTets = false;
  std::vector<ExodusBlock> Blocks; ///< the same on all ranks, by id
  std::vector<Index> Elements;     ///< of each cell its number in the file, from 1
  MeshSets Sets;                   ///< the same on all ranks, names that are there once
  std::vector<Index> SideTotals;   ///< sides of each side set on all ranks
  std::vector<Index> NodeTotals; ///< nodes of each node set on all ranks, those between ranks once
  Index TotalNodes = 0, TotalElements = 0;
  SharedPoints Sharing;
  std::vector<ExodusVariable> PointVariables, CellVariables;
  std::vector<ExodusNumber> Numbers;
  double Time = 0.0;
  std::size_t LongestName = 0;
  bool HasWideIds = false;     ///< some id is greater than 2^31 - 1
  bool HasLargeArrays = false; ///< some array is more than the classic file format can hold, 4 GiB
};

/// Collective. mesh: of hexahedra or of tetrahedra, with MaterialId, GlobalCellIds and GlobalPointIds from 1. Throws InputError, on
/// all ranks alike, when it is something else.
ExodusModel MakeExodusModel(vtkUnstructuredGrid* mesh, Ranks& ranks);

} // namespace vfm
