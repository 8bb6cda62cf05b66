#include "Images/ImageFile.h"
#include "Images/NrrdHeader.h"
#include "Images/StoredValues.h"
#include "Ranks/Errors.h"

namespace vfm
{

ImageFile OpenNrrd(const std::string& path, const ImageRequest&)
{
  const NrrdHeader header = ReadNrrdHeader(path);
  ImageFile image;
  image.Place.Size = header.Size;
  if (!AreAtRightAngles(header.Steps))
  {
    throw InputError("its space directions are not at right angles.");
  }
  SetSteps(header.Steps, image.Place);
  image.Place.Origin = header.Origin;
  CheckPlace(image.Place);
  StoredValues stored;
  stored.Type = header.Type;
  stored.AreCompressed = !header.IsRaw;
  stored.AreSwapped = header.IsSwapped;
  SetFiles(path, header.Fields.Length, header.Files, stored);
  if (header.Skip < 0)
  {
    PlaceAtEnd(header.StoredSize(), stored);
  }
  else
  {
    stored.Skip = header.Skip;
  }
  CheckFiles(stored, header.StoredSize());
  image.ReadsParts = header.IsRaw;
  image.Read = [stored, size = header.Size](const IndexBox& box)
  { return ReadStored(stored, size, box); };
  return image;
}

} // namespace vfm
