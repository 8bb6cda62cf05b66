/**
 * MakeSinks: who takes the fields, by the command line and by what this program was built with.
 */
#pragma once

#include "Domain.h"
#include "Fields.h"
#include "Options.h"

#include <memory>
#include <vector>

namespace impact
{

/// Collective. Throws std::invalid_argument where a sink is asked for that was not built,
/// std::runtime_error where one cannot be made.
std::vector<std::unique_ptr<Sink>> MakeSinks(const Options& options, const Domain& domain);

} // namespace impact
