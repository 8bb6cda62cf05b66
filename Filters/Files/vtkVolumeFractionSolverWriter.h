/**
 * @class   vtkVolumeFractionSolverWriter
 * @brief   writes a mesh as an input file of a solver, in the format of the suffix
 *
 * Writes any format of Meshes/FormatTable.h, without its options. Materials and loads belong in
 * other files.
 */
#ifndef vtkVolumeFractionSolverWriter_h
#define vtkVolumeFractionSolverWriter_h

#include "vtkVolumeFractionMeshIOModule.h" // for export macro
#include "vtkVolumeFractionMeshWriter.h"

class VTKVOLUMEFRACTIONMESHIO_EXPORT vtkVolumeFractionSolverWriter :
  public vtkVolumeFractionMeshWriter
{
public:
  static vtkVolumeFractionSolverWriter* New();
  vtkTypeMacro(vtkVolumeFractionSolverWriter, vtkVolumeFractionMeshWriter);

protected:
  vtkVolumeFractionSolverWriter() = default;
  ~vtkVolumeFractionSolverWriter() override = default;

  void WriteMesh(const vfm::MeshData& mesh, const std::string& path, vfm::Ranks& ranks) override;

private:
  vtkVolumeFractionSolverWriter(const vtkVolumeFractionSolverWriter&) = delete;
  void operator=(const vtkVolumeFractionSolverWriter&) = delete;
};

#endif
