/**
 * VtkVersions: one interface to functions that differ between versions of VTK and between builds
 * with and without ParaView. Only this file tests for versions.
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

/// Executive of algorithms whose input may have blocks. ParaView's proxies replace every
/// executive except their own.
#ifdef VFM_HAS_PARAVIEW
using CompositePipeline = vtkPVCompositeDataPipeline;
#else
using CompositePipeline = vtkCompositeDataPipeline;
#endif

/// Refined grids (AMR). Since VTK 9.6 their levels are blocks of a vtkPartitionedDataSetCollection,
/// and their boxes are partitions.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
using RefinedGrids = vtkAMRDataObject;

/// Allocates the levels and boxes of refined grids.
/// @param boxes  number of boxes per level
template <class Grids>
void SetNumberOfBoxes(Grids* grids, const std::vector<unsigned int>& boxes)
{
  grids->Initialize(boxes);
}

inline unsigned int NumberOfBoxes(RefinedGrids* grids, unsigned int level)
{
  return grids->GetNumberOfBlocks(level);
}

/// Returns the data of a box; null if they are on another rank or not read.
inline vtkDataSet* GetBox(RefinedGrids* grids, unsigned int level, unsigned int box)
{
  return grids->GetPartition(level, box);
}

/// Defined if VTK has arrays that compute their values: vtkConstantArray, vtkAffineArray.
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
#endif

} // namespace vfm
