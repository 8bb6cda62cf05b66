/**
 * DumpSink: writes the fields as files that ParaView reads. An output step gives
 * FOLDER/NAME_SSSS.pvti and one .vti per rank; FOLDER/NAME.pvd lists the times. Data are binary, so
 * that the numbers are bitwise identical to the fields.
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
  /// Makes the folder.
  /// @param[in] withStates  write the state of each body instead of means over both
  /// @throws std::runtime_error  if the folder cannot be made, on all ranks
  /// @pre Collective
  DumpSink(
    const Domain& domain, const std::string& folder, const std::string& name, bool withStates);

  /// Writes the files of an output step.
  /// @throws std::runtime_error  if any rank cannot write its file, on all ranks
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
