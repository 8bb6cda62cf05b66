#include "ExodusInput.h"

#include "Base/ParseText.h"
#include "ExodusFileCheck.h"
#include "FileSuffix.h"
#include "Ranks/Agreement.h"
#include "Ranks/WorkTogether.h"
#include "VtkInput.h"
#include "VtkMessages.h"
#include "VtkVersions.h"

#include "vtkDataArraySelection.h"
#include "vtkDataSet.h"
#include "vtkIOSSReader.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <memory>
#include <regex>
#include <set>
#include <unistd.h>

namespace vfm
{
namespace
{

constexpr const char* BlockIds = "object_id"; // name of VTK's reader for ids of element blocks

/// Parts of a name FILE.N.RANK.
struct DecomposedName
{
  std::string Base; // FILE
  int Count;        // N
  std::string CountText;
  std::size_t RankDigits; // number of digits of RANK, which may have leading zeros
};

/// Splits the name of a part of a decomposed file; returns nothing for other names.
std::optional<DecomposedName> ParseDecomposedName(const std::string& path)
{
  static const std::regex pattern("(.+)\\.([0-9]{1,6})\\.([0-9]{1,6})");
  std::smatch match;
  if (!std::regex_match(path, match, pattern))
  {
    return std::nullopt;
  }
  const int count = std::stoi(match[2]), rank = std::stoi(match[3]);
  if (rank >= count)
  {
    return std::nullopt;
  }
  return DecomposedName{ match[1], count, match[2], match[3].str().size() };
}

/// Returns all files of an input.
std::vector<std::string> FindFiles(const std::string& path)
{
  const auto name = ParseDecomposedName(path);
  if (!name)
  {
    return { path };
  }
  std::vector<std::string> files;
  for (int f = 0; f < name->Count; ++f)
  {
    const std::string rank = std::to_string(f);
    const std::size_t zeros = name->RankDigits - std::min(name->RankDigits, rank.size());
    files.push_back(name->Base + "." + name->CountText + "." + std::string(zeros, '0') + rank);
  }
  return files;
}

/// Gives a file a second name, without numbers at the end, during the lifetime of the object. For
/// FILE.1.0 the library of the reader would open FILE.
class PlainName
{
public:
  explicit PlainName(const std::string& path) : Descriptor(open(path.c_str(), O_RDONLY | O_CLOEXEC))
  {
    if (this->Descriptor < 0)
    {
      RejectInput("Cannot read the input " + path + ": " + std::strerror(errno) + ".");
    }
  }
  ~PlainName() { close(this->Descriptor); }
  PlainName(const PlainName&) = delete;
  PlainName& operator=(const PlainName&) = delete;
  std::string Get() const { return "/dev/fd/" + std::to_string(this->Descriptor); }

private:
  int Descriptor;
};

/// Makes the reader of one file.
/// @param first  first file of the input, the only one from which VTK's reader takes the times
vtkSmartPointer<vtkIOSSReader> MakeReader(
  const std::string& file, const std::string& first, bool readsBlockIds)
{
  auto reader = vtkSmartPointer<vtkIOSSReader>::New();
  reader->SetController(nullptr); // ranks do not wait for each other if a file is damaged
  reader->SetDatabaseTypeOverride("exodusII");
  reader->ScanForRelatedFilesOff();
  LookAtAllFiles(reader.Get());
  reader->AddProperty("ENABLE_FIELD_RECOGNITION", "OFF"); // keeps the names of the file
  reader->ApplyDisplacementsOff();
  reader->ReadQAAndInformationRecordsOff();
  reader->SetReadIds(readsBlockIds);
  reader->AddFileName(first.c_str());
  if (file != first)
  {
    reader->AddFileName(file.c_str());
  }
  return reader;
}

/// Files of this rank and their readers.
class ExodusFiles
{
public:
  ExodusFiles(const Arguments& from, VtkMessages& messages) : Messages(messages)
  {
    const std::vector<std::string> named = ListNamedArrays(from, {});
    this->ReadsBlockIds = std::find(named.begin(), named.end(), BlockIds) != named.end();
  }

  /// Opens files and reads their structure.
  /// @param all  files of all ranks
  void Open(const std::vector<std::string>& paths, const std::vector<std::string>& all)
  {
    for (const std::string& path : paths)
    {
      CheckExodusFile(path, all[0]);
      this->Paths.push_back(path);
      if (all.size() == 1 && ParseDecomposedName(path))
      {
        this->Alone = std::make_unique<PlainName>(path);
      }
      this->Readers.push_back(this->Alone
          ? MakeReader(this->Alone->Get(), this->Alone->Get(), this->ReadsBlockIds)
          : MakeReader(path, all[0], this->ReadsBlockIds));
      this->Messages.Watch(this->Readers.back());
      this->Readers.back()->UpdateInformation();
      CheckReaderErrors(this->Messages, path);
    }
  }

  /// Returns the times of the files; none on a rank without files.
  std::vector<double> FindTimes() const
  {
    return this->Readers.empty() ? std::vector<double>() : GetTimes(this->Readers[0]);
  }

