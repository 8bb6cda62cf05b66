/**
 * @class   vtkVolumeFractionPartReader
 * @brief   base of readers of one image, of which each rank reads a part
 *
 * Any extent can be requested. All ranks of the Controller open the file and must update together.
 * Errors give one message with the name of the file, the same on all ranks, and empty outputs.
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
   * Path of the file.
   */
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}

  ///@{
  /**
   * Ranks that read the file together. Default: the global controller.
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
   * Returns the image in the file. Messages of InputError do not contain the path.
   */
  virtual vfm::ImageSource Open() = 0;

  std::string FileName;
  vtkMultiProcessController* Controller = nullptr;

private:
  vtkVolumeFractionPartReader(const vtkVolumeFractionPartReader&) = delete;
  void operator=(const vtkVolumeFractionPartReader&) = delete;

  void Read(const int extent[6], vfm::Ranks& ranks, vtkImageData* image);

  std::unique_ptr<vfm::ImageSource> Source;
  std::string Problem; // reason why there is no image; equal on all ranks
};

#endif
