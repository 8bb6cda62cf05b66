#include "Images/ImageFile.h"
#include "Images/NrrdHeader.h"
#include "Images/StoredValues.h"
#include "Ranks/Errors.h"

#include <filesystem>

namespace vfm
{

ImageFile OpenNrrd(const std::string& path, const ImageRequest&)
{
  const NrrdHeader header = ReadNrrdHeader(path);
  StoredValues stored;
  stored.Type = header.Type;
  stored.AreCompressed = !header.IsRaw;
  stored.AreSwapped = header.IsSwapped;
  stored.Skip = header.Skip;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  for (const std::string& file : header.Files)
  {
    stored.Files.push_back((folder / file).string());
  }
  if (stored.Files.empty())
  {
    stored.Files = { path };
    stored.Begin = header.Length;
  }
  ImageFile image;
  image.Place.Size = header.Size;
  if (!AreAtRightAngles(header.Steps))
  {
    throw InputError("its space directions are not at right angles.");
  }
  SetSteps(header.Steps, image.Place);
  image.Place.Origin = header.Origin;
  CheckPlace(image.Place);
  CheckFiles(stored, header.Size);
  image.ReadsParts = header.IsRaw;
  image.Read = [stored, size = header.Size](const IndexBox& box)
  { return ReadStored(stored, size, box); };
  return image;
}

} // namespace vfm
