#include "Images/ImageFile.h"

#include "FileSuffix.h"
#include "Ranks/Errors.h"

#include <functional>

namespace vfm
{
namespace
{

using Opener = std::function<ImageFile(const std::string&, const std::string&)>;

struct Format
{
  std::vector<std::string> Suffixes;
  Opener Open;
};

Opener Alone(ImageFile (*open)(const std::string&))
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

ImageFile OpenImageFile(const std::string& path, const std::string& array)
{
  for (const Format& format : Formats())
  {
    if (HasSuffix(path, format.Suffixes))
    {
      return format.Open(path, array);
    }
  }
  throw InputError("its suffix is not one of a supported image format.");
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

bool IsImageFile(const std::string& path)
{
  return HasSuffix(path, GetImageSuffixes());
}

} // namespace vfm
