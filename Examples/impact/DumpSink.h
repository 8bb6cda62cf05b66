/**
 * DumpSink: writes the fields as files that ParaView reads: FOLDER/impact_SSSS.pvti and a .vti of every rank for each
 * output step, and FOLDER/impact.pvd with the times. Binary data, so the numbers are the simulation's own bits.
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
  /// Collective. Makes the folder. Throws std::runtime_error on all ranks when that fails on one.
  DumpSink(const Domain& domain, const std::string& folder);

  /// Throws std::runtime_error on all ranks when a file cannot be written on one.
  void Take(const Fields& fields) override;

private:
  void WritePiece(const Fields& fields) const;
  void WriteIndex(const Fields& fields, const std::vector<std::int64_t>& extents) const;
  void WriteTimes(const Fields& fields);
  std::string PathOf(const std::string& name) const { return this->Folder + "/" + name; }

  const Domain& Grid;
  std::string Folder, Times;
};

} // namespace impact
