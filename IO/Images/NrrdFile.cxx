#include "Images/ImageFile.h"
#include "Images/NrrdHeader.h"
#include "Images/NrrdSegments.h"
#include "Images/StoredValues.h"
#include "Ranks/Errors.h"

#include <optional>

namespace vfm
{
namespace
{

ImagePlace FindPlace(const NrrdHeader& header)
{
  ImagePlace place;
  place.Size = header.Size;
  if (!AreAtRightAngles(header.Steps))
  {
    throw InputError("its space directions are not at right angles.");
  }
  SetSteps(header.Steps, place);
  place.Origin = header.Origin;
  CheckPlace(place);
  return place;
}

StoredValues FindValues(const std::string& path, const NrrdHeader& header)
{
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
  return stored;
}

/// Returns the names of the labels of the image, and of all labels of a layer if one is selected.
LabelNames NameSegments(const std::vector<NrrdSegment>& segments, std::optional<int> layer)
{
  LabelNames names;
  for (const NrrdSegment& segment : segments)
  {
    if (!layer || segment.Layer == *layer)
    {
      AddLabelName(names, layer ? static_cast<int>(segment.Value) : segment.Label, segment.Name);
    }
  }
  return names;
}

/// Reads a box of all images, which are stored one after the other. The values of a point follow
/// one another in the result.
TypedValues ReadAll(const StoredValues& stored, const NrrdHeader& header, IndexBox box)
{
  TypedValues all = MakeValues("", stored.Type, header.Layers * box.NumberOfCells());
  for (Index layer = 0; layer < header.Layers; ++layer)
  {
    PutLayer(ReadStored(stored, header.StoredSize(), box), header.Layers, layer, all);
    box.Lower[2] += header.Size[2];
    box.Upper[2] += header.Size[2];
  }
  return all;
}

/// Reads a box of one image, or of the merged layers if there are segments and no selected image.
TypedValues ReadImage(const StoredValues& stored, const NrrdHeader& header,
  const std::vector<NrrdSegment>& segments, std::optional<int> volume, IndexBox box)
{
  const bool areMerged = header.Layers > 1 && !volume;
  if (areMerged && !header.HasLayersFirst)
  {
    return MergeLayers(ReadAll(stored, header, box), header.Layers, segments);
  }
  if (!header.HasLayersFirst)
  {
    box.Lower[2] += volume.value_or(0) * header.Size[2];
    box.Upper[2] += volume.value_or(0) * header.Size[2];
  }
  else
  {
    box.Lower[0] *= header.Layers;
    box.Upper[0] *= header.Layers;
  }
  TypedValues values = ReadStored(stored, header.StoredSize(), box);
  if (header.Layers == 1 || !header.HasLayersFirst)
  {
    return values;
  }
  return areMerged ? MergeLayers(values, header.Layers, segments)
                   : TakeLayer(values, header.Layers, *volume);
}

} // namespace

ImageFile OpenNrrd(const std::string& path, const ImageRequest& request)
{
  const NrrdHeader header = ReadNrrdHeader(path);
  const std::vector<NrrdSegment> segments = ListSegments(header.Fields);
  const bool areMerged = !segments.empty() && !request.Volume;
  ImageFile image;
  image.Place = FindPlace(header);
  image.Volumes = areMerged ? 1 : header.Layers;
  const std::optional<int> volume = areMerged || header.Layers == 1
    ? std::nullopt
    : std::optional<int>(static_cast<int>(SelectVolume(request, image.Volumes, "layers")));
  image.Names = NameSegments(segments, volume);
  const StoredValues stored = FindValues(path, header);
  image.ReadsParts = header.IsRaw;
  image.Read = [stored, header, segments, volume](const IndexBox& box)
  { return ReadImage(stored, header, segments, volume, box); };
  return image;
}

} // namespace vfm
