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
  const vfm::FractionField& fractions, const vfm::MeshOptions& common, vfm::Runtime& runtime,
  vfm::MeshReport& report)
{
  vfm::MeshOptions options = common;
  options.Tets = static_cast<vfm::TetMethod>(this->Method);
  options.TetGen.RelativeSize = this->RelativeSize;
  options.TetGen.Growth = this->Growth;
  options.TetGen.RadiusEdgeRatio = this->RadiusEdgeRatio;
  options.TetGen.MinimumDihedralAngle = this->MinimumDihedralAngle;
  options.TetGen.OptimizationLevel = this->OptimizationLevel;
  vfm::Mesh mesh = vfm::MakeTetMesh(grid, fractions, options, runtime, report);
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
