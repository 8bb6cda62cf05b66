/**
 * PackedValues: an array of real numbers of a block, compressed where neighbours are equal.
 */
#pragma once

#include "Input/BlockArrays.h"

#include <cstdint>
#include <unordered_map>

namespace vfm
{

/// Array of one component in pages of 32 values. Pages of one value share their memory, so such a
/// page takes 4 bytes. Thread safe once filled.
class PackedValues : public BlockArray
{
public:
  PackedValues() = default;

  /// Appends values.
  void Append(const double* values, Index count);
  /// Appends what is left of the last page; call it after the last value.
  void Finish();

  double Get(Index tuple, int) const override
  {
    return this->Page(this->Pages[tuple / PageSize])[tuple % PageSize];
  }
  void Copy(Index first, Index count, void* to) const override;

private:
  static constexpr Index PageSize = 32, PagesOfChunk = 4096;
  const double* Page(std::uint32_t page) const
  {
    return this->Chunks[page / PagesOfChunk].data() + page % PagesOfChunk * PageSize;
  }
  void AddPage();

  std::vector<std::uint32_t> Pages;               // of the values
  std::vector<std::vector<double>> Chunks;        // different pages
  std::uint32_t Count = 0;                        // of different pages
  std::unordered_map<double, std::uint32_t> Same; // pages of one value
  std::vector<double> Last;                       // values that do not fill a page yet
};

} // namespace vfm
