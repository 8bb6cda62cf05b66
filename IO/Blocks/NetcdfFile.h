/**
 * NetcdfFile: reads variables of a netCDF file. The classic formats need no library; files in the
 * format netCDF-4, which are HDF5 files, need the netCDF library (VFM_HAS_NETCDF).
 */
#pragma once

#include "Blocks/NetcdfHeader.h"

#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace vfm
{

/// Open file. Its functions throw InputError without the path if the file is truncated or damaged.
class NetcdfFile
{
public:
  virtual ~NetcdfFile() = default;

  const NetcdfHeader& Header() const { return this->Head; }
  /// Returns the variable with a name, or null.
  const StoredVariable* Find(const std::string& name) const;

  /// Reads the values of a variable, or of one of its records.
  std::vector<double> ReadReals(const StoredVariable& variable, Index record = 0);
  std::vector<Index> ReadIntegers(const StoredVariable& variable);
  std::string ReadText(const StoredVariable& variable);

protected:
  explicit NetcdfFile(NetcdfHeader header);

  /// Reads variable.Count values.
  virtual void Read(const StoredVariable& variable, Index record, std::span<double> values) = 0;
  virtual void Read(const StoredVariable& variable, Index record, std::span<Index> values) = 0;
  virtual void Read(const StoredVariable& variable, Index record, std::span<char> text) = 0;

private:
  /// Checks that a record exists; the length of a file does not limit one that does not.
  void CheckRecord(const StoredVariable& variable, Index record) const;

  NetcdfHeader Head;
  std::unordered_map<std::string, std::size_t> Numbers; // of the variables
};

/// Opens a file of any netCDF format.
/// @throws InputError  if it cannot be read or is damaged; the message does not contain the path
std::unique_ptr<NetcdfFile> OpenNetcdf(const std::string& path);

/// Opens a file in the format netCDF-4.
/// @throws InputError  same conditions, or if the netCDF library is missing
std::unique_ptr<NetcdfFile> OpenNetcdf4(const std::string& path);

} // namespace vfm
