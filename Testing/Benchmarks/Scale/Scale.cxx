/**
 * Memory, time and messages of each rank, for any number of bodies and of ranks. Ranks are threads.
 *
 * usage: Scale SCENE SIZE RANKS [option ...]
 *   SCENE: spray, grains, ball or gyroid (ScaleScenes.h)
 *   SIZE: drops or grains, or cells of a ball and a gyroid, along the axes: 20 or 20x20x10
 *   RANKS: ranks along the axes: 2 or 8x1x1; each gives the cells of one block to the mesher
 *     SIZE and RANKS may be lists, such as 10,20,40; each of their pairs is a row
 *   --per-rank: SIZE is of each rank
 *   --stairs: stair-step instead of smoothed
 *   --spacing N: cells along each axis per drop or grain (6)
 *   --radii LEAST,LARGEST: of drops, in cells (1,1.9)
 *   --whole-tables Automatic|Off|On (Automatic)
 *   --stages: a row per stage as well
 *
 * Figures are of the rank that has most. CPU seconds of all ranks and of one rank do not include
 * waiting. MB of a rank: what its thread has allocated at its peak, with its input; MB of the
 * process are those of all ranks. Messages and bytes are those that a rank sends to others. Sums
 * and maxima count by the bytes that they reduce, gathers by the bytes that each rank gets. Volume:
 * the largest relative error of a material. Each run is a process of its own.
 */
#include "Input/PlainArrays.h"
#include "LabelInput.h"
#include "MeasureAlone.h"
#include "MeshDigest.h"
#include "Options/OptionTable.h"
#include "RankFields.h"
#include "ScaleScenes.h"
#include "SerialTimes.h"
#include "ThreadMemory.h"

#include <cstdio>
#include <cstdlib>
#include <set>
#include <sstream>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Figures of a rank, of one stage or of a whole run.
struct RankFigures
{
  std::string Stage;
  double Seconds = 0.0;
  std::int64_t PeakBytes = 0;
  ThreadRanks::Traffic Traffic;
};

/// The members of Traffic.
constexpr std::int64_t ThreadRanks::Traffic::*TrafficMembers[] = { &ThreadRanks::Traffic::Exchanges,
  &ThreadRanks::Traffic::Messages, &ThreadRanks::Traffic::MessageBytes,
  &ThreadRanks::Traffic::Reductions, &ThreadRanks::Traffic::ReducedBytes,
  &ThreadRanks::Traffic::Gathers, &ThreadRanks::Traffic::GatheredBytes };

/// Measures the stages of one rank.
class MeasuredRuntime : public RankRuntime
{
public:
  explicit MeasuredRuntime(ThreadRanks& ranks) : RankRuntime(ranks), TheGroup(ranks)
  {
    TakePeakOfThread();
  }
  void Progress(double, const char* stage) override
  {
    if (this->Stages.empty() || this->Stages.back().Stage != stage)
    {
      this->Close();
      this->Stages.push_back({ stage, 0.0, 0, {} });
    }
  }
  /// Returns the figures of all stages, in their order.
  std::vector<RankFigures> Finish()
  {
    this->Close();
    return std::move(this->Stages);
  }

private:
  void Close()
  {
    const double now = CpuSeconds(CLOCK_THREAD_CPUTIME_ID);
    const std::int64_t peak = TakePeakOfThread();
    if (!this->Stages.empty())
    {
      RankFigures& last = this->Stages.back();
      last.Seconds = now - this->Since;
      last.PeakBytes = peak;
      for (const auto member : TrafficMembers)
      {
        last.Traffic.*member = this->TheGroup.Sent().*member - this->Before.*member;
      }
    }
    this->Since = CpuSeconds(CLOCK_THREAD_CPUTIME_ID);
    this->Before = this->TheGroup.Sent();
  }

  ThreadRanks& TheGroup;
  std::vector<RankFigures> Stages;
  double Since = 0.0;
  ThreadRanks::Traffic Before;
};

/// Adds figures of a stage to those of a run.
void Append(const RankFigures& stage, RankFigures& run)
{
  run.Seconds += stage.Seconds;
  run.PeakBytes = std::max(run.PeakBytes, stage.PeakBytes);
  for (const auto member : TrafficMembers)
  {
    run.Traffic.*member += stage.Traffic.*member;
  }
}

/// Replaces figures by the larger ones.
void TakeLarger(const RankFigures& other, RankFigures& figures)
{
  figures.Seconds = std::max(figures.Seconds, other.Seconds);
  figures.PeakBytes = std::max(figures.PeakBytes, other.PeakBytes);
  for (const auto member : TrafficMembers)
  {
    figures.Traffic.*member = std::max(figures.Traffic.*member, other.Traffic.*member);
  }
}

struct Arguments
{
  std::string Scene;
  Index3 Size, Ranks;
  bool IsPerRank = false, PrintsStages = false;
  SpraySizes Sizes;
  MesherOptions Options;
};

/// Figures of a run on all ranks.
struct Outcome
{
  std::vector<std::vector<RankFigures>> Stages; // by rank
  std::vector<Index> Elements;
  std::vector<std::uint64_t> Digests;
  MeshReport Report;
};

