#include "vtkVolumeFractionToHex.h"

#include "Mesher.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVolumeFractionToHex);

vtkVolumeFractionToHex::vtkVolumeFractionToHex() :
  vtkVolumeFractionMeshAlgorithm(vfm::ElementKind::Hexes)
{
}
