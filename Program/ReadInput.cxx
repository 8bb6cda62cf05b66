#include "ReadInput.h"

#include "Base/ParseText.h"
#include "Base/Runtime.h"
#include "Blocks/BlockFile.h"
#include "BlocksInput.h"
#include "ExodusInput.h"
#include "FileSuffix.h"
#include "GridFiles/ParseOutline.h"
#include "GridFiles/VtkFileCheck.h"
#include "ImageInput.h"
#include "Images/ImageFile.h"
#include "Images/Pictures/SliceFiles.h"
#include "Ranks/WorkTogether.h"
#include "SurfaceInput.h"
#include "Surfaces/ReadSurface.h"
#include "VtkFiles/UnpackByVtk.h"
#include "VtkInput.h"
#include "VtkMessages.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkDataSetReader.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLMultiBlockDataReader.h"
#include "vtkXMLPImageDataReader.h"
#include "vtkXMLPRectilinearGridReader.h"
#include "vtkXMLPStructuredGridReader.h"
#include "vtkXMLPUnstructuredGridReader.h"
#include "vtkXMLRectilinearGridReader.h"
#include "vtkXMLStructuredGridReader.h"
#include "vtkXMLUniformGridAMRReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <functional>
#include <iostream>
#include <unistd.h>

namespace vfm
{
namespace
{

struct Format
{
  std::string Suffix;
  std::function<vtkSmartPointer<vtkAlgorithm>(const Arguments&)> MakeReader;
  bool IsLegacy = false; ///< rank 0 reads the whole file, which has no times
};

template <class Reader>
Format MakeFormat(const char* suffix)
{
  return { suffix,
    [](const Arguments& arguments)
    {
      auto reader = vtkSmartPointer<Reader>::New();
      reader->SetFileName(arguments.Input.c_str());
      return vtkSmartPointer<vtkAlgorithm>(reader);
    } };
}

vtkSmartPointer<vtkAlgorithm> MakeAmrReader(const Arguments& arguments)
{
  auto reader = vtkSmartPointer<vtkXMLUniformGridAMRReader>::New();
  reader->SetFileName(arguments.Input.c_str());
  reader->SetMaximumLevelsToReadByDefault(0); // 0: all levels
  return reader;
}

/// Makes the reader of files in the legacy format, with all their arrays.
vtkSmartPointer<vtkAlgorithm> MakeLegacyReader(const Arguments& arguments)
{
  auto reader = vtkSmartPointer<vtkDataSetReader>::New();
  reader->SetFileName(arguments.Input.c_str());
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllTensorsOn();
  reader->ReadAllColorScalarsOn();
  reader->ReadAllTCoordsOn();
  reader->ReadAllFieldsOn();
  return reader;
}

const std::vector<Format>& Formats()
{
  static const std::vector<Format> formats{
    MakeFormat<vtkXMLImageDataReader>(".vti"),
    MakeFormat<vtkXMLPImageDataReader>(".pvti"),
    MakeFormat<vtkXMLRectilinearGridReader>(".vtr"),
    MakeFormat<vtkXMLPRectilinearGridReader>(".pvtr"),
    MakeFormat<vtkXMLStructuredGridReader>(".vts"),
    MakeFormat<vtkXMLPStructuredGridReader>(".pvts"),
    MakeFormat<vtkXMLUnstructuredGridReader>(".vtu"),
    MakeFormat<vtkXMLPUnstructuredGridReader>(".pvtu"),
    { ".vtk", MakeLegacyReader, true },
    MakeFormat<vtkXMLMultiBlockDataReader>(".vtm"),
    { ".vthb", MakeAmrReader },
    { ".vth", MakeAmrReader },
  };
  return formats;
}

const Format* FindInputFormat(const std::string& path)
{
  const auto& formats = Formats();
  const auto found = std::find_if(formats.begin(), formats.end(),
    [&path](const Format& format) { return HasSuffix(path, format.Suffix); });
  return found == formats.end() ? nullptr : &*found;
}

/// Discards everything that is written to a standard stream during the lifetime of the object.
/// Libraries print lines for an error that the reader reports in one message.
class QuietStream
{
public:
  QuietStream(int descriptor, std::FILE* file) :
    Descriptor(descriptor), File(file), Kept(dup(descriptor))
  {
    this->Flush();
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, descriptor);
    close(nowhere);
  }
  ~QuietStream()
  {
    this->Flush();
    dup2(this->Kept, this->Descriptor);
    close(this->Kept);
  }
  QuietStream(const QuietStream&) = delete;
  QuietStream& operator=(const QuietStream&) = delete;

private:
  void Flush()
  {
    std::cout.flush();
    std::fflush(this->File);
  }

