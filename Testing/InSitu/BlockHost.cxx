#include "BlockHost.h"

#include "MeshView.h"

#include <gtest/gtest.h>

namespace vfm
{
namespace testing
{
namespace
{

int OwnerOf(int block, int blocks, Distribute distribution)
{
  const int ranks = NumberOfRanks();
  switch (distribution)
  {
    case Distribute::InTurn:
      return block % ranks;
    case Distribute::InTurnButToTheLast:
      return block % std::max(ranks - 1, 1);
    case Distribute::FromBehind:
      return (blocks - 1 - block) * ranks / blocks;
    default:
      return ranks - 1;
  }
}

} // namespace

Host::Host()
{
  EXPECT_EQ(sculptor_create(&this->Sculptor), SCULPTOR_OK);
}

Host::~Host()
{
  EXPECT_EQ(sculptor_delete(this->Sculptor), SCULPTOR_OK);
}

void Host::Distribute(
  const std::vector<Place>& places, const Vector3& spacing, vfm::testing::Distribute distribution)
{
  this->Blocks.clear();
  for (std::size_t b = 0; b < places.size(); ++b)
  {
    if (OwnerOf(static_cast<int>(b), static_cast<int>(places.size()), distribution) == MyRank())
    {
      this->Blocks.emplace_back(places[b].Level, places[b].Cells, spacing);
    }
  }
}

void Host::HandOver(bool ids) const
{
  EXPECT_EQ(sculptor_clear_blocks(this->Sculptor), SCULPTOR_OK);
  for (const LevelBlock& block : this->Blocks)
  {
    EXPECT_EQ(
      sculptor_add_block(this->Sculptor, block.Level, block.Bounds.data(), block.Intervals.data()),
      SCULPTOR_OK);
    if (ids)
    {
      sculptor_set_material_ids(this->Sculptor, block.Labels.data());
    }
    else
    {
      sculptor_add_material(this->Sculptor, "ball", block.Ball.data());
      sculptor_add_material(this->Sculptor, "plate", block.Plate.data());
    }
    sculptor_add_state(this->Sculptor, "velocity", 3, block.Velocity.data());
  }
}

std::uint64_t Host::Mesh(bool tets) const
{
  const int code = sculptor_make_mesh(this->Sculptor, tets);
  EXPECT_EQ(code, SCULPTOR_OK) << sculptor_error_text(this->Sculptor);
  return code == SCULPTOR_OK ? SumOverRanks(Digest(ViewOf(this->Sculptor))) : 0;
}

void Host::ExpectError(int code, const std::string& words) const
{
  EXPECT_EQ(sculptor_make_mesh(this->Sculptor, 0), code);
  const std::string text = sculptor_error_text(this->Sculptor);
  EXPECT_NE(text.find(words), std::string::npos) << text;
}

} // namespace testing
} // namespace vfm
