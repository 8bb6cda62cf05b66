/**
 * PlainArrays: the arrays of a block in memory, tuple by tuple, which are not copied.
 */
#pragma once

#include "Input/BlockArrays.h"

#include <memory>
#include <utility>

namespace vfm
{

class PlainArrays : public BlockArrays
{
public:
  /// tuples: of the block.
  explicit PlainArrays(Index tuples) : Tuples(tuples) {}
  /// Arrays that are added replace those of others.
  explicit PlainArrays(std::shared_ptr<const BlockArrays> others) :
    Tuples(others->NumberOfTuples()), Others(std::move(others))
  {
  }

  /// type: of ValueType, no bits. values, shape (tuples, components), must outlive this.
  void Add(const std::string& name, int type, Index tuples, int components, const void* values);
  /// The same of values that this keeps.
  void Add(const std::string& name, int type, Index tuples, int components,
    std::shared_ptr<const void> values);
  /// The same of a vector or Buffer of numbers, or of their bytes, with one component.
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
