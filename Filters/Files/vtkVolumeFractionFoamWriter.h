/**
 * @class   vtkVolumeFractionFoamWriter
 * @brief   writes a mesh as a case of OpenFOAM (.foam)
 *
 * The folder of the file is the case. Writes constant/polyMesh with patches, cell zones and face
 * zones, from several ranks as a decomposed case. See Meshes/OpenFoam/WriteFoam.h.
 */
#ifndef vtkVolumeFractionFoamWriter_h
#define vtkVolumeFractionFoamWriter_h

#include "vtkVolumeFractionMeshIOModule.h" // for export macro
#include "vtkVolumeFractionMeshWriter.h"

class VTKVOLUMEFRACTIONMESHIO_EXPORT vtkVolumeFractionFoamWriter :
  public vtkVolumeFractionMeshWriter
{
public:
  static vtkVolumeFractionFoamWriter* New();
  vtkTypeMacro(vtkVolumeFractionFoamWriter, vtkVolumeFractionMeshWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Write binary files instead of texts. Default: off.
   */
  vtkSetMacro(Binary, bool);
  vtkGetMacro(Binary, bool);
  vtkBooleanMacro(Binary, bool);
  ///@}

  ///@{
  /**
   * Write one mesh from several ranks, gathered on rank 0, instead of a decomposed case. Default:
   * off.
   */
  vtkSetMacro(SingleFile, bool);
  vtkGetMacro(SingleFile, bool);
  vtkBooleanMacro(SingleFile, bool);
  ///@}

protected:
  vtkVolumeFractionFoamWriter() = default;
  ~vtkVolumeFractionFoamWriter() override = default;

  void WriteMesh(const vfm::MeshData& mesh, const std::string& path, vfm::Ranks& ranks) override;

  bool Binary = false, SingleFile = false;

private:
  vtkVolumeFractionFoamWriter(const vtkVolumeFractionFoamWriter&) = delete;
  void operator=(const vtkVolumeFractionFoamWriter&) = delete;
};

#endif
