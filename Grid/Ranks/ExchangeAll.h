/**
 * ExchangeAll: messages from every rank to every rank.
 */
#pragma once

#include "Ranks/Ranks.h"

namespace vfm
{

/// Collective: sends messages[r] to each rank r and returns what those sent here; the own message stays.
std::vector<Bytes> ExchangeAll(std::vector<Bytes> messages, Ranks& ranks);

} // namespace vfm
