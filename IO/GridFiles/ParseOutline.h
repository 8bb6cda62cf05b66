/**
 * ParseOutline: reads the elements of an XML file of VTK by Expat.
 */
#pragma once

#include "GridFiles/XmlOutline.h"

namespace vfm
{

/// Function of the type ReadVtkOutline.
XmlOutline ParseVtkOutline(const std::string& path);

} // namespace vfm
