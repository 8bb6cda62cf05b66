/// Files replace earlier files of their names together, when all of all ranks are whole.
#include "FileCases.h"
#include "Meshes/Files/OutputFile.h"
#include "Meshes/Files/OutputLock.h"
#include "Meshes/Files/OutputPlace.h"
#include "Ranks/WorkTogether.h"
#include "ThreadRanks.h"

#include <cstdio>
#include <thread>

using namespace vfm;
using namespace vfm::testing;

namespace
{

namespace fs = std::filesystem;

constexpr int Count = 3;

void WriteText(const std::string& path, const std::string& text)
{
  std::ofstream(path) << text;
}

std::string NameOfPart(int rank)
{
  return "part" + std::to_string(rank);
}

/// Writes a file per rank and, on rank 0, a list, over earlier ones.
/// @param change  called on each rank before the files are renamed
/// @return messages of the ranks
std::vector<std::string> ReplaceParts(const Folder& folder,
  const std::function<void(int rank, const std::string& begun)>& change,
  Naming naming = Naming::Late)
{
  WriteText(folder / "list", "old");
  for (int rank = 0; rank < Count; ++rank)
  {
    WriteText(folder / NameOfPart(rank), "old");
  }
  std::vector<std::string> messages(Count);
  const auto write = [&](Ranks& ranks)
  {
    OutputSet files(folder / "list");
    const std::string begun = files.Create(folder / NameOfPart(ranks.Rank()), naming);
    WriteText(begun, "new");
    if (ranks.Rank() == 0)
    {
      OutputFile list(folder / "list", files);
      list.Add("new");
      list.Close();
    }
    change(ranks.Rank(), begun);
    files.Rename(ranks);
  };
  RunOnRanks(Count,
    [&](Ranks& ranks)
    {
      try
      {
        WorkTogether(ranks, [&] { write(ranks); });
      }
      catch (const InputError& error)
      {
        messages[ranks.Rank()] = error.what();
      }
    });
  return messages;
}

void ExpectContent(const Folder& folder, const std::string& text)
{
  EXPECT_EQ(ReadBytes(folder / "list"), text);
  for (int rank = 0; rank < Count; ++rank)
  {
    EXPECT_EQ(ReadBytes(folder / NameOfPart(rank)), text) << rank;
  }
  EXPECT_EQ(folder.CountFiles(), 4u);
}

} // namespace

TEST(OutputSet, FilesOfAllRanksAreReplaced)
{
  const Folder folder;
  EXPECT_EQ(ReplaceParts(folder, [](int, const std::string&) {}), std::vector<std::string>(Count));
  ExpectContent(folder, "new");
}

TEST(OutputSet, FilesWithNamesAreReplaced)
{
  const Folder folder;
  EXPECT_EQ(ReplaceParts(
              folder, [](int, const std::string&) {}, Naming::AtOnce),
    std::vector<std::string>(Count));
  ExpectContent(folder, "new");
}

TEST(OutputSet, AnUnfinishedFileHasNoName)
{
  const Folder folder;
  std::vector<std::unique_ptr<UnnamedFile>> taken;
  while (auto file = UnnamedFile::Create(folder / "", 0666))
  {
    taken.push_back(std::move(file));
  }
  if (taken.empty())
  {
    GTEST_SKIP() << "the file system has only files with names";
  }
  EXPECT_EQ(taken.size(), std::size_t(UnnamedFile::LargestCount));
  OutputFile named(folder / "named");
  EXPECT_EQ(folder.CountFiles(), 1u);
  taken.pop_back();
  OutputFile unnamed(folder / "unnamed");
  EXPECT_EQ(folder.CountFiles(), 1u);
  unnamed.Add("text");
  unnamed.Close();
  EXPECT_EQ(ReadBytes(folder / "unnamed"), "text");
  EXPECT_EQ(folder.CountFiles(), 2u);
}

