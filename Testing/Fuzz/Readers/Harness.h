/**
 * Harness: a function that reads arbitrary bytes by one reader. Each source Fuzz*.cxx defines
 * ReadBytes, and becomes a program: with libFuzzer (scripts/fuzz), or with DamageSeeds, which
 * needs no Clang.
 */
#pragma once

#include <string>

namespace vfm
{
namespace testing
{

/// Reads the bytes of a file, a command line or a text by the reader of this program.
/// @throws InputError  if the reader rejects them; any other exception is a finding
void ReadBytes(const std::string& bytes);

/// Writes a file into a folder of this process, in TMPDIR.
/// @param name  name of the file; it may contain folders
/// @return path of the file
std::string WriteInput(const std::string& name, const std::string& bytes);

/// Splits bytes after each occurrence of a separator, which is removed.
std::string TakeUntil(std::string& bytes, const std::string& separator);

} // namespace testing
} // namespace vfm

/// Entry of libFuzzer; DamageSeeds calls it too.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, unsigned long size);
