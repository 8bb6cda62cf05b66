#include "ReaderSteps.h"

#include "OpenFile.h"
#include "Ranks/WorkTogether.h"
#include "VtkMessages.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace vfm
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

void RejectInput(const std::string& message)
{
  throw InputError(ErrorCode::UnreadableInput, message);
}

void CheckInput(const std::string& path, const std::function<void()>& step, const std::string& head)
{
  PrefixErrors(head + path + ": ", step);
}

void CheckInputFile(const std::string& path, const std::string& role)
{
  CheckInput(path + role, [&path] { OpenFile(path); });
}

std::vector<double> GetTimes(vtkAlgorithm* reader)
{
  vtkInformation* info = reader->GetOutputInformation(0);
  const double* times = info->Get(Pipeline::TIME_STEPS());
  return times ? std::vector<double>(times, times + info->Length(Pipeline::TIME_STEPS()))
               : std::vector<double>();
}

std::optional<double> ChooseTime(const Arguments& arguments, const std::vector<double>& times)
{
  const std::size_t step = arguments.Step.value_or(0);
  if (step >= std::max<std::size_t>(times.size(), 1))
  {
    RejectInput("The input " + arguments.Input + " has no step " + std::to_string(step) +
      ": it has " + std::to_string(std::max<std::size_t>(times.size(), 1)) + ", counted from 0.");
  }
  if (times.empty())
  {
    if (arguments.Time)
    {
      RejectInput("The input " + arguments.Input + " has no times, so --time cannot choose one.");
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

std::vector<std::string> ListNamedArrays(
  const Arguments& arguments, const std::vector<std::string>& there)
{
  std::vector<std::string> names = arguments.Fractions;
  const std::vector<std::string> others = ListOtherArrays(arguments, there);
  names.insert(names.end(), others.begin(), others.end());
  if (!arguments.Labels.empty())
  {
    names.push_back(arguments.Labels);
  }
  return names;
}

void UpdatePiece(
  vtkAlgorithm* reader, const std::optional<double>& time, int piece, int numberOfPieces)
{
  if (time)
  {
    reader->UpdateTimeStep(*time, piece, numberOfPieces);
  }
  else
  {
    reader->UpdatePiece(piece, numberOfPieces, 0);
  }
}

void CheckReaderErrors(const VtkMessages& messages, const std::string& path)
{
  if (messages.HasErrors())
  {
    std::string text = messages.GetErrorText();
    const std::string prefix = "Cannot read " + path;
    const auto isControl = [](unsigned char c) { return std::iscntrl(c) != 0; };
    std::replace_if(text.begin(), text.end(), isControl, '?'); // words of a damaged file
    const bool tellsPath = text.compare(0, prefix.size(), prefix) == 0;
    RejectInput(tellsPath ? text : "Cannot read the input " + path + ": " + text);
  }
}

} // namespace vfm
