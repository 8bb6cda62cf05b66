/**
 * ExchangeAll: messages from every rank to every rank.
 */
#pragma once

#include "Ranks/Ranks.h"

namespace vfm
{

/// Sends messages[r] to each rank r and returns the messages received, by rank. The message to this
/// rank is returned without being sent.
/// @pre Collective over `ranks`.
std::vector<Bytes> ExchangeAll(std::vector<Bytes> messages, Ranks& ranks);

} // namespace vfm
