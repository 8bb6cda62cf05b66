/**
 * StandardStreams: standard input, output and error, which a program may be started without.
 */
#pragma once

namespace vfm
{

/// Opens /dev/null in place of standard streams that are closed. Otherwise the next file or pipe
/// would become standard output, and texts of the program and of libraries would be written to it.
/// @note Call it once, at the start of main.
void OpenStandardStreams();

} // namespace vfm
