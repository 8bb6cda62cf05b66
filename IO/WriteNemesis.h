/**
 * WriteNemesis: what a file of one of several ranks says of the others: totals, and the nodes between ranks.
 */
#pragma once

#include "ExodusModel.h"

namespace vfm
{

class ExodusFile;

/// What readers need of the number of parts before all else; after ex_put_init.
void WriteNemesisHead(const ExodusModel& model, int count, ExodusFile& file);

/// Totals of blocks and sets, nodes and elements inside and on the border, and one communication map a neighbour, whose id is the
/// neighbour's rank + 1.
void WriteNemesis(const ExodusModel& model, int rank, ExodusFile& file);

} // namespace vfm
