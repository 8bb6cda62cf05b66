#include "vtkVolumeFractionToHex.h"

#include "HexPipeline.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVolumeFractionToHex);

vfm::Mesh vtkVolumeFractionToHex::MakeMesh(const vfm::CartesianGrid& grid,
  const vfm::FractionField& fractions, const vfm::MeshOptions& options, vfm::Runtime& runtime,
  vfm::MeshReport& report)
{
  return vfm::MakeHexMesh(grid, fractions, options, runtime, report);
}
