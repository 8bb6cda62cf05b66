#include "MakeMesh.h"

#include "Base/ParseText.h"
#include "Base/ThreadRuntime.h"
#include "CollectBlocks.h"
#include "Labels/ReadLabelNames.h"
#include "Ranks/PrintableText.h"
#include "Ranks/WorkTogether.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <unistd.h>

namespace vfm
{
namespace
{

/// Runtime that shows the progress as one line of a terminal, which is cleared at the end.
class TerminalRuntime : public ThreadRuntime
{
public:
  TerminalRuntime(int threads, Ranks& ranks, bool isShown) :
    ThreadRuntime(threads, &ranks), IsShown(isShown)
  {
  }
  ~TerminalRuntime() override
  {
    if (this->IsShown)
    {
      std::fprintf(stderr, "\r\033[K");
    }
  }
  void Progress(double fraction, const char* stage) override
  {
    if (this->IsShown)
    {
      std::fprintf(stderr, "\r\033[K%3.0f %% %s", 100.0 * fraction, stage);
      std::fflush(stderr);
    }
  }

private:
  const bool IsShown;
};

/// Returns the arrays of materials and state, and the names of labels.
/// @param warn  receives notes about the names
/// @pre Collective
MesherArrays NameArrays(const Arguments& arguments, const Input& input, const ChosenArrays& arrays,
  Ranks& ranks, const std::function<void(const std::string&)>& warn)
{
  ArrayLists lists = ListsOf(input, ArrayPlace::Cells);
  const ArrayLists points = ListsOf(input, ArrayPlace::Points);
  lists.insert(lists.end(), points.begin(), points.end());
  const std::string& table = arguments.Mesher.LabelNames;
  return { arrays.Fractions, arrays.Labels,
    arrays.Labels.empty() ? LabelNames()
      : table.empty()     ? input.Names
                          : ShareLabelNames(table, ranks, warn),
    CompleteChoice(ChooseState(arguments.Mesher, arguments.State), lists, ranks), arrays.AreGuessed,
    !arguments.Materials.empty() };
}

std::vector<ChosenArray> ListMaterials(const MesherArrays& arrays)
{
  std::vector<ChosenArray> materials;
  for (const std::string& name :
    arrays.Labels.empty() ? arrays.Fractions : std::vector<std::string>{ arrays.Labels })
  {
    materials.push_back({ name });
  }
  return materials;
}

/// Reports a mesh without elements.
/// @param hasGridOfOwn  whether the input is surfaces, around which the program places the cells
/// @pre Collective
void CheckElements(const Mesh& mesh, const ChosenArrays& arrays, bool hasGridOfOwn, Ranks& ranks)
{
  if (!ranks.Any(!mesh.Material.empty()))
  {
    throw InputError(ErrorCode::RejectedMesh,
      "The mesh has no elements, so no file is written: the materials from " +
        (arrays.Labels.empty() ? JoinTexts(arrays.Fractions) : arrays.Labels) + " (" + arrays.How +
        ") fill no cell to the iso value. " +
        (hasGridOfOwn ? "Use more cells (--cells), or narrower ones (--cell-width)."
                      : "sculptor --list shows what the arrays hold; --fractions, --labels and "
                        "--threshold select others."));
  }
}

} // namespace

MesherResult MakeMesh(const Arguments& arguments, const Input& input, const ChosenArrays& arrays,
  Ranks& ranks, std::vector<std::string>* warnings, CellRuns* leftOut)
{
  const MesherOptions& options = arguments.Mesher;
  MesherInput mesherInput;
  CollectedBlocks collected;
  std::vector<std::string> found;
  mesherInput.Warn = [&found](const std::string& text)
  {
    if (!text.empty() && std::find(found.begin(), found.end(), text) == found.end())
    {
      found.push_back(text);
    }
  };
  WorkInStage(ranks, ErrorCode::RejectedMesh,
    [&]
    {
      mesherInput.Arrays = NameArrays(arguments, input, arrays, ranks, mesherInput.Warn);
      collected = input.Collect(
        ListArrays(ListMaterials(mesherInput.Arrays), mesherInput.Arrays.State, options), ranks);
    });
  KeepMaterials(collected.Blocks, arrays, arguments, ranks);
  mesherInput.Surfaces = input.Surfaces;
  mesherInput.Warn(input.Warning);
  MesherResult result;
  WorkInStage(ranks, ErrorCode::RejectedMesh,
    [&]
    {
      const bool isShown = !arguments.Quiet && ranks.Rank() == 0 && isatty(STDERR_FILENO);
      TerminalRuntime runtime(
        ChooseThreads(options.NumberOfThreads, ranks.Count()), ranks, isShown);
      mesherInput.Levels = FindInputLevels(std::move(collected), ranks);
      result = RunMesher(mesherInput, options, runtime, leftOut);
    });
  CheckElements(result.TheMesh, arrays, !arguments.SurfaceFiles.empty(), ranks);
  for (const std::string& warning : found)
  {
    std::cerr << (ranks.Rank() == 0 ? "sculptor: warning: " + MakePrintable(warning) + "\n" : "");
  }
  if (warnings)
  {
    *warnings = std::move(found);
  }
  return result;
}

} // namespace vfm
