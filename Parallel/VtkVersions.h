/**
 * VtkVersions: what differs between versions of VTK and between builds with and without ParaView; no other file asks for them.
 */
#pragma once

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

} // namespace vfm
