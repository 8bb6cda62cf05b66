/**
 * BlockHost: a host code with a refined grid, whose blocks are dealt to the ranks in some way and
 * handed over by the C interface.
 */
#pragma once

#include "HostFields.h"
#include "LevelBlocks.h"
#include "Sculptor.h"

#include <string>

namespace vfm
{
namespace testing
{

/// Widths of cells of level 0: that are exact in binary, and that are not.
constexpr Vector3 Binary{ { 0.125, 0.25, 0.125 } }, Decimal{ { 0.1, 0.125, 0.11 } };

enum class Distribute
{
  InTurn,
  InTurnButToTheLast, ///< which is empty
  FromBehind,         ///< each rank several that follow each other
  ToTheLast           ///< all others are empty
};

/// A sculptor, and the fields that it looks at. Failures are those of the test that runs.
class Host
{
public:
  Host();
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  /// Fills the blocks of this rank, but does not hand them over. spacing: of level 0.
  void Distribute(const std::vector<Place>& places, const Vector3& spacing,
    vfm::testing::Distribute distribution);
  /// In place of all blocks before. ids: instead of fractions.
  void HandOver(bool ids = false) const;
  /// The digest of the mesh of all ranks.
  std::uint64_t Mesh(bool tets = false) const;
  /// That the mesh of hexes is refused, with such a code and text on all ranks.
  void ExpectError(int code, const std::string& words) const;

  int Sculptor = 0;
  std::vector<LevelBlock> Blocks;
};

} // namespace testing
} // namespace vfm
