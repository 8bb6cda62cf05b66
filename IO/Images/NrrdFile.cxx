#include "Images/ImageFile.h"
#include "Images/NrrdHeader.h"
#include "Images/VtkImageFile.h"
#include "Ranks/Errors.h"

#include "vtkNew.h"
#include "vtkNrrdReader.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"

#include <filesystem>
#include <limits>

namespace vfm
{
namespace
{

/// VTK's reader, but that takes a first axis of up to 9 values for components, in a left-handed space turns the rows of raw values,
/// and looks for compressed values of another file in the wrong place.
class NrrdValues : public vtkNrrdReader
{
public:
  static NrrdValues* New();
  vtkTypeMacro(NrrdValues, vtkNrrdReader);

  NrrdHeader Header;

protected:
  using vtkNrrdReader::ReadHeader;
  int ReadHeader(vtkCharArray* text) override
  {
    const int result = this->vtkNrrdReader::ReadHeader(text);
    this->FileLowerLeft = 1;
    if (!this->Header.Values.empty())
    {
      this->HeaderSize = 0;
      this->ManualHeaderSize = 1; // or VTK takes what it counts too much for a header
    }
    this->NumberOfScalarComponents = 1;
    this->FileDimensionality = this->DataFiles->GetNumberOfValues() > 1 ? 2 : 3;
    for (int a = 0; a < 3; ++a)
    {
      this->DataExtent[2 * a] = 0;
      this->DataExtent[2 * a + 1] = static_cast<int>(this->Header.Size[a]) - 1;
    }
    return result;
  }
};
vtkStandardNewMacro(NrrdValues);

class NrrdFile : public VtkImageFile
{
public:
  NrrdFile(const std::string& path, NrrdValues* reader) : VtkImageFile(path, reader)
  {
    const NrrdHeader& header = reader->Header;
    if (!AreAtRightAngles(header.Steps))
    {
      throw InputError("its space directions are not at right angles.");
    }
    SetSteps(header.Steps, this->Where);
    this->Where.Origin = header.Origin;
    this->Parts = header.IsRaw;
    if (!header.IsRaw && this->CountBytes() > std::numeric_limits<int>::max())
    {
      throw InputError("its values are compressed (gzip) and more than 2 GB, which VTK's reader "
                       "does not read. Save them raw.");
    }
    const std::filesystem::path values = header.Values.empty()
      ? std::filesystem::path(path)
      : std::filesystem::path(path).parent_path() / header.Values;
    const Index offset = header.Values.empty() ? header.Length : 0;
    CheckLength(values, static_cast<double>(offset), this->CountBytes(), !header.IsRaw);
  }
};

} // namespace

std::unique_ptr<ImageFile> OpenNrrd(const std::string& path)
{
  vtkNew<NrrdValues> reader;
  reader->Header = ReadNrrdHeader(path);
  return std::make_unique<NrrdFile>(path, reader);
}

} // namespace vfm
