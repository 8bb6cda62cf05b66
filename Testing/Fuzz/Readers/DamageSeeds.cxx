/**
 * Runs a harness on intact and on damaged inputs, without libFuzzer:
 *
 *   FuzzNAME FOLDER COUNT [FIRST]
 *
 * Reads each file of FOLDER, then COUNT randomly damaged copies of them, with seeds from FIRST on
 * (0). If the program crashes, it prints the seed. Returns 77 if FOLDER does not exist, because
 * make_seeds.py lacks a module of Python.
 */
#include "DamageFile.h"
#include "Harness.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <unistd.h>
#include <vector>

namespace
{

std::vector<std::string> ReadFiles(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> files;
  for (const std::filesystem::path& path : paths)
  {
    std::ifstream stream(path, std::ios::binary);
    files.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  return files;
}

char lastRun[80] = "an intact input\n"; // for the handler of signals

void PrintLastRun(int number)
{
  (void)!write(STDERR_FILENO, lastRun, std::strlen(lastRun));
  std::signal(number, SIG_DFL);
  std::raise(number);
}

void RunDamaged(const std::vector<std::string>& seeds, unsigned seed)
{
  std::snprintf(lastRun, sizeof(lastRun), "crash at seed %u\n", seed);
  vfm::testing::RandomDraw draw(seed);
  std::string bytes = seeds[draw.Seed() % seeds.size()];
  vfm::testing::DamageBytes(bytes, draw);
  LLVMFuzzerTestOneInput(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    if (argc < 3)
    {
      throw std::invalid_argument(std::string(argv[0]) + " FOLDER COUNT [FIRST]");
    }
    for (int number : { SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL })
    {
      std::signal(number, PrintLastRun);
    }
    if (!std::filesystem::exists(argv[1]))
    {
      std::printf("%s does not exist\n", argv[1]);
      return 77;
    }
    const std::vector<std::string> seeds = ReadFiles(argv[1]);
    if (seeds.empty())
    {
      throw std::invalid_argument(std::string(argv[1]) + " is empty");
    }
    for (const std::string& seed : seeds)
    {
      vfm::testing::ReadBytes(seed); // an InputError here is an error of the seed
    }
    const auto count = static_cast<unsigned>(std::stoul(argv[2]));
    const auto first = argc > 3 ? static_cast<unsigned>(std::stoul(argv[3])) : 0;
    for (unsigned s = 0; s < count; ++s)
    {
      RunDamaged(seeds, first + s);
    }
    std::printf("%zu seeds, %u damaged inputs\n", seeds.size(), count);
    return 0;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
