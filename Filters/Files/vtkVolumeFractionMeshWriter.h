/**
 * @class   vtkVolumeFractionMeshWriter
 * @brief   base of the writers of meshes for finite-element codes
 *
 * Input: a mesh of vtkVolumeFractionToHex or vtkVolumeFractionToTet, also from a file. Each rank of
 * the Controller has a piece of the mesh, and all ranks must write together. If the mesh or the
 * file cannot be written, all ranks give the same error message, and Write returns 0.
 */
#ifndef vtkVolumeFractionMeshWriter_h
#define vtkVolumeFractionMeshWriter_h

#include "vtkVolumeFractionMeshIOModule.h" // for export macro
#include "vtkWriter.h"

#include <string> // for member

class vtkMultiProcessController;

namespace vfm
{
class Ranks;
struct MeshData;
} // namespace vfm

class VTKVOLUMEFRACTIONMESHIO_EXPORT vtkVolumeFractionMeshWriter : public vtkWriter
{
public:
  vtkTypeMacro(vtkVolumeFractionMeshWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Path of the file.
   */
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}

  /**
   * Writes the file. Returns 0 if it failed, also if the mesh could not be made.
   */
  int Write() override;

  ///@{
  /**
   * Ranks that have pieces of the mesh. Default: the global controller.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

protected:
  vtkVolumeFractionMeshWriter();
  ~vtkVolumeFractionMeshWriter() override;

  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  vtkExecutive* CreateDefaultExecutive() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

  /**
   * Writes a mesh. Collective. Throws vfm::InputError on all ranks.
   */
  virtual void WriteMesh(const vfm::MeshData& mesh, const std::string& path, vfm::Ranks& ranks) = 0;

  vtkMultiProcessController* Controller = nullptr;
  std::string FileName;

private:
  vtkVolumeFractionMeshWriter(const vtkVolumeFractionMeshWriter&) = delete;
  void operator=(const vtkVolumeFractionMeshWriter&) = delete;
};

#endif
