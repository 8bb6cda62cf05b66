#include "vtkVolumeFractionToTet.h"

#include "Mesher.h"
#include "Phases/MeshOfCells.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVolumeFractionToTet);

vtkVolumeFractionToTet::vtkVolumeFractionToTet() :
  vtkVolumeFractionMeshAlgorithm(vfm::ElementKind::Tets)
{
}

bool vtkVolumeFractionToTet::HasTetGen()
{
  return vfm::HasTetGen();
}
