/**
 * Speed of the filter, and the time of its stages: stair-step meshes of labels compared with
 * vtkThreshold, which makes cells of the same voxels, and files of fractions. Cases run in turn, so
 * that their ratios are valid on a busy machine.
 *
 * usage: FilterSpeed [cells along an axis of the labels, default 160] [rounds, default 5]
 *                    [threads, default 1] [files.vti ...]
 *
 * Seconds and CPU are of the median round. The ratio is cells per second of CPU over the rate of
 * vtkThreshold, median over the rounds. "outside" is the share of time outside the mesher itself.
 * The stages of the median round follow.
 */
#include "MeasureAlone.h"
#include "MeshCases.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkThreshold.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeFractionToHex.h"
#include "vtkXMLImageDataReader.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr char Header[] = "| case | threads | cells | seconds | CPU | cells/s | ratio | outside |\n"
                          "|---|---|---|---|---|---|---|---|\n";

double CpuSeconds()
{
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Stage
{
  std::string Name;
  double Seconds;
};

struct Round
{
  double Seconds, Cpu;
  std::vector<Stage> Stages;
  vtkIdType Cells;

  double Speed() const { return static_cast<double>(this->Cells) / this->Cpu; }
  /// Returns the share of time outside the mesher: stages before and after it, and
  /// the time before the first stage.
  double Outside() const
  {
    double mesher = 0.0;
    for (const Stage& stage : this->Stages)
    {
      const bool isOutside = stage.Name == "Reading input" || stage.Name == "Filling output";
      mesher += isOutside ? 0.0 : stage.Seconds;
    }
    return 1.0 - mesher / this->Seconds;
  }
};

/// Times the stages that an algorithm names in its progress.
class StageWatch
{
public:
  explicit StageWatch(vtkAlgorithm* algorithm)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback([](vtkObject* caller, unsigned long, void* watch, void*)
      { static_cast<StageWatch*>(watch)->Note(vtkAlgorithm::SafeDownCast(caller)); });
    algorithm->AddObserver(vtkCommand::ProgressEvent, command);
  }
  /// Call after the algorithm has ended.
  std::vector<Stage> Finish()
  {
    this->Close();
    return this->Stages;
  }

private:
  void Note(vtkAlgorithm* algorithm)
  {
    const char* const text = algorithm->GetProgressText();
    if (text && (this->Stages.empty() || this->Stages.back().Name != text))
    {
      this->Close();
      this->Stages.push_back({ text, 0.0 });
    }
  }
  void Close()
  {
    const double now = Now();
    if (!this->Stages.empty())
    {
      this->Stages.back().Seconds = now - this->Begin;
    }
    this->Begin = now;
  }

  std::vector<Stage> Stages;
  double Begin = 0.0;
};

struct Case
{
  std::string Name;
  std::function<vtkSmartPointer<vtkAlgorithm>()> Make;
  std::vector<Round> Rounds;
};

Round Measure(vtkAlgorithm* algorithm)
{
  StageWatch watch(algorithm);
  const double begin = Now(), cpu = CpuSeconds();
  algorithm->Update();
  Round round{ Now() - begin, CpuSeconds() - cpu, watch.Finish(), 0 };
  auto* cells = vtkUnstructuredGrid::SafeDownCast(algorithm->GetOutputDataObject(0));
  round.Cells = cells ? cells->GetNumberOfCells() : 0;
  return round;
}

template <class Array>
vtkSmartPointer<vtkImageData> MakeLabelImage(int n)
{
  const CartesianGrid grid = MakeUnitGrid(n);
  const FractionField labels = MakeConcentricLabels(grid, n);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n + 1, n + 1, n + 1);
  vtkNew<Array> array;
  array->SetName("label");
  ForRows(grid.Owned(),
    [&](Index j, Index k)
    {
      const Index row = grid.Linear({ { 0, j, k } });
      for (Index i = 0; i < n; ++i)
      {
        array->InsertNextValue(static_cast<typename Array::ValueType>(labels.Label(row + i)));
      }
    });
  image->GetCellData()->AddArray(array);
  return image;
}

/// Reads an image. The filter must recognize arrays that are not materials, such as coordinates.
vtkSmartPointer<vtkImageData> ReadImage(const std::string& path)
{
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

vtkSmartPointer<vtkAlgorithm> MakeThreshold(vtkImageData* labels)
{
  auto threshold = vtkSmartPointer<vtkThreshold>::New();
  threshold->SetInputData(labels);
  threshold->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "label");
  threshold->SetLowerThreshold(1.0);
  threshold->SetUpperThreshold(1e9);
  return threshold;
}

