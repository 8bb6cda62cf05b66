/**
 * VtkVersions: what differs between versions of VTK and between builds with and without ParaView; no other file asks for them.
 */
#pragma once

#include "vtkUniformGrid.h"
#include "vtkUniformGridAMR.h"
#include "vtkVersionMacros.h"

#include <vector>

#ifdef VFM_HAS_PARAVIEW
#include "vtkPVCompositeDataPipeline.h"
#else
#include "vtkCompositeDataPipeline.h"
#endif

namespace vfm
{

/// The executive of algorithms whose input may have blocks. Proxies of ParaView put any but their own aside.
#ifdef VFM_HAS_PARAVIEW
using CompositePipeline = vtkPVCompositeDataPipeline;
#else
using CompositePipeline = vtkCompositeDataPipeline;
#endif

/// Since VTK 9.6 levels of refined grids (AMR) are blocks of a vtkPartitionedDataSetCollection, whose boxes are their partitions.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
using RefinedGrids = vtkAMRDataObject;

/// boxes: of each level.
template <class Grids>
void SetNumberOfBoxes(Grids* grids, const std::vector<unsigned int>& boxes)
{
  grids->Initialize(boxes);
}

inline unsigned int NumberOfBoxes(RefinedGrids* grids, unsigned int level)
{
  return grids->GetNumberOfBlocks(level);
}

/// Null where the data are on another rank, or not read.
inline vtkDataSet* GetBox(RefinedGrids* grids, unsigned int level, unsigned int box)
{
  return grids->GetPartition(level, box);
}

/// Of a vtkIOSSReader of several files: each may have blocks and variables of its own. Before it looks at them.
template <class Reader>
void LookAtAllFiles(Reader* reader)
{
  reader->ReadAllFilesToDetermineStructureOn();
}

/// Of one that has looked at its files: not what holds for the mesh as a whole.
template <class Reader>
void ReadNoGlobalFields(Reader* reader)
{
  reader->GetGlobalFieldSelection()->DisableAllArrays();
}

/// There are arrays that compute their values: vtkConstantArray, vtkAffineArray.
#define VFM_HAS_COMPUTED_ARRAYS
#else
using RefinedGrids = vtkUniformGridAMR;

template <class Grids>
void SetNumberOfBoxes(Grids* grids, const std::vector<unsigned int>& boxes)
{
  const std::vector<int> counts(boxes.begin(), boxes.end());
  grids->Initialize(static_cast<int>(counts.size()), counts.data());
}

inline unsigned int NumberOfBoxes(RefinedGrids* grids, unsigned int level)
{
  return grids->GetNumberOfDataSets(level);
}

inline vtkDataSet* GetBox(RefinedGrids* grids, unsigned int level, unsigned int box)
{
  return grids->GetDataSet(level, box);
}

template <class Reader>
void LookAtAllFiles(Reader*)
{
}

template <class Reader>
void ReadNoGlobalFields(Reader* reader)
{
  reader->ReadGlobalFieldsOff();
}
#endif

} // namespace vfm