  /// Returns the element variables of all files; only their names are set.
  std::vector<ArrayInfo> ListVariables() const
  {
    std::vector<ArrayInfo> list;
    for (vtkIOSSReader* reader : this->Readers)
    {
      vtkDataArraySelection* fields = reader->GetElementBlockFieldSelection();
      for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
      {
        AddArray(list, { fields->GetArrayName(i) });
      }
    }
    return list;
  }

  /// Reads the element blocks with the given variables.
  vtkSmartPointer<vtkDataObject> Read(
    const std::vector<std::string>& names, const std::optional<double>& time)
  {
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    for (std::size_t f = 0; f < this->Readers.size(); ++f)
    {
      vtkIOSSReader* reader = this->Readers[f];
      reader->GetNodeBlockFieldSelection()->DisableAllArrays();
      reader->GetElementBlockFieldSelection()->DisableAllArrays();
      ReadNoGlobalFields(reader);
      for (const std::string& name : names)
      {
        reader->GetElementBlockFieldSelection()->EnableArray(name.c_str());
      }
      const int pieces = reader->GetNumberOfFileNames(); // the last piece belongs to this file
      UpdatePiece(reader, time, pieces - 1, pieces);
      CheckReaderErrors(this->Messages, this->Paths[f]);
      for (vtkDataSet* grid : GetGrids(reader->GetOutputDataObject(0)))
      {
        blocks->SetBlock(blocks->GetNumberOfBlocks(), grid);
      }
    }
    return blocks;
  }

private:
  VtkMessages& Messages;
  bool ReadsBlockIds;
  std::vector<std::string> Paths;
  std::unique_ptr<PlainName> Alone; // name of FILE.1.0 for the reader
  std::vector<vtkSmartPointer<vtkIOSSReader>> Readers;
};

/// Returns the files of this rank; consecutive ranks get consecutive files.
std::vector<std::string> DistributeFiles(const std::vector<std::string>& paths, Ranks& ranks)
{
  const auto begin = [&](int rank)
  { return paths.begin() + (paths.size() * rank + ranks.Count() - 1) / ranks.Count(); };
  return { begin(ranks.Rank()), begin(ranks.Rank() + 1) };
}

/// Returns the times of the files.
/// @pre Collective
std::vector<double> AgreeOnTimes(const ExodusFiles& files, Ranks& ranks)
{
  for (const Bytes& bytes : ranks.Gather(ToBytes(files.FindTimes())))
  {
    if (!bytes.empty())
    {
      return FromBytes<double>(bytes);
    }
  }
  return {};
}

/// Returns the element variables that any file has, sorted.
/// @pre Collective
std::vector<std::string> UnionOfNames(const ExodusFiles& files, Ranks& ranks)
{
  std::set<std::string> names;
  for (const ArrayInfo& variable : UnionOfArrays(files.ListVariables(), ranks))
  {
    names.insert(variable.Name);
  }
  return { names.begin(), names.end() };
}

/// Returns the variables that the arguments name, or all if they name no materials.
std::vector<std::string> ChooseNames(
  const Arguments& arguments, const std::vector<std::string>& known)
{
  const std::vector<std::string> requested = ListNamedArrays(arguments, known);
  for (const std::string& name : requested)
  {
    if (name != BlockIds && !std::binary_search(known.begin(), known.end(), name))
    {
      RejectInput("The input " + arguments.Input + " has no element variable '" + name +
        "'. It has: " + (known.empty() ? "none" : JoinTexts(known)) + ".");
    }
  }
  return arguments.Fractions.empty() && arguments.Labels.empty() ? known : requested;
}

} // namespace

std::vector<std::string> GetExodusSuffixes()
{
  return { ".e", ".ex2", ".exo", ".exii", ".g" };
}

bool IsExodusFile(const std::string& path)
{
  std::error_code error; // a path without access is not a folder
  return (ParseDecomposedName(path) && !std::filesystem::is_directory(path, error)) ||
    HasSuffix(path, GetExodusSuffixes());
}

Input ReadExodus(const Arguments& arguments, VtkMessages& messages, Ranks& ranks)
{
  const std::vector<std::string> paths = FindFiles(arguments.Input);
  WorkInStage(ranks, ErrorCode::UnreadableInput,
    [&]
    {
      const std::string role =
        paths.size() > 1 ? " (one of " + std::to_string(paths.size()) + " files)" : "";
      for (std::size_t f = 0; ranks.Rank() == 0 && f < paths.size(); ++f)
      {
        CheckInputFile(paths[f], role);
      }
    });
  ExodusFiles files(arguments, messages);
  WorkInStage(
    ranks, ErrorCode::UnreadableInput, [&] { files.Open(DistributeFiles(paths, ranks), paths); });
  const std::vector<double> times = AgreeOnTimes(files, ranks);
  const std::vector<std::string> names = ChooseNames(arguments, UnionOfNames(files, ranks));
  Input input;
  const std::optional<double> time = ChooseTime(arguments, times);
  WorkInStage(
    ranks, ErrorCode::UnreadableInput, [&] { input = MakeInput(files.Read(names, time), ranks); });
  input.Time = time;
  input.Times = times;
  return input;
}

} // namespace vfm
