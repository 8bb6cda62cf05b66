#include "vtkVolumeFractionToTet.h"

#include "TetPipeline.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVolumeFractionToTet);

vtkVolumeFractionToTet::vtkVolumeFractionToTet() :
  Method(vtkVolumeFractionToTet::HasTetGen() ? METHOD_TETGEN : METHOD_LATTICE)
{
}

bool vtkVolumeFractionToTet::HasTetGen()
{
  return vfm::HasTetGen();
}

vfm::Mesh vtkVolumeFractionToTet::MakeMesh(const vfm::CartesianGrid& grid,
  const vfm::FractionField& fractions, const vfm::MeshOptions& options, vfm::Runtime& runtime,
  vfm::MeshReport& report)
{
  vfm::MeshOptions own = options;
  own.Tets = static_cast<vfm::TetMethod>(this->Method);
  own.TetGen.RelativeSize = this->RelativeSize;
  own.TetGen.Growth = this->Growth;
  own.TetGen.RadiusEdgeRatio = this->RadiusEdgeRatio;
  own.TetGen.MinimumDihedralAngle = this->MinimumDihedralAngle;
  own.TetGen.OptimizationLevel = this->OptimizationLevel;
  vfm::Mesh mesh = vfm::MakeTetMesh(grid, fractions, own, runtime, report);
  if (report.RefusedParts > 0 && runtime.Group().Rank() == 0)
  {
    vtkWarningMacro(<< "TetGen refused " << report.RefusedParts
                    << " parts of the mesh: they keep the tetrahedra of the method Cells.");
  }
  return mesh;
}

void vtkVolumeFractionToTet::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "RelativeSize: " << this->RelativeSize << "\n";
  os << indent << "Growth: " << this->Growth << "\n";
  os << indent << "RadiusEdgeRatio: " << this->RadiusEdgeRatio << "\n";
  os << indent << "MinimumDihedralAngle: " << this->MinimumDihedralAngle << "\n";
  os << indent << "OptimizationLevel: " << this->OptimizationLevel << "\n";
}
