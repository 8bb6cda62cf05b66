#include "vtkVolumeFractionToHex.h"

#include "Mesher.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVolumeFractionToHex);

void vtkVolumeFractionToHex::SpecialiseOptions(vfm::MesherOptions& options) const
{
  options.Elements = vfm::ElementKind::Hexes;
}
