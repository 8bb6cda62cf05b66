#include "LabelNameFields.h"

#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <algorithm>

namespace vfm
{
namespace
{

constexpr const char *LabelsName = "NamedLabels", *NamesName = "LabelNames";

} // namespace

void AddLabelNames(const LabelNames& names, vtkFieldData* fields)
{
  if (names.empty())
  {
    return;
  }
  vtkNew<vtkIntArray> labels;
  vtkNew<vtkStringArray> texts;
  labels->SetName(LabelsName);
  texts->SetName(NamesName);
  for (const auto& [label, name] : names)
  {
    labels->InsertNextValue(label);
    texts->InsertNextValue(name);
  }
  fields->AddArray(labels);
  fields->AddArray(texts);
}

LabelNames FindLabelNames(vtkFieldData* fields)
{
  LabelNames names;
  auto* labels = fields ? vtkIntArray::SafeDownCast(fields->GetAbstractArray(LabelsName)) : nullptr;
  auto* texts =
    fields ? vtkStringArray::SafeDownCast(fields->GetAbstractArray(NamesName)) : nullptr;
  const vtkIdType count = labels && texts
    ? std::min(labels->GetNumberOfValues(), texts->GetNumberOfValues())
    : vtkIdType(0);
  for (vtkIdType i = 0; i < count; ++i)
  {
    names.emplace(labels->GetValue(i), texts->GetValue(i));
  }
  return names;
}

} // namespace vfm
