/**
 * Reads files of blocks: one file (VFM_FUZZ_SUFFIX), or the files of an AMReX plotfile, which
 * follow each other in the input.
 */
#include "Harness.h"

#include "Blocks/BlockFile.h"
#include "Ranks/Ranks.h"

#include <algorithm>
#include <filesystem>

namespace vfm
{
namespace testing
{
namespace
{

constexpr std::size_t Steps = 3; // times that a run reads

std::string WriteFiles(std::string bytes)
{
#ifdef VFM_FUZZ_SUFFIX
  return WriteInput("a" VFM_FUZZ_SUFFIX, bytes);
#else
  std::string folder;
  for (const char* name : { "Header", "Level_0/Cell_H", "Level_0/Cell_D_00000", "Level_1/Cell_H",
         "Level_1/Cell_D_00000" })
  {
    const std::string path = WriteInput(std::string("plt/") + name, TakeUntil(bytes, "\n@@\n"));
    folder = folder.empty() ? std::filesystem::path(path).parent_path().string() : folder;
  }
  return folder;
#endif
}

} // namespace

void ReadBytes(const std::string& bytes)
{
  Ranks alone;
  const auto file = OpenBlockFile(WriteFiles(bytes), alone);
  const std::size_t steps = std::max<std::size_t>(file->Times().size(), 1);
  for (std::size_t step = 0; step < std::min(steps, Steps); ++step)
  {
    file->Read(step, file->Names(), alone);
  }
}

} // namespace testing
} // namespace vfm
