#include "vtkVolumeFractionFragments.h"

#include "FieldValues.h"
#include "FilterRuntime.h"
#include "MeshDataOfGrid.h"
#include "Options/MesherOptions.h"
#include "Report/Fragments/FragmentTable.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkVolumeFractionFragments);

vtkTable* vtkVolumeFractionFragments::GetOutput()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(0));
}

void vtkVolumeFractionFragments::AddDensityArray(const char* name)
{
  if (name && *name)
  {
    this->DensityArrays.emplace_back(name);
    this->Modified();
  }
}

void vtkVolumeFractionFragments::ClearDensityArrays()
{
  this->DensityArrays.clear();
  this->Modified();
}

int vtkVolumeFractionFragments::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

int vtkVolumeFractionFragments::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vfm::FilterRuntime::Execute(this, this->Controller, outputVector,
    [&](vfm::Ranks& ranks)
    {
      vfm::StoredMesh mesh;
      vfm::WorkTogether(
        ranks, [&] { mesh = vfm::MeshDataOf(vtkUnstructuredGrid::GetData(inputVector[0])); });
      vfm::FieldArrays table = vfm::MakeFragmentTable(mesh.Data, this->DensityArrays, ranks);
      vfm::AddColumns(vfm::GatherTable(std::move(table), this->Options->WholeTables, ranks),
        vtkTable::GetData(outputVector));
    });
  return 1;
}

void vtkVolumeFractionFragments::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DensityArrays:";
  for (const std::string& name : this->DensityArrays)
  {
    os << " '" << name << "'";
  }
  os << "\n";
}
