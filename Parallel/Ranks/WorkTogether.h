/**
 * WorkTogether: collective work with common error handling, so that no rank waits
 * for a failed rank.
 */
#pragma once

#include "Ranks/Ranks.h"

#include <type_traits>

namespace vfm
{

/// Calls work(what) in a frame; the function below explains frames.
void WorkTogether(Ranks& ranks, Ranks::Frame frame, void (*work)(void*), void* what);

/// Calls work() on every rank in a frame. The work may communicate through `ranks`. If it throws on
/// any rank, all ranks throw, even ranks that wait for messages or have finished their work.
/// Messages under way are discarded, and the ranks can be used again. Inside another frame of the
/// same ranks, work() is only called. The error handling needs no memory.
/// @throws InputError  the code and message of the lowest rank whose own work threw any exception
/// @throws Aborted  if the work of a single rank throws it; on several ranks
///   it becomes an InputError
/// @pre Collective over `ranks`.
template <class Work>
void WorkTogether(Ranks& ranks, Work&& work, Ranks::Frame frame = Ranks::Frame::Inner)
{
  using Plain = std::remove_reference_t<Work>;
  WorkTogether(
    ranks, frame, [](void* what) { (*static_cast<Plain*>(what))(); },
    const_cast<void*>(static_cast<const void*>(&work)));
}

/// Calls work() by WorkTogether as a step of a program or host. Errors without a code get the given
/// code; exceptions that are not derived from std::exception get InternalError.
/// @pre Collective over `ranks`.
template <class Work>
void WorkInStage(
  Ranks& ranks, ErrorCode code, const Work& work, Ranks::Frame frame = Ranks::Frame::Stage)
{
  const auto classified = [&] { ClassifyErrors(code, work); };
  ClassifyErrors(ErrorCode::InternalError, [&] { WorkTogether(ranks, classified, frame); });
}

} // namespace vfm
