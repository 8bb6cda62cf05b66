#include "vtkVolumeFractionToTet.h"

#include "Mesher.h"
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

void vtkVolumeFractionToTet::SpecialiseOptions(vfm::MesherOptions& options) const
{
  options.Elements = vfm::ElementKind::Tets;
  options.Tets = static_cast<vfm::TetMethod>(this->Method);
  options.RelativeSize = this->RelativeSize;
  options.Growth = this->Growth;
  options.RadiusEdgeRatio = this->RadiusEdgeRatio;
  options.MinimumDihedralAngle = this->MinimumDihedralAngle;
  options.OptimizationLevel = this->OptimizationLevel;
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