TEST(OutputSet, AFailedRankLeavesTheEarlierFiles)
{
  const Folder folder;
  const auto fail = [](int rank, const std::string&)
  {
    if (rank == 2)
    {
      throw InputError("no space");
    }
  };
  EXPECT_EQ(ReplaceParts(folder, fail), std::vector<std::string>(Count, "no space"));
  ExpectContent(folder, "old");
}

TEST(OutputSet, ARankThatRemovedItsFileLeavesTheEarlierFiles)
{
  for (int removed = 1; removed < Count; ++removed)
  {
    const Folder folder;
    const auto remove = [removed](int rank, const std::string& begun)
    {
      if (rank == removed) // as when a signal ends it after its last message
      {
        fs::remove(begun);
      }
    };
    const std::vector<std::string> messages = ReplaceParts(folder, remove, Naming::AtOnce);
    EXPECT_NE(messages[0].find("of rank " + std::to_string(removed)), std::string::npos)
      << messages[0];
    EXPECT_EQ(messages, std::vector<std::string>(Count, messages[0]));
    ExpectContent(folder, "old");
  }
}

TEST(OutputSet, AFolderInPlaceOfAFile)
{
  const Folder folder;
  fs::create_directory(folder / "name");
  EXPECT_THROW(OutputFile(folder / "name"), InputError);
  EXPECT_EQ(folder.CountFiles(), 1u);
}

TEST(OutputSet, LongNamesAndNewFolders)
{
  const Folder folder;
  {
    OutputSet files(folder / "list");
    files.MakeFolder(folder / "a");
    files.MakeFolder(folder / "a/b");
    files.Create(folder / "a/b/c");
    EXPECT_TRUE(fs::exists(folder / "a/b"));
  }
  EXPECT_EQ(folder.CountFiles(), 0u);
  const std::string longest(255, 'x'); // bytes of a name on most file systems
  OutputFile file(folder / longest);
  file.Add("text");
  file.Close();
  EXPECT_EQ(ReadBytes(folder / longest), "text");
  EXPECT_EQ(folder.CountFiles(), 1u);
}

TEST(UnfinishedPathDeathTest, NothingIsLeftWhenAProgramEnds)
{
  const Folder folder;
  WriteText(folder / "old", "old");
  EXPECT_EXIT(
    {
      OutputSet files(folder / "old");
      files.MakeFolder(folder / "new");
      WriteText(files.Create(folder / "new/part", Naming::AtOnce), "new");
      WriteText(files.Create(folder / "old", Naming::AtOnce), "new");
      RemoveUnfinishedPaths();
      _exit(3);
    },
    ::testing::ExitedWithCode(3), "");
  EXPECT_EQ(ReadBytes(folder / "old"), "old");
  EXPECT_EQ(folder.CountFiles(), 1u);
}

TEST(OutputPlace, OpenFilesAreWrittenInPlace)
{
  const Folder folder;
  WriteText(folder / "old", "");
  EXPECT_FALSE(IsWrittenInPlace(folder / "old"));
  EXPECT_FALSE(IsWrittenInPlace(folder / "new"));
  EXPECT_TRUE(IsWrittenInPlace("/dev/null"));
  std::FILE* open = std::fopen((folder / "old").c_str(), "r");
  EXPECT_TRUE(IsWrittenInPlace("/dev/fd/" + std::to_string(fileno(open))));
  std::fclose(open);
}

TEST(OutputLock, TheSecondProcessWaits)
{
  const Folder folder;
  std::atomic<bool> isReleased{ false };
  auto first = std::make_unique<OutputLock>(folder / "name");
  EXPECT_EQ(folder.CountFiles(), 1u);
  std::thread second(
    [&]
    {
      const OutputLock lock(folder / "name");
      EXPECT_TRUE(isReleased);
    });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  isReleased = true;
  first.reset();
  second.join();
  EXPECT_EQ(folder.CountFiles(), 0u);
}

TEST(OutputLock, TheLockOfAKilledProcessIsNone)
{
  const Folder folder;
  WriteText(folder / ".name.lock", "");
  {
    const OutputLock lock(folder / "name");
  }
  EXPECT_EQ(folder.CountFiles(), 0u);
}
