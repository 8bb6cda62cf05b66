/**
 * Hdf5: handles of the HDF5 library that close themselves.
 */
#pragma once

#include "Ranks/Errors.h"

#include <hdf5.h>
#include <string>

namespace vfm
{

class Hdf5Handle
{
public:
  /// problem: is thrown when the handle is none.
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

/// While this lives the library prints no errors.
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
