/**
 * MakeSinks: creates the sinks that the command line selects.
 */
#pragma once

#include "Domain.h"
#include "Fields.h"
#include "Options.h"

#include <memory>
#include <vector>

namespace impact
{

/// Creates the sinks that the options select.
/// @throws std::invalid_argument  if this program was built without a selected sink
/// @throws std::runtime_error  if a sink cannot be created
/// @pre Collective
std::vector<std::unique_ptr<Sink>> MakeSinks(const Options& options, const Domain& domain);

} // namespace impact
