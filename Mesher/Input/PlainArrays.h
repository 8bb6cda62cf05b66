/**
 * PlainArrays: a list of arrays of a block, mostly in contiguous memory, row-major. They are not
 * copied.
 */
#pragma once

#include "Input/BlockArrays.h"

#include <memory>
#include <utility>

namespace vfm
{

/// Views or owns its arrays, depending on the function that adds them.
class PlainArrays : public BlockArrays
{
public:
  /// Makes an empty list; tuples: number of tuples of the block.
  explicit PlainArrays(Index tuples) : Tuples(tuples) {}
  /// Extends a list; added arrays replace arrays of the same name.
  explicit PlainArrays(std::shared_ptr<const BlockArrays> others) :
    Tuples(others->NumberOfTuples()), Others(std::move(others))
  {
  }

  /// Adds a view of an array.
  /// @param type one of ValueType except Bit
  /// @param values shape (tuples, components), row-major; must outlive this object
  void Add(const std::string& name, int type, Index tuples, int components, const void* values);
  /// Adds an array and shares ownership of its values.
  void Add(const std::string& name, int type, Index tuples, int components,
    std::shared_ptr<const void> values);
  /// Adds an array that stores its values in its own way.
  void Add(const std::string& name, std::shared_ptr<const BlockArray> array)
  {
    this->Arrays.emplace_back(name, std::move(array));
  }
  /// Adds an array of one component and stores its values: a vector or Buffer of numbers or bytes.
  template <class Values>
  void Store(const std::string& name, int type, Values values)
  {
    const auto tuples = static_cast<Index>(values.size() * sizeof(values[0])) / WidthOfType(type);
    const auto kept = std::make_shared<const Values>(std::move(values));
    this->Add(name, type, tuples, 1, std::shared_ptr<const void>(kept, kept->data()));
  }

  Index NumberOfTuples() const override { return this->Tuples; }
  std::shared_ptr<const BlockArray> Find(const std::string& name) const override;
  bool HoldsIds(const std::string& name) const override
  {
    return this->Others && this->Others->HoldsIds(name);
  }
  std::vector<std::string> Names() const override;

private:
  const Index Tuples;
  std::shared_ptr<const BlockArrays> Others;
  std::vector<std::pair<std::string, std::shared_ptr<const BlockArray>>> Arrays;
};

} // namespace vfm
