/// Slots of memory.
#include "Base/SlotArena.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <set>

TEST(SlotArena, SlotsAreApartAndUsedAgain)
{
  const std::size_t bytes = 24;
  vfm::SlotArena arena(bytes);
  std::set<std::uintptr_t> taken;
  std::vector<void*> slots;
  for (int i = 0; i < 20000; ++i)
  {
    slots.push_back(arena.Take());
    std::memset(slots.back(), i & 255, bytes);
    taken.insert(reinterpret_cast<std::uintptr_t>(slots.back()));
  }
  ASSERT_EQ(taken.size(), slots.size());
  for (auto next = taken.begin(), at = next++; next != taken.end(); at = next++)
  {
    ASSERT_GE(*next - *at, bytes);
    ASSERT_EQ(*at % 8, 0u);
  }
  EXPECT_GE(arena.MemoryInBytes(), slots.size() * bytes);
  arena.Give(slots[7]);
  const std::size_t memory = arena.MemoryInBytes();
  EXPECT_EQ(arena.Take(), slots[7]);
  EXPECT_EQ(arena.MemoryInBytes(), memory);
}
