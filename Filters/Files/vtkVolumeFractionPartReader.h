/**
 * @class   vtkVolumeFractionPartReader
 * @brief   base of readers of one image, of which every process reads a part
 *
 * Any extent can be asked for. Under MPI every process of the Controller opens the file and all must update together. Errors are one
 * message on all processes alike, with the name of the file; the output is empty.
 */
#ifndef vtkVolumeFractionPartReader_h
#define vtkVolumeFractionPartReader_h

#include "vtkImageAlgorithm.h"
#include "vtkVolumeFractionMeshIOModule.h" // for export macro

#include <memory> // for member
#include <string> // for member

class vtkMultiProcessController;

namespace vfm
{
struct ImageSource;
class Ranks;
} // namespace vfm

class VTKVOLUMEFRACTIONMESHIO_EXPORT vtkVolumeFractionPartReader : public vtkImageAlgorithm
{
public:
  vtkTypeMacro(vtkVolumeFractionPartReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read.
   */
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}

  ///@{
  /**
   * The processes that read the file together. Default: the global controller.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

protected:
  vtkVolumeFractionPartReader();
  ~vtkVolumeFractionPartReader() override;

  int RequestInformation(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* output) override;

  /**
   * Returns the image in the file. Throws InputError without the path.
   */
  virtual vfm::ImageSource Open() = 0;

  std::string FileName;
  vtkMultiProcessController* Controller = nullptr;

private:
  vtkVolumeFractionPartReader(const vtkVolumeFractionPartReader&) = delete;
  void operator=(const vtkVolumeFractionPartReader&) = delete;

  void Read(const int extent[6], vfm::Ranks& ranks, vtkImageData* image);

  std::unique_ptr<vfm::ImageSource> Source;
  std::string Problem; // why there is no image; the same on all processes
};

#endif
