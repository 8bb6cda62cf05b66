/**
 * EndBySignal: ends the program by a signal without unfinished files, and reports it in one line.
 */
#pragma once

namespace vfm
{

/// Handles SIGTERM, SIGINT and SIGHUP: unfinished files are removed, a line on standard error names
/// the signal, and the process ends by the signal. Files that are replaced at that moment are
/// replaced first. A signal that is ignored, as by nohup, stays ignored. A file that becomes too
/// large for the limit of the process is an error of writing instead of SIGXFSZ.
/// @note Call it once, at the start of main.
void HandleSignals();

/// Leaves out the line on standard error, because another rank reports the signal, or because the
/// program has reported its end.
void HandleSignalsSilently();

} // namespace vfm
