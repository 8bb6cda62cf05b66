/**
 * WorkTogether: no rank waits for one that failed.
 */
#pragma once

#include "Ranks/Ranks.h"

#include <type_traits>

namespace vfm
{

/// As below, with the work as a function of a pointer.
void WorkTogether(Ranks& ranks, Ranks::Frame frame, void (*work)(void*), void* what);

/// Collective: every rank does its work, which may communicate through these ranks. When it throws on any rank (InputError, lack of
/// memory, anything else), all ranks throw InputError with the code and the message of the lowest rank that failed on its own account, even those that
/// wait for messages or have done their work; what was on its way is gone, and the ranks can be used again. Inside another such
/// work of the same ranks it is the work alone. Needs no memory. Aborted, which only a lone rank may throw, passes through.
template <class Work>
void WorkTogether(Ranks& ranks, Work&& work, Ranks::Frame frame = Ranks::Frame::Inner)
{
  using Plain = std::remove_reference_t<Work>;
  WorkTogether(
    ranks, frame, [](void* what) { (*static_cast<Plain*>(what))(); },
    const_cast<void*>(static_cast<const void*>(&work)));
}

/// Collective: the same, in a step of a program or a host. Errors that have no code get this one; of an exception that is no
/// std::exception it is InternalError.
template <class Work>
void WorkInStage(
  Ranks& ranks, ErrorCode code, const Work& work, Ranks::Frame frame = Ranks::Frame::Stage)
{
  const auto classified = [&] { ClassifyErrors(code, work); };
  ClassifyErrors(ErrorCode::InternalError, [&] { WorkTogether(ranks, classified, frame); });
}

} // namespace vfm
