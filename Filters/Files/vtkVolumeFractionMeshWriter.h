/**
 * @class   vtkVolumeFractionMeshWriter
 * @brief   base of the writers of meshes for finite-element codes
 *
 * Input: a mesh of vtkVolumeFractionToHex or vtkVolumeFractionToTet, also one read from a file. Under MPI every process of
 * the Controller has its piece and all must write together. A mesh that cannot be written, or a file, gives one
 * error message and Write returns 0, on all processes alike.
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
   * The file to write.
   */
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}

  /**
   * 0 when it failed, also where the mesh could not be made.
   */
  int Write() override;

  ///@{
  /**
   * The processes that have pieces of the mesh. Default: the global controller.
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
   * Collective. Throws vfm::InputError on all ranks.
   */
  virtual void WriteMesh(const vfm::MeshData& mesh, const std::string& path, vfm::Ranks& ranks) = 0;

  vtkMultiProcessController* Controller = nullptr;
  std::string FileName;

private:
  vtkVolumeFractionMeshWriter(const vtkVolumeFractionMeshWriter&) = delete;
  void operator=(const vtkVolumeFractionMeshWriter&) = delete;
};

#endif
