/**
 * WorkTogether: errors of one rank become those of all.
 */
#pragma once

#include <functional>
#include <string>

#include <mpi.h>

namespace impact
{

/// Collective: when the work fails on any rank, all throw std::runtime_error with the message of
/// the lowest that failed.
void WorkTogether(MPI_Comm communicator, const std::function<void()>& work);

/// Collective: with those above it; nothing where it is there.
void MakeFolder(MPI_Comm communicator, const std::string& path);

} // namespace impact
