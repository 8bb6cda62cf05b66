/**
 * DumpSink: writes the fields as files that ParaView reads: FOLDER/NAME_SSSS.pvti and a .vti of
 * every rank for each output step, and FOLDER/NAME.pvd with the times. Binary data, so the numbers
 * are the simulation's own bits.
 */
#pragma once

#include "Domain.h"
#include "Fields.h"

#include <string>

namespace impact
{

class DumpSink : public Sink
{
public:
  /// Collective. Makes the folder. withStates: those of each body instead of the means. Throws
  /// std::runtime_error on all ranks when that fails on one.
  DumpSink(
    const Domain& domain, const std::string& folder, const std::string& name, bool withStates);

  /// Throws std::runtime_error on all ranks when a file cannot be written on one.
  void Take(const Fields& fields) override;

private:
  std::vector<StateField> ListArrays(const Fields& fields) const;
  void WritePiece(const Fields& fields) const;
  void WriteIndex(const Fields& fields, const std::vector<std::int64_t>& extents) const;
  void WriteTimes(const Fields& fields);
  std::string NameFile(std::int64_t step, int rank) const;
  std::string PathOf(const std::string& name) const { return this->Folder + "/" + name; }

  const Domain& Grid;
  std::string Folder, Name, Times;
  bool WithStates;
};

} // namespace impact