IndexBox BoxOfRank(const Index3& cells, const Index3& ranks, Index rank)
{
  const Index3 at{ { rank % ranks[0], rank / ranks[0] % ranks[1], rank / (ranks[0] * ranks[1]) } };
  IndexBox box;
  for (int a = 0; a < 3; ++a)
  {
    box.Lower[a] = cells[a] * at[a] / ranks[a];
    box.Upper[a] = cells[a] * (at[a] + 1) / ranks[a];
  }
  return box;
}

MesherInput MakeSceneInput(const ScaleScene& scene, const IndexBox& box, Ranks& ranks)
{
  auto arrays = std::make_shared<PlainArrays>(box.NumberOfCells());
  if (scene.AreLabels)
  {
    arrays->Store("bodies", ValueType::Int, scene.Labels(box));
  }
  else
  {
    arrays->Store("bodies", ValueType::Float, scene.Fractions(box));
  }
  MesherInput input = MakeInput({ MakeBlock(box, {}, 1.0, arrays) }, ranks);
  if (scene.AreLabels)
  {
    input.Arrays.Labels = "bodies";
  }
  else
  {
    input.Arrays.Fractions = { "bodies" };
  }
  return input;
}

Outcome Run(const ScaleScene& scene, const Arguments& arguments)
{
  const Index3& ranks = arguments.Ranks;
  const int count = static_cast<int>(ranks[0] * ranks[1] * ranks[2]);
  Outcome outcome;
  outcome.Stages.resize(count);
  outcome.Elements.resize(count);
  outcome.Digests.resize(count);
  RunOnRanks(count,
    [&](ThreadRanks& group)
    {
      const int rank = group.Rank();
      MeasuredRuntime runtime(group);
      runtime.Progress(0.0, "Filling cells");
      const MesherInput input = MakeSceneInput(scene, BoxOfRank(scene.Cells, ranks, rank), group);
      runtime.Progress(0.0, "Beginning");
      const MesherResult result = RunMesher(input, arguments.Options, runtime);
      outcome.Stages[rank] = runtime.Finish();
      outcome.Elements[rank] = static_cast<Index>(result.TheMesh.ElementIds.size());
      outcome.Digests[rank] = DigestOfRank(result.TheMesh);
      if (rank == 0)
      {
        outcome.Report = result.Report;
      }
    });
  return outcome;
}

void PrintStages(const Outcome& outcome)
{
  std::printf("| stage | CPU s | s of a rank | MB of a rank | messages | MB sent | reductions | kB "
              "reduced | gathers | kB gathered |\n|---|---|---|---|---|---|---|---|---|---|\n");
  for (std::size_t s = 0; s < outcome.Stages[0].size(); ++s)
  {
    RankFigures most = outcome.Stages[0][s];
    double sum = 0.0;
    for (const std::vector<RankFigures>& rank : outcome.Stages)
    {
      TakeLarger(rank.at(s), most);
      sum += rank[s].Seconds;
    }
    const ThreadRanks::Traffic& t = most.Traffic;
    std::printf("| %s | %.2f | %.2f | %.1f | %lld | %.3f | %lld | %.1f | %lld | %.1f |\n",
      most.Stage.c_str(), sum, most.Seconds, 1e-6 * static_cast<double>(most.PeakBytes),
      static_cast<long long>(t.Messages), 1e-6 * static_cast<double>(t.MessageBytes),
      static_cast<long long>(t.Reductions), 1e-3 * static_cast<double>(t.ReducedBytes),
      static_cast<long long>(t.Gathers), 1e-3 * static_cast<double>(t.GatheredBytes));
  }
}

double WorstVolumeOf(const MeshReport& report)
{
  double worst = 0.0;
  for (std::size_t m = 1; m < report.TargetVolume.size(); ++m)
  {
    const double target = report.TargetVolume[m];
    worst = std::max(worst, target > 0.0 ? std::fabs(report.MeshVolume[m] / target - 1.0) : 0.0);
  }
  return worst;
}

/// Returns the digest of the mesh.
std::uint32_t PrintRun(const Arguments& arguments, const ScaleScene& scene, const Outcome& outcome)
{
  RankFigures most;
  double sum = 0.0;
  for (const std::vector<RankFigures>& stages : outcome.Stages)
  {
    RankFigures run;
    for (const RankFigures& stage : stages)
    {
      Append(stage, run);
    }
    TakeLarger(run, most);
    sum += run.Seconds;
  }
  Index elements = 0;
  std::uint64_t digest = 0;
  for (std::size_t rank = 0; rank < outcome.Stages.size(); ++rank)
  {
    elements += outcome.Elements[rank];
    digest += outcome.Digests[rank];
  }
  const auto folded = static_cast<std::uint32_t>(digest ^ (digest >> 32));
  const Index3 &n = scene.Cells, &r = arguments.Ranks;
  const ThreadRanks::Traffic& traffic = most.Traffic;
  std::printf("| %s%s | %lldx%lldx%lld | %lld | %lld | %lld | %.1f | %.2f | %.1f | %.0f | %lld | "
              "%.3f | %.1f | %.1f | %.1e | %08x |\n",
    arguments.Scene.c_str(), arguments.Options.StairStep ? ", stairs" : "",
    static_cast<long long>(n[0]), static_cast<long long>(n[1]), static_cast<long long>(n[2]),
    static_cast<long long>(r[0] * r[1] * r[2]),
    static_cast<long long>(outcome.Report.NumberOfFragments), static_cast<long long>(elements), sum,
    most.Seconds, 1e-6 * static_cast<double>(most.PeakBytes),
    1e-6 * static_cast<double>(PeakBytes()), static_cast<long long>(traffic.Messages),
    1e-6 * static_cast<double>(traffic.MessageBytes),
    1e-3 * static_cast<double>(traffic.ReducedBytes),
    1e-3 * static_cast<double>(traffic.GatheredBytes), WorstVolumeOf(outcome.Report), folded);
  return folded;
}

