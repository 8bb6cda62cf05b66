/**
 * UnpackByVtk: unpacks blocks of VTK's XML files by the compressors of VTK.
 */
#pragma once

#include "GridFiles/VtkStorage.h"

namespace vfm
{

/// Function that unpacks blocks. VTK reports damaged ones as errors, which the caller silences.
UnpackVtkBlock UnpackByVtk();

} // namespace vfm
