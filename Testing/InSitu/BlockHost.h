/**
 * BlockHost: a simulation with a refined grid whose blocks are distributed to the ranks in a given
 * way and passed to the C interface.
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

/// Cell widths of level 0: exact in binary, and not exact.
constexpr Vector3 Binary{ { 0.125, 0.25, 0.125 } }, Decimal{ { 0.1, 0.125, 0.11 } };

enum class Distribute
{
  InTurn,
  InTurnButToTheLast, ///< the last rank is empty
  FromBehind,         ///< each rank has consecutive blocks, the last ones on rank 0
  ToTheLast           ///< all other ranks are empty
};

/// A sculptor and the fields that it reads. Its failures are failures of the current test.
class Host
{
public:
  Host();
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  /// Fills the blocks of this rank without passing them to the sculptor. spacing: of level 0.
  void Distribute(const std::vector<Place>& places, const Vector3& spacing,
    vfm::testing::Distribute distribution);
  /// Replaces all blocks of the sculptor. ids: passes ids instead of fractions.
  void HandOver(bool ids = false) const;
  /// Returns the digest of the mesh of all ranks.
  std::uint64_t Mesh(bool tets = false) const;
  /// Expects that the hexahedral mesh is rejected with this code and text on all ranks.
  void ExpectError(int code, const std::string& words) const;

  int Sculptor = 0;
  std::vector<LevelBlock> Blocks;
};

} // namespace testing
} // namespace vfm
