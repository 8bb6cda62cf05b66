#include "ExodusBlocks.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataAssembly.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkThreshold.h"
#include "vtkUnstructuredGrid.h"

#include <string>

namespace vfm
{
namespace
{

vtkSmartPointer<vtkUnstructuredGrid> ExtractMaterial(vtkUnstructuredGrid* mesh, int material)
{
  vtkNew<vtkThreshold> threshold;
  threshold->SetInputData(mesh);
  threshold->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "MaterialId");
  threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_BETWEEN);
  threshold->SetLowerThreshold(material);
  threshold->SetUpperThreshold(material);
  threshold->Update();
  vtkSmartPointer<vtkUnstructuredGrid> part = threshold->GetOutput();
  vtkCellData* cells = part->GetCellData();
  vtkPointData* points = part->GetPointData();
  cells->SetGlobalIds(cells->GetArray("GlobalCellIds"));
  points->SetGlobalIds(points->GetArray("GlobalPointIds"));
  return part;
}

} // namespace

vtkSmartPointer<vtkPartitionedDataSetCollection> MakeExodusBlocks(
  vtkUnstructuredGrid* mesh, Ranks& ranks)
{
  vtkFieldData* field = mesh->GetFieldData();
  auto names = vtkStringArray::SafeDownCast(field->GetAbstractArray("MaterialNames"));
  auto ids = vtkIntArray::SafeDownCast(field->GetArray("MaterialIds"));
  auto blocks = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  vtkNew<vtkDataAssembly> assembly;
  assembly->SetRootNodeName("IOSS");
  const int elementBlocks = assembly->AddNode("element_blocks");
  for (vtkIdType i = 0; i < ids->GetNumberOfValues(); ++i)
  {
    const int id = ids->GetValue(i);
    const auto part = ExtractMaterial(mesh, id);
    if (!ranks.Any(part->GetNumberOfCells() > 0))
    {
      continue;
    }
    const unsigned int block = blocks->GetNumberOfPartitionedDataSets();
    blocks->SetPartition(block, 0, part);
    blocks->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), names->GetValue(i).c_str());
    const std::string node = "material_" + std::to_string(id);
    assembly->AddDataSetIndex(assembly->AddNode(node.c_str(), elementBlocks), block);
  }
  blocks->SetDataAssembly(assembly);
  return blocks;
}

} // namespace vfm