vtkSmartPointer<vtkVolumeFractionToHex> MakeMesher(vtkImageData* image, int threads)
{
  auto mesher = vtkSmartPointer<vtkVolumeFractionToHex>::New();
  mesher->SetInputDataObject(image);
  mesher->SetNumberOfThreads(threads);
  return mesher;
}

std::vector<Case> ListLabelCases(vtkImageData* labels, const std::string& type, int threads)
{
  const auto stairs = [=](bool stairStep, bool quality)
  {
    return [=]() -> vtkSmartPointer<vtkAlgorithm>
    {
      const auto mesher = MakeMesher(labels, threads);
      mesher->SetMaterialIdArray("label");
      mesher->SetStairStep(stairStep);
      mesher->SetComputeQuality(quality);
      return mesher;
    };
  };
  return { { "vtkThreshold, " + type, [=] { return MakeThreshold(labels); }, {} },
    { "stair-step, " + type, stairs(true, true), {} },
    { "stair-step without quality, " + type, stairs(true, false), {} } };
}

void AddFileCases(const std::string& path, int threads, std::vector<Case>& cases)
{
  const vtkSmartPointer<vtkImageData> image = ReadImage(path);
  const std::string name = path.substr(path.rfind('/') + 1);
  for (bool stairStep : { false, true })
  {
    const auto make = [=]() -> vtkSmartPointer<vtkAlgorithm>
    {
      const auto mesher = MakeMesher(image, threads);
      for (int a = 0; a < image->GetCellData()->GetNumberOfArrays(); ++a)
      {
        mesher->AddVolumeFractionArray(image->GetCellData()->GetArrayName(a));
      }
      mesher->SetStairStep(stairStep);
      return mesher;
    };
    cases.push_back({ name + (stairStep ? ", stair-step" : ""), make, {} });
  }
}

double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// reference: the case that the ratio refers to; null: no ratio.
void Print(const Case& what, const Case* reference, int threads)
{
  std::vector<Round> rounds = what.Rounds;
  std::vector<double> ratios;
  for (std::size_t r = 0; reference && r < rounds.size(); ++r)
  {
    ratios.push_back(rounds[r].Speed() / reference->Rounds[r].Speed());
  }
  std::sort(
    rounds.begin(), rounds.end(), [](const Round& a, const Round& b) { return a.Cpu < b.Cpu; });
  const Round& median = rounds[rounds.size() / 2];
  std::printf("| %s | %d | %lld | %.3f | %.3f | %.0f | ", what.Name.c_str(), threads,
    static_cast<long long>(median.Cells), median.Seconds, median.Cpu, median.Speed());
  if (reference)
  {
    std::printf("%.2f", Median(ratios));
  }
  std::printf(" | ");
  if (!median.Stages.empty())
  {
    std::printf("%.0f %%", 100.0 * median.Outside());
  }
  std::printf(" |\n");
  for (const Stage& stage : median.Stages)
  {
    std::printf("    %-24s %7.3f s\n", stage.Name.c_str(), stage.Seconds);
  }
}

} // namespace

int main(int argc, char** argv)
{
  const auto argument = [&](int a, int otherwise)
  { return argc > a ? std::max(1, std::atoi(argv[a])) : otherwise; };
  const int n = argument(1, 160), rounds = argument(2, 5), threads = argument(3, 1);
  const vtkSmartPointer<vtkImageData> ints = MakeLabelImage<vtkIntArray>(n),
                                      bytes = MakeLabelImage<vtkUnsignedCharArray>(n);
  std::vector<Case> cases = ListLabelCases(ints, "int", threads);
  for (const Case& ofBytes : ListLabelCases(bytes, "unsigned char", threads))
  {
    cases.push_back(ofBytes);
  }
  const std::size_t labels = cases.size();
  for (int a = 4; a < argc; ++a)
  {
    AddFileCases(argv[a], threads, cases);
  }
  for (int r = 0; r < rounds; ++r)
  {
    for (Case& what : cases)
    {
      const vtkSmartPointer<vtkAlgorithm> algorithm = what.Make();
      what.Rounds.push_back(Measure(algorithm));
      if (what.Rounds.back().Cells == 0)
      {
        std::fprintf(stderr, "FilterSpeed: %s made no cells\n", what.Name.c_str());
        return 1;
      }
    }
  }
  std::printf("%s", Header);
  for (std::size_t c = 0; c < cases.size(); ++c)
  {
    Print(cases[c], c < labels ? &cases[c / 3 * 3] : nullptr, threads);
  }
  return 0;
}
