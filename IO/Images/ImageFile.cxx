#include "Images/ImageFile.h"

#include "Base/ParseText.h"
#include "FileSuffix.h"
#include "Images/Pictures/PixelStack.h"
#include "Images/Pictures/SliceFiles.h"
#include "Images/Pictures/SliceGaps.h"
#include "Ranks/Errors.h"

#include <algorithm>
#include <filesystem>

namespace vfm
{
namespace
{

struct Format
{
  std::vector<std::string> Suffixes;
  ImageFile (*Open)(const std::string&, const ImageRequest&);
};

const std::vector<Format>& Formats()
{
  static const std::vector<Format> formats{
    { { ".nii", ".nii.gz" }, OpenNifti },
    { { ".mgz", ".mgh" }, OpenMgh },
    { { ".nrrd", ".nhdr" }, OpenNrrd },
    { { ".mha", ".mhd" }, OpenMetaImage },
    { { ".tif", ".tiff" }, OpenTiff },
    { { ".png" }, OpenPng },
    { { ".dream3d" }, OpenDream3d },
  };
  return formats;
}

ImageFile OpenBySuffix(const std::string& path, const ImageRequest& request)
{
  for (const Format& format : Formats())
  {
    if (HasSuffix(path, format.Suffixes))
    {
      return format.Open(path, request);
    }
  }
  throw InputError("its suffix is not that of an image format. Supported suffixes: " +
    JoinTexts(GetImageSuffixes()) + ".");
}

} // namespace

ImageFile OpenImageFile(const std::string& path, const ImageRequest& request)
{
  std::error_code error;
  std::vector<std::string> slices = request.Slices;
  SortNaturally(slices);
  if (slices.empty() && (AreSlices(path) || std::filesystem::is_directory(path, error)))
  {
    slices = ListSlices(path);
  }
  ImageFile file = slices.empty() ? OpenBySuffix(path, request) : MakeImage(OpenSlices(slices));
  file.Warning += WarnOfGaps(slices);
  SelectVolume(request, file.Volumes);
  return file;
}

Index SelectVolume(const ImageRequest& request, Index volumes, const std::string& kinds)
{
  const std::string found = "it holds " + std::to_string(volumes) +
    (volumes == 1 ? " image" : " images") + (kinds.empty() ? "" : " (" + kinds + ")");
  const std::string range = ", from 0 to " + std::to_string(volumes - 1) + ".";
  if (!request.Volume && !request.TakesFirst && volumes > 1)
  {
    throw InputError(found + ". Select one of them by its number, --volume or Volume" + range);
  }
  const Index volume = request.Volume.value_or(0);
  if (volume < 0 || volume >= volumes)
  {
    throw InputError(found + ", but image " + std::to_string(volume) +
      " is requested. Change --volume or Volume" + range);
  }
  return volume;
}

void AddLabelName(LabelNames& names, int label, const std::string& name)
{
  std::string text = name;
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c == '\x7f' || (c >= 0 && c < ' '); }, ' ');
  text = TrimText(text);
  const bool isUsed = std::any_of(names.begin(), names.end(),
    [&](const auto& other) { return other.first != label && other.second == text; });
  if (!text.empty())
  {
    names[label] = isUsed ? text + " (" + std::to_string(label) + ")" : text;
  }
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
  return HasSuffix(path, GetImageSuffixes()) || AreSlices(path);
}

} // namespace vfm
