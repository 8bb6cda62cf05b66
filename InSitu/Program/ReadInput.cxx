#include "ReadInput.h"

#include "FileSuffix.h"
#include "ParseText.h"
#include "SpyPlotInput.h"
#include "Stage.h"
#include "VtkMessages.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLMultiBlockDataReader.h"
#include "vtkXMLPImageDataReader.h"
#include "vtkXMLPRectilinearGridReader.h"
#include "vtkXMLRectilinearGridReader.h"
#include "vtkXMLUniformGridAMRReader.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <iostream>
#include <sstream>

namespace vfm
{
namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

struct Format
{
  const char* Suffix;
  std::function<vtkSmartPointer<vtkAlgorithm>(const Arguments&)> MakeReader;
};

template <class Reader>
Format MakeFormat(const char* suffix)
{
  return { suffix,
    [](const Arguments& arguments)
    {
      auto reader = vtkSmartPointer<Reader>::New();
      reader->SetFileName(arguments.Input.c_str());
      return vtkSmartPointer<vtkAlgorithm>(reader);
    } };
}

vtkSmartPointer<vtkAlgorithm> MakeAmrReader(const Arguments& arguments)
{
  auto reader = vtkSmartPointer<vtkXMLUniformGridAMRReader>::New();
  reader->SetFileName(arguments.Input.c_str());
  reader->SetMaximumLevelsToReadByDefault(0); // all of them
  return reader;
}

const std::vector<Format>& Formats()
{
  static const std::vector<Format> formats = []
  {
    std::vector<Format> list{
      MakeFormat<vtkXMLImageDataReader>(".vti"),
      MakeFormat<vtkXMLPImageDataReader>(".pvti"),
      MakeFormat<vtkXMLRectilinearGridReader>(".vtr"),
      MakeFormat<vtkXMLPRectilinearGridReader>(".pvtr"),
      MakeFormat<vtkXMLMultiBlockDataReader>(".vtm"),
      { ".vthb", MakeAmrReader },
      { ".vth", MakeAmrReader },
    };
    if (HasSpyPlotReader())
    {
      list.push_back({ ".spcth", MakeSpyPlotReader });
    }
    return list;
  }();
  return formats;
}

const Format* FindFormat(const std::string& path)
{
  const auto& formats = Formats();
  const auto found = std::find_if(formats.begin(), formats.end(),
    [&path](const Format& format) { return HasSuffix(path, format.Suffix); });
  return found == formats.end() ? nullptr : &*found;
}

[[noreturn]] void Refuse(const std::string& message)
{
  throw ProgramError(ExitCode::UnreadableInput, message);
}

void CheckFile(const std::string& path)
{
  std::ifstream file(path);
  file.peek(); // folders open, but cannot be read
  if (!file)
  {
    Refuse("Cannot read the input " + path + ": " +
      (errno ? std::strerror(errno) : "the file is empty") + ".");
  }
}

std::vector<double> GetTimes(vtkAlgorithm* reader)
{
  vtkInformation* info = reader->GetOutputInformation(0);
  const double* times = info->Get(Pipeline::TIME_STEPS());
  return times ? std::vector<double>(times, times + info->Length(Pipeline::TIME_STEPS()))
               : std::vector<double>();
}

/// Nothing where the file has no times.
std::optional<double> ChooseTime(const Arguments& arguments, const std::vector<double>& times)
{
  const std::size_t step = arguments.Step.value_or(0);
  if (step >= std::max<std::size_t>(times.size(), 1))
  {
    Refuse("The input " + arguments.Input + " has no step " + std::to_string(step) + ": it has " +
      std::to_string(std::max<std::size_t>(times.size(), 1)) + ", counted from 0.");
  }
  if (times.empty())
  {
    if (arguments.Time)
    {
      Refuse("The input " + arguments.Input + " has no times, so --time cannot choose one.");
    }
    return std::nullopt;
  }
  if (!arguments.Time)
  {
    return times[step];
  }
  return *std::min_element(times.begin(), times.end(),
    [&arguments](double a, double b)
    { return std::abs(a - *arguments.Time) < std::abs(b - *arguments.Time); });
}

void CheckErrors(const VtkMessages& messages, const std::string& path)
{
  if (messages.HasErrors())
  {
    Refuse("Cannot read the input " + path + ": " + messages.GetErrorText());
  }
}

/// While this lives std::cerr prints nothing: there VTK's AMR data sets warn where a rank has no blocks of a SpyPlot file.
class QuietCerr
{
public:
  QuietCerr() = default;
  ~QuietCerr() { std::cerr.rdbuf(this->Buffer); }
  QuietCerr(const QuietCerr&) = delete;
  QuietCerr& operator=(const QuietCerr&) = delete;

private:
  std::streambuf* Buffer = std::cerr.rdbuf(nullptr);
};

} // namespace

std::vector<std::string> GetInputSuffixes()
{
  std::vector<std::string> suffixes;
  for (const Format& format : Formats())
  {
    suffixes.emplace_back(format.Suffix);
  }
  return suffixes;
}

void CheckInputSuffix(const std::string& path)
{
  if (!FindFormat(path))
  {
    throw ProgramError(ExitCode::WrongArguments,
      "The input " + path + " is of an unknown kind. Read are " + JoinTexts(GetInputSuffixes()) +
        ".");
  }
}

Input ReadInput(const Arguments& arguments, Ranks& ranks)
{
  VtkMessages messages;
  const VtkSilence silence(messages);
  const QuietCerr quiet;
  vtkSmartPointer<vtkAlgorithm> reader;
  Input input;
  WorkInStage(ranks, ExitCode::UnreadableInput,
    [&]
    {
      CheckFile(arguments.Input);
      reader = FindFormat(arguments.Input)->MakeReader(arguments);
      messages.Watch(reader);
      const std::string problem = ranks.Rank() > 0 ? "" : FindSpyPlotProblem(reader, arguments);
      if (!problem.empty())
      {
        Refuse("Cannot read the input " + arguments.Input + ": " + problem +
          (messages.HasErrors() ? " " + messages.GetErrorText() : ""));
      }
    });
  WorkInStage(ranks, ExitCode::UnreadableInput,
    [&]
    {
      reader->UpdateInformation();
      CheckErrors(messages, arguments.Input);
      input.Time = ChooseTime(arguments, GetTimes(reader));
    });
  ChooseSpyPlotArrays(reader, arguments, ranks);
  WorkInStage(ranks, ExitCode::UnreadableInput,
    [&]
    {
      if (input.Time)
      {
        reader->UpdateTimeStep(*input.Time, ranks.Rank(), ranks.Count());
      }
      else
      {
        reader->UpdatePiece(ranks.Rank(), ranks.Count(), 0);
      }
      CheckErrors(messages, arguments.Input);
      input.Data = reader->GetOutputDataObject(0);
    });
  return input;
}

} // namespace vfm
