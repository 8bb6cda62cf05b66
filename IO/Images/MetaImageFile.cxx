#include "Images/ImageFile.h"
#include "Images/VtkImageFile.h"
#include "OpenFile.h"
#include "Ranks/Errors.h"

#include "vtkMetaImageReader.h"
#include "vtkNew.h"

#include "vtkmetaio/metaImage.h"
#include <cstdlib>
#include <filesystem>
#include <string>

namespace vfm
{
namespace
{

/// Where the header ends: with the line that tells where the values are. Throws InputError on numbers of dimensions that the library
/// would believe.
double FindHeaderEnd(const std::string& path)
{
  std::ifstream stream = OpenFile(path);
  std::string line;
  while (std::getline(stream, line) && line.compare(0, 15, "ElementDataFile") != 0)
  {
    const std::size_t equals = line.find('=');
    const int dimensions = equals == std::string::npos ? 0 : std::atoi(line.c_str() + equals + 1);
    if (line.find("NDims") < equals && (dimensions < 1 || dimensions > 3))
    {
      throw InputError(
        "its image has " + std::to_string(dimensions) + " dimensions; wanted are three.");
    }
  }
  return stream ? static_cast<double>(stream.tellg()) : 0.0;
}

class MetaImageFile : public VtkImageFile
{
public:
  MetaImageFile(const std::string& path, double headerEnd, vtkMetaImageReader* reader) :
    VtkImageFile(path, reader)
  {
    vtkmetaio::MetaImage header; // VTK's reader leaves the directions out
    if (!header.Read(path.c_str(), false))
    {
      throw InputError("its header cannot be read.");
    }
    this->CheckValues(path, headerEnd, header);
    std::array<Vector3, 3> steps{ { { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } },
      { { 0.0, 0.0, 1.0 } } } };
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int c = 0; axis < header.NDims() && c < header.NDims(); ++c)
      {
        steps[axis][c] = header.TransformMatrix(axis, c);
      }
      for (double& step : steps[axis])
      {
        step *= this->Where.Spacing[axis];
      }
    }
    if (!AreAtRightAngles(steps))
    {
      throw InputError("its TransformMatrix is no rotation: the axes are not at right angles.");
    }
    SetSteps(steps, this->Where);
  }

private:
  /// Files that are cut, which the library reads all the same.
  void CheckValues(
    const std::string& path, double headerEnd, const vtkmetaio::MetaImage& header) const
  {
    const std::string name = header.ElementDataFileName();
    const bool isLocal = name == "LOCAL" || name == "Local" || name == "local";
    const std::filesystem::path file =
      isLocal ? std::filesystem::path(path) : std::filesystem::path(path).parent_path() / name;
    std::error_code none;
    if (!isLocal && !std::filesystem::is_regular_file(file, none))
    {
      return; // a list or a pattern of files
    }
    CheckLength(file, isLocal ? headerEnd : 0.0, this->CountBytes(), header.CompressedData());
  }
};

} // namespace

std::unique_ptr<ImageFile> OpenMetaImage(const std::string& path)
{
  const double headerEnd = FindHeaderEnd(path);
  vtkNew<vtkMetaImageReader> reader;
  return std::make_unique<MetaImageFile>(path, headerEnd, reader);
}

} // namespace vfm
