#include "BlockArraysOfData.h"

#include "ArrayMemory.h"
#include "CellOrder.h"
#include "Input/ArrayNames.h"
#include "State/StateArrays.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"

namespace vfm
{
namespace
{

static_assert(ValueType::Bit == VTK_BIT && ValueType::Char == VTK_CHAR &&
    ValueType::UnsignedChar == VTK_UNSIGNED_CHAR && ValueType::Short == VTK_SHORT &&
    ValueType::UnsignedShort == VTK_UNSIGNED_SHORT && ValueType::Int == VTK_INT &&
    ValueType::UnsignedInt == VTK_UNSIGNED_INT && ValueType::Long == VTK_LONG &&
    ValueType::UnsignedLong == VTK_UNSIGNED_LONG && ValueType::Float == VTK_FLOAT &&
    ValueType::Double == VTK_DOUBLE && ValueType::Id == VTK_ID_TYPE &&
    ValueType::SignedChar == VTK_SIGNED_CHAR && ValueType::LongLong == VTK_LONG_LONG &&
    ValueType::UnsignedLongLong == VTK_UNSIGNED_LONG_LONG,
  "types must have the numbers of VTK");

class ArrayOfData : public BlockArray
{
public:
  explicit ArrayOfData(vtkDataArray* array) : Array(array)
  {
    this->Type = array->GetDataType();
    this->Components = array->GetNumberOfComponents();
    this->Tuples = array->GetNumberOfTuples();
    this->Memory = FindMemory(array);
    for (int c = 0; array->HasAComponentName() && c < this->Components; ++c)
    {
      const char* name = array->GetComponentName(c);
      this->ComponentNames.emplace_back(name ? name : "");
    }
  }

  double Get(Index tuple, int component) const override
  {
    return this->Array->GetComponent(tuple, component);
  }

  /// Copies value by value, since the array is not plain memory.
  void Copy(Index first, Index count, void* to) const override
  {
    const auto plain =
      vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(CarrierType(this->Type)));
    const Index values = count * this->Components;
    plain->SetNumberOfComponents(this->Components);
    plain->SetVoidArray(to, values, 1);
    for (Index v = 0; v < values; ++v)
    {
      const Index tuple = v / this->Components;
      const int c = static_cast<int>(v % this->Components);
      if (this->Type == VTK_BIT) // bits have no variants
      {
        plain->SetComponent(tuple, c, this->Array->GetComponent(first + tuple, c));
      }
      else // doubles cannot represent all integers
      {
        plain->SetVariantValue(v, this->Array->GetVariantValue(first * this->Components + v));
      }
    }
  }

private:
  vtkSmartPointer<vtkDataArray> Array;
};

class DataArrays : public BlockArrays
{
public:
  DataArrays(vtkDataObject* data, int association, std::shared_ptr<CellOrder> order) :
    Data(data), Association(association), Order(std::move(order))
  {
  }

  Index NumberOfTuples() const override
  {
    return this->Data->GetNumberOfElements(this->Association);
  }

  std::shared_ptr<const BlockArray> Find(const std::string& name) const override
  {
    vtkDataSetAttributes* attributes = this->Attributes();
    vtkDataArray* array = attributes ? attributes->GetArray(name.c_str()) : nullptr;
    if (!array)
    {
      return nullptr;
    }
    const bool isWhole = array->GetNumberOfTuples() == this->NumberOfTuples();
    auto found =
      std::make_shared<ArrayOfData>(this->Order && isWhole ? this->Order->Arrange(array) : array);
    found->Tuples = array->GetNumberOfTuples();
    return found;
  }

  /// Returns whether an array holds ids, by its name or as a VTK attribute.
  bool HoldsIds(const std::string& name) const override
  {
    vtkDataSetAttributes* attributes = this->Attributes();
    vtkAbstractArray* array = attributes->GetAbstractArray(name.c_str());
    return IsIdName(name) ||
      (array && (array == attributes->GetGlobalIds() || array == attributes->GetPedigreeIds()));
  }

  std::vector<std::string> Names() const override
  {
    std::vector<std::string> names;
    vtkDataSetAttributes* attributes = this->Attributes();
    for (int a = 0; attributes && a < attributes->GetNumberOfArrays(); ++a)
    {
      const char* name = attributes->GetArrayName(a);
      names.emplace_back(name ? name : "");
    }
    return names;
  }

private:
  vtkDataSetAttributes* Attributes() const { return this->Data->GetAttributes(this->Association); }

  vtkDataObject* Data;
  int Association;
  std::shared_ptr<CellOrder> Order;
};

} // namespace

std::shared_ptr<const BlockArrays> ArraysOf(
  vtkDataObject* data, int association, std::shared_ptr<CellOrder> order)
{
  return std::make_shared<DataArrays>(data, association, std::move(order));
}

} // namespace vfm
