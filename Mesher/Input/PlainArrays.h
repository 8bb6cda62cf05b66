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

  /// type: of ValueType, no bits. values, shape (tuples, components), must outlive this.
  void Add(const std::string& name, int type, Index tuples, int components, const void* values);
  /// The same of values that this keeps.
  void Add(const std::string& name, int type, Index tuples, int components,
    std::shared_ptr<const void> values);

  Index NumberOfTuples() const override { return this->Tuples; }
  std::shared_ptr<const BlockArray> Find(const std::string& name) const override;
  bool HoldsIds(const std::string&) const override { return false; }
  std::vector<std::string> Names() const override;

private:
  const Index Tuples;
  std::vector<std::pair<std::string, std::shared_ptr<const BlockArray>>> Arrays;
};

} // namespace vfm
