#include "Input/PlainArrays.h"

#include <algorithm>

namespace vfm
{
namespace
{

/// An array in memory; readers use Memory, not the virtual functions.
class PlainArray : public BlockArray
{
public:
  std::shared_ptr<const void> Kept; ///< owner of Memory; null for views

  double Get(Index tuple, int component) const override
  {
    return VisitType(this->Type,
      [&](auto tag)
      {
        using Value = typename decltype(tag)::Type;
        const Index place = tuple * this->Components + component;
        return static_cast<double>(static_cast<const Value*>(this->Memory)[place]);
      });
  }
  void Copy(Index first, Index count, void* to) const override
  {
    VisitType(this->Type,
      [&](auto tag)
      {
        using Value = typename decltype(tag)::Type;
        std::memcpy(to, static_cast<const Value*>(this->Memory) + first * this->Components,
          count * this->Components * sizeof(Value));
      });
  }
};

} // namespace

void PlainArrays::Add(
  const std::string& name, int type, Index tuples, int components, const void* values)
{
  this->Add(name, type, tuples, components, { std::shared_ptr<void>(), values });
}

void PlainArrays::Add(const std::string& name, int type, Index tuples, int components,
  std::shared_ptr<const void> values)
{
  auto array = std::make_shared<PlainArray>();
  array->Type = type;
  array->Tuples = tuples;
  array->Components = components;
  array->Memory = values.get();
  array->Kept = std::move(values);
  this->Add(name, std::move(array));
}

std::shared_ptr<const BlockArray> PlainArrays::Find(const std::string& name) const
{
  for (const auto& [own, array] : this->Arrays)
  {
    if (own == name)
    {
      return array;
    }
  }
  return this->Others ? this->Others->Find(name) : nullptr;
}

std::vector<std::string> PlainArrays::Names() const
{
  std::vector<std::string> names =
    this->Others ? this->Others->Names() : std::vector<std::string>();
  for (const auto& array : this->Arrays)
  {
    if (std::find(names.begin(), names.end(), array.first) == names.end())
    {
      names.push_back(array.first);
    }
  }
  return names;
}

} // namespace vfm