/// Returns three numbers from 8 or 8x4x2.
Index3 ParseSize(const std::string& text)
{
  long long n[3] = { 0, 0, 0 };
  const int found = std::sscanf(text.c_str(), "%lldx%lldx%lld", n, n + 1, n + 2);
  const Index3 size = found == 3 ? Index3{ { n[0], n[1], n[2] } } : Index3{ { n[0], n[0], n[0] } };
  if ((found != 1 && found != 3) || *std::min_element(size.begin(), size.end()) < 1)
  {
    throw InputError("Scale: not a size: " + text);
  }
  return size;
}

/// Returns the sizes of a list such as 10,20x20x10.
std::vector<Index3> ParseSizes(const std::string& text)
{
  std::vector<Index3> sizes;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, ',');)
  {
    sizes.push_back(ParseSize(word));
  }
  return sizes;
}

/// Returns the options, without a size and ranks.
Arguments ParseOptions(int argc, char** argv)
{
  Arguments arguments;
  arguments.Scene = argv[1];
  for (int a = 4; a < argc; ++a)
  {
    const std::string word = argv[a], value = a + 1 < argc ? argv[a + 1] : "";
    arguments.IsPerRank = arguments.IsPerRank || word == "--per-rank";
    arguments.Options.StairStep = arguments.Options.StairStep || word == "--stairs";
    arguments.PrintsStages = arguments.PrintsStages || word == "--stages";
    if (word == "--spacing")
    {
      arguments.Sizes.Spacing = std::max(1, std::atoi(value.c_str()));
    }
    else if (word == "--radii")
    {
      std::sscanf(value.c_str(), "%lf,%lf", &arguments.Sizes.Least, &arguments.Sizes.Largest);
    }
    else if (word == "--whole-tables")
    {
      arguments.Options.WholeTables = value == "Off" ? TableMode::Off
        : value == "On"                              ? TableMode::On
                                                     : TableMode::Automatic;
    }
  }
  return arguments;
}

/// Returns the digest of the mesh.
std::uint32_t PrintRow(Arguments arguments)
{
  for (int a = 0; arguments.IsPerRank && a < 3; ++a)
  {
    arguments.Size[a] *= arguments.Ranks[a];
  }
  const ScaleScene scene = MakeScaleScene(arguments.Scene, arguments.Size, arguments.Sizes);
  const Outcome outcome = Run(scene, arguments);
  if (arguments.PrintsStages)
  {
    PrintStages(outcome);
  }
  const std::uint32_t digest = PrintRun(arguments, scene, outcome);
  std::fflush(stdout);
  return digest;
}

/// Prints the rows of a size, and whether all ranks give the same mesh. Returns false if a run
/// fails.
bool PrintRows(Arguments arguments, const std::vector<Index3>& ranks)
{
  std::set<double> digests;
  for (const Index3& count : ranks)
  {
    arguments.Ranks = count;
    const std::vector<double> digest = MeasureAlone(
      1, [&] { return std::vector<double>{ static_cast<double>(PrintRow(arguments)) }; });
    if (digest.empty())
    {
      return false;
    }
    digests.insert(digest[0]);
  }
  if (ranks.size() > 1 && !arguments.IsPerRank)
  {
    std::printf("Digests %s\n", digests.size() == 1 ? "are equal" : "differ");
    std::fflush(stdout);
  }
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 4)
  {
    std::fprintf(stderr, "usage: Scale SCENE SIZE RANKS [option ...]\n");
    return 1;
  }
  GetOptionTable(); // front ends have it before the fields, too: later it would split free memory
  std::printf(
    "| scene | cells | ranks | fragments | elements | CPU s | s of a rank | MB of a rank | "
    "MB of the process | messages | MB sent | kB reduced | kB gathered | volume | digest |"
    "\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  std::fflush(stdout);
  try
  {
    Arguments arguments = ParseOptions(argc, argv);
    const std::vector<Index3> ranks = ParseSizes(argv[3]);
    for (const Index3& size : ParseSizes(argv[2]))
    {
      arguments.Size = size;
      if (!PrintRows(arguments, ranks))
      {
        return 1;
      }
    }
  }
  catch (const InputError& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
