/**
 * Damaged files, read and meshed as by the program sculptor:
 *
 *   FuzzFiles FOLDER [--seed S] [--count N] [--keep]
 *
 * FOLDER/inputs lists good inputs, one per line: a folder in FOLDER, the input in it, further words
 * for sculptor. Each seed copies one of them, damages a file of the copy, and reads and meshes it
 * in a separate process. The process must end within 60 s and 1 GB, with a mesh or with a message
 * of one line. Prints a line for each seed that fails, and the number of seeds with each outcome.
 * Returns 1 if any failed. --keep leaves the last copy in FOLDER/damaged and prints each outcome.
 */
#include "DamageFile.h"
#include "RunApart.h"

#include "Arguments.h"
#include "MakeMesh.h"
#include "Ranks/WorkTogether.h"
#include "ReadInput.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

using namespace vfm;
using namespace vfm::testing;
namespace fs = std::filesystem;

namespace
{

constexpr int Patience = 60;                         // seconds
constexpr std::size_t Memory = std::size_t(1) << 30; // bytes
constexpr std::size_t LongestMessage = 4000;
/// VTK's XML readers trust the sizes of compressed data, up to 4 GB; this error is acceptable.
constexpr const char* LacksMemory = "internal error: Not enough memory.";

struct Good
{
  std::string Folder, File;
  std::vector<std::string> Words;
};

std::vector<Good> ReadList(const fs::path& folder)
{
  std::ifstream stream(folder / "inputs");
  std::vector<Good> list;
  for (std::string line; std::getline(stream, line);)
  {
    std::istringstream words(line);
    Good good;
    words >> good.Folder >> good.File;
    good.Words.assign(std::istream_iterator<std::string>(words), {});
    list.push_back(good);
  }
  if (list.empty())
  {
    throw std::runtime_error((folder / "inputs").string() + " lists no inputs");
  }
  return list;
}

/// Returns the files of a folder and its subfolders, sorted.
std::vector<fs::path> ListFiles(const fs::path& folder)
{
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
  {
    if (entry.is_regular_file())
    {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Damages one file of a folder; returns a description of the damage.
std::string DamageFolder(const fs::path& folder, RandomDraw& draw)
{
  const std::vector<fs::path> files = ListFiles(folder);
  const fs::path& path = files[draw.Seed() % files.size()];
  std::ifstream stream(path, std::ios::binary);
  std::string bytes{ std::istreambuf_iterator<char>(stream), {} };
  const std::string done = DamageBytes(bytes, draw);
  std::ofstream(path, std::ios::binary) << bytes;
  return path.filename().string() + ": " + done;
}

/// Returns "meshed", or "refused: " and the message.
std::string MeshFile(const fs::path& path, const std::vector<std::string>& words)
{
  std::vector<std::string> all{ "--input", path.string(), "--output", "none.vtu", "--quiet" };
  all.insert(all.end(), words.begin(), words.end());
  try
  {
    Ranks alone;
    const Arguments arguments = ParseArguments(all);
    const Input input = ReadInput(arguments, alone);
    MakeMesh(arguments, input, ChooseArrays(input, arguments, alone), alone);
    return "meshed";
  }
  catch (const InputError& error)
  {
    const ErrorCode code = error.Code();
    const bool isInternal = code == ErrorCode::InternalError || code == ErrorCode::OutOfMemory;
    const char* how = isInternal ? "internal error: " : "refused: ";
    return (code == ErrorCode::Unknown ? "throws: " : how) + std::string(error.what());
  }
  catch (const std::exception& error)
  {
    return std::string("throws: ") + error.what();
  }
}

/// Returns an empty string, or why a user should not see this outcome.
std::string FindProblem(const ApartResult& result)
{
  if (!result.Failure.empty())
  {
    return result.Failure;
  }
  const std::string& text = result.Text;
  const bool isRejected =
    (text.compare(0, 9, "refused: ") == 0 && text.size() > 20) || text == LacksMemory;
  if (text != "meshed" && !isRejected)
  {
    return text;
  }
  const bool isLine =
    std::none_of(text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; });
  return isLine && text.size() < LongestMessage ? "" : "a message that is not a line: " + text;
}

class Fuzzer
{
public:
  Fuzzer(const fs::path& folder, bool keeps) :
    Folder(folder), Copy(folder / "damaged"), List(ReadList(folder)), Keeps(keeps)
  {
  }

  void Run(unsigned seed)
  {
    RandomDraw draw(seed);
    const Good& good = this->List[draw.Seed() % this->List.size()];
    fs::remove_all(this->Copy);
    fs::copy(this->Folder / good.Folder, this->Copy, fs::copy_options::recursive);
    const std::string done = DamageFolder(this->Copy, draw);
    const ApartResult result =
      RunApart([&] { return MeshFile(this->Copy / good.File, good.Words); }, Patience, Memory);
    const std::string problem = FindProblem(result);
    const bool hasFailed = !problem.empty();
    this->Failures += hasFailed;
    const std::string end = result.Text == LacksMemory
      ? " lacked memory"
      : (result.Text == "meshed" ? " meshed" : " refused");
    ++this->Ends[good.Folder + (hasFailed ? " failed" : end)];
    if (hasFailed || this->Keeps)
    {
      std::printf("seed %u: %s | %s, %s\n", seed, hasFailed ? problem.c_str() : result.Text.c_str(),
        good.Folder.c_str(), done.c_str());
      std::fflush(stdout);
    }
  }

  int Finish()
  {
    if (!this->Keeps)
    {
      fs::remove_all(this->Copy);
    }
    for (const auto& end : this->Ends)
    {
      std::printf("%s %d\n", end.first.c_str(), end.second);
    }
    std::printf("%d failures\n", this->Failures);
    return this->Failures > 0 ? 1 : 0;
  }

private:
  const fs::path Folder, Copy;
  const std::vector<Good> List;
  const bool Keeps;
  std::map<std::string, int> Ends;
  int Failures = 0;
};

} // namespace

int main(int argc, char** argv)
{
  try
  {
    unsigned first = 0, count = 1;
    bool keeps = false;
    for (int i = 2; i < argc; ++i)
    {
      const std::string word = argv[i];
      keeps = keeps || word == "--keep";
      if ((word == "--seed" || word == "--count") && i + 1 < argc)
      {
        (word == "--seed" ? first : count) = static_cast<unsigned>(std::stoul(argv[++i]));
      }
    }
    if (argc < 2)
    {
      throw std::invalid_argument("FuzzFiles FOLDER [--seed S] [--count N] [--keep]");
    }
    Fuzzer fuzzer(argv[1], keeps);
    for (unsigned seed = first; seed != first + count; ++seed)
    {
      fuzzer.Run(seed);
    }
    return fuzzer.Finish();
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
