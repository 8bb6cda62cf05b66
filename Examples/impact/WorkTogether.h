/**
 * WorkTogether: reports an error of one rank on all ranks.
 */
#pragma once

#include <functional>
#include <string>

#include <mpi.h>

namespace impact
{

/// Runs `work` on each rank.
/// @throws std::runtime_error  if any rank fails, on all ranks, with the message of the lowest one
///   that failed
/// @pre Collective
void WorkTogether(MPI_Comm communicator, const std::function<void()>& work);

/// Makes a folder and its parents, unless it exists.
/// @throws std::runtime_error  if that fails on any rank, on all ranks
/// @pre Collective
void MakeFolder(MPI_Comm communicator, const std::string& path);

} // namespace impact
