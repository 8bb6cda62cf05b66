/**
 * MesherInput: what a run of the mesher takes.
 */
#pragma once

#include "Input/InputLevels.h"
#include "Input/LabelNames.h"
#include "Options/MesherOptions.h"
#include "State/StateChoice.h"
#include "Surfaces/InputSurfaces.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace vfm
{

/// Names of the arrays that a run reads from the blocks.
struct MesherArrays
{
  std::vector<std::string> Fractions;    ///< one array per material; empty: Labels is set
  std::string Labels;                    ///< array of labels; empty: Fractions are set
  LabelNames Names;                      ///< names of labels
  StateChoice State;                     ///< state arrays to transfer to the mesh
  bool AreGuessed = false;               ///< true: the user did not select Fractions or Labels
  bool IsZeroVoid = false;               ///< label 0 is known to be void
  std::string LabelsOption = "--labels"; ///< words in front of the array of labels, in messages
};

/// Input of a run.
struct MesherInput
{
  InputLevels Levels;
  MesherArrays Arrays;
  /// true: each rank has one block and meshes its cells; required for input of FindNeighbourLevels,
  /// which knows only the blocks nearby and does not suit the option CellWidth with state,
  /// particles or requests of refinement. false: cells may be redistributed over the ranks.
  bool StaysInPlace = false;
  /// Surfaces from which the fractions were computed, equal on all ranks; may be null. Bodies whose
  /// names are not in Arrays.Fractions are ignored.
  std::shared_ptr<const InputSurfaces> Surfaces{};
  std::function<void(const std::string&)> Warn; ///< called only on rank 0; may be empty
};

/// What all phases of a run read. The referenced objects must outlive it.
struct MesherJob
{
  const MesherInput& Input;
  const MesherOptions& Options;
  Runtime& Run;
};

/// Passes a warning on rank 0 to the caller; an empty text is none.
inline void Warn(const MesherJob& job, const std::string& text)
{
  if (job.Run.Group().Rank() == 0 && !text.empty() && job.Input.Warn)
  {
    job.Input.Warn(text);
  }
}

inline bool AreLabels(const MesherJob& job)
{
  return !job.Input.Arrays.Labels.empty();
}

inline bool SmoothsLabels(const MesherJob& job)
{
  return job.Options.LabelSmoothing > 0 && AreLabels(job);
}

} // namespace vfm
