/**
 * Hdf5: handles of the HDF5 library that close themselves, and suppression of its error output.
 */
#pragma once

#include "Ranks/Errors.h"

#include <hdf5.h>
#include <string>

namespace vfm
{

/// Owner of a handle of the HDF5 library, which it closes.
class Hdf5Handle
{
public:
  /// @param id  handle, owned from now on
  /// @param close  function that closes it
  /// @param problem  message of the error
  /// @throws InputError  if the handle is invalid
  Hdf5Handle(hid_t id, herr_t (*close)(hid_t), const std::string& problem) : Id(id), Close(close)
  {
    if (id < 0)
    {
      throw InputError(problem);
    }
  }
  ~Hdf5Handle() { this->Close(this->Id); }
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  operator hid_t() const { return this->Id; }

private:
  hid_t Id;
  herr_t (*Close)(hid_t);
};

/// Prevents the library from printing errors during the lifetime of the object.
class Hdf5Silence
{
public:
  Hdf5Silence()
  {
    H5Eget_auto2(H5E_DEFAULT, &this->Print, &this->Data);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Hdf5Silence() { H5Eset_auto2(H5E_DEFAULT, this->Print, this->Data); }
  Hdf5Silence(const Hdf5Silence&) = delete;
  Hdf5Silence& operator=(const Hdf5Silence&) = delete;

private:
  H5E_auto2_t Print = nullptr;
  void* Data = nullptr;
};

} // namespace vfm
