#include "vtkSMCellCountDomain.h"

#include "Options/CellWidths.h"

#include "vtkDataObject.h"
#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMPropertyHelper.h"

#include <algorithm>

vtkStandardNewMacro(vtkSMCellCountDomain);

/// Returns whether the points of an image are the centres of the cells that are meshed.
bool vtkSMCellCountDomain::HasPoints(vtkPVDataInformation* info)
{
  if (!info->DataSetTypeIsA("vtkImageData"))
  {
    return false;
  }
  vtkSMPropertyHelper labels(this->GetRequiredProperty("Labels"));
  labels.SetUseUnchecked(true);
  const char* name = labels.GetInputArrayNameToProcess();
  if (name && *name && std::string(name) != "None")
  {
    return labels.GetInputArrayAssociation() == vtkDataObject::FIELD_ASSOCIATION_POINTS;
  }
  return info->GetCellDataInformation()->GetNumberOfArrays() == 0;
}

void vtkSMCellCountDomain::Update(vtkSMProperty*)
{
  vtkPVDataInformation* info = this->GetInputDataInformation("Input");
  if (!info || !this->GetProperty())
  {
    return;
  }
  vtkSMPropertyHelper width(this->GetRequiredProperty("Width"));
  width.SetUseUnchecked(true);
  const vtkSMPropertyHelper spacing(this->GetRequiredProperty("Spacing"));
  const bool hasPoints = this->HasPoints(info);
  const bool hasExtent = !info->IsCompositeDataSet() && info->IsDataStructured();
  vfm::Vector3 lengths{};
  vfm::Index3 cells{};
  for (int a = 0; a < 3; ++a)
  {
    const int* extent = info->GetExtent();
    const double* bounds = info->GetBounds();
    const double unit = spacing.GetNumberOfElements() == 3 ? spacing.GetAsDouble(a) : 0.0;
    const vfm::Index ofExtent = extent[2 * a + 1] - extent[2 * a] + (hasPoints ? 1 : 0);
    cells[a] = hasExtent ? std::max<vfm::Index>(ofExtent, 0) : 0;
    lengths[a] = hasExtent && unit > 0.0 ? unit * static_cast<double>(cells[a])
                                         : bounds[2 * a + 1] - bounds[2 * a];
  }
  const bool isKnown = std::all_of(lengths.begin(), lengths.end(), [](double l) { return l > 0; });
  const std::string text = isKnown ? vfm::DescribeCells(width.GetAsString(), lengths, cells) : "";
  vtkSMPropertyHelper shown(this->GetProperty());
  if (shown.GetAsString() != text)
  {
    shown.Set(text.c_str());
  }
}