  int Descriptor;
  std::FILE* File;
  int Kept;
};

/// Reads the part of this rank by a reader of VTK.
/// @param[out] times  receives Time and Times
/// @return null on ranks other than 0 if the format is the legacy one
vtkSmartPointer<vtkDataObject> ReadPart(
  const Arguments& arguments, VtkMessages& messages, const Ranks& ranks, Input& times)
{
  const Format& format = *FindInputFormat(arguments.Input);
  if (format.IsLegacy && ranks.Rank() > 0)
  {
    return nullptr;
  }
  const auto reader = format.MakeReader(arguments);
  messages.Watch(reader);
  reader->UpdateInformation();
  CheckReaderErrors(messages, arguments.Input);
  times.Times = format.IsLegacy ? std::vector<double>() : GetTimes(reader);
  times.Time = ChooseTime(arguments, times.Times);
  UpdatePiece(
    reader, times.Time, format.IsLegacy ? 0 : ranks.Rank(), format.IsLegacy ? 1 : ranks.Count());
  CheckReaderErrors(messages, arguments.Input);
  return reader->GetOutputDataObject(0);
}

Input ReadByVtk(const Arguments& arguments, VtkMessages& messages, Ranks& ranks)
{
  Input input;
  WorkInStage(ranks, ErrorCode::UnreadableInput,
    [&]
    {
      CheckInputFile(arguments.Input);
      CheckInput(arguments.Input,
        [&]
        {
          CheckVtkFile(
            arguments.Input, { ParseVtkOutline, UnpackByVtk() }, { ranks.Rank(), ranks.Count() });
        });
      ranks.Any(false); // no rank reads before all have checked their share
      Input times;
      const auto data = ReadPart(arguments, messages, ranks, times);
      input = MakeInput(data, ranks);
      input.Time = times.Time;
      input.Times = times.Times;
    });
  return input;
}

} // namespace

std::vector<std::string> GetInputSuffixes()
{
  std::vector<std::string> suffixes;
  for (const Format& format : Formats())
  {
    suffixes.push_back(format.Suffix);
  }
  for (const std::vector<std::string>& more : { GetVoxelSuffixes(), GetImageSuffixes(),
         { SpyPlotSuffix }, GetExodusSuffixes(), GetSurfaceSuffixes() })
  {
    suffixes.insert(suffixes.end(), more.begin(), more.end());
  }
  return suffixes;
}

void CheckInputSuffix(const std::string& path)
{
  if (!FindInputFormat(path) && !IsVoxelFile(path) && !IsImageFile(path) && !IsBlockFile(path))
  {
    std::error_code error;
    if (IsPattern(path) || std::filesystem::is_directory(path, error))
    {
      ClassifyErrors(ErrorCode::UnreadableInput,
        [&path] { PrefixErrors("Cannot read " + path + ": ", [&path] { ListSlices(path); }); });
    }
    const bool isPicture = HasSuffix(path, { ".jpg", ".jpeg", ".bmp", ".gif", ".webp" });
    throw InputError(ErrorCode::WrongArguments,
      "The input " + path + " is of an unknown format. " +
        (isPicture ? "Save the picture as .png or .tif, from the original image, because .jpg "
                     "changes values. "
                   : "") +
        "Supported formats: " + JoinTexts(GetInputSuffixes()) +
        ", folders of AMReX plotfiles, and folders or patterns of slices (" +
        JoinTexts(GetSliceSuffixes()) + ").");
  }
}

Input ReadInput(const Arguments& arguments, Ranks& ranks)
{
  if (!arguments.SurfaceFiles.empty())
  {
    return ReadSurfaces(arguments, ranks);
  }
  if (IsExodusFile(arguments.Input))
  {
    return ReadExodus(arguments, ranks);
  }
  if (IsBlockFile(arguments.Input))
  {
    return ReadBlocks(arguments, ranks);
  }
  if (IsVoxelFile(arguments.Input) || IsImageFile(arguments.Input))
  {
    return ReadImage(arguments, ranks);
  }
  VtkMessages messages;
  const VtkSilence silence(messages);
  const QuietStream errors(STDERR_FILENO, stderr), output(STDOUT_FILENO, stdout);
  return ReadByVtk(arguments, messages, ranks);
}

} // namespace vfm
