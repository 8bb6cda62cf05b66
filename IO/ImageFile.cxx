#include "ImageFile.h"

#include "Base/Errors.h"
#include "FileSuffix.h"

#include <functional>

namespace vfm
{
namespace
{

using Opener = std::function<std::unique_ptr<ImageFile>(const std::string&, const std::string&)>;

struct Format
{
  std::vector<std::string> Suffixes;
  Opener Open;
};

Opener Alone(std::unique_ptr<ImageFile> (*open)(const std::string&))
{
  return [open](const std::string& path, const std::string&) { return open(path); };
}

const std::vector<Format>& Formats()
{
  static const std::vector<Format> formats{
    { { ".nii", ".nii.gz" }, Alone(OpenNifti) },
    { { ".nrrd", ".nhdr" }, Alone(OpenNrrd) },
    { { ".mha", ".mhd" }, Alone(OpenMetaImage) },
    { { ".tif", ".tiff" }, Alone(OpenTiff) },
    { { ".dream3d" }, OpenDream3d },
  };
  return formats;
}

} // namespace

std::unique_ptr<ImageFile> OpenImageFile(const std::string& path, const std::string& array)
{
  for (const Format& format : Formats())
  {
    for (const std::string& suffix : format.Suffixes)
    {
      if (HasSuffix(path, suffix))
      {
        return format.Open(path, array);
      }
    }
  }
  throw InputError("its name ends in no suffix of an image that is read.");
}

const std::vector<std::string>& GetImageSuffixes()
{
  static const std::vector<std::string> suffixes = []
  {
    std::vector<std::string> list;
    for (const Format& format : Formats())
    {
      list.insert(list.end(), format.Suffixes.begin(), format.Suffixes.end());
    }
    return list;
  }();
  return suffixes;
}

} // namespace vfm
