/**
 * @class   vtkVolumeFractionAbaqusWriter
 * @brief   writes a mesh as an input file of Abaqus and CalculiX (.inp)
 *
 * Writes one file, also from several ranks:
 * - nodes; elements C3D8, C3D20, C3D20R, C3D4 or C3D10 with one element set per material, and EALL
 * for all;
 * - node sets of the sides of the domain, X_MIN to Z_MAX, and NALL for all nodes;
 * - surfaces of these sides, and of each pair of adjacent materials (BALL_TO_PLATE, BALL_TO_VOID).
 *
 * The file contains only the mesh. Sections, materials and steps belong in a file that includes it.
 */
#ifndef vtkVolumeFractionAbaqusWriter_h
#define vtkVolumeFractionAbaqusWriter_h

#include "vtkVolumeFractionMeshIOModule.h" // for export macro
#include "vtkVolumeFractionMeshWriter.h"

class VTKVOLUMEFRACTIONMESHIO_EXPORT vtkVolumeFractionAbaqusWriter :
  public vtkVolumeFractionMeshWriter
{
public:
  static vtkVolumeFractionAbaqusWriter* New();
  vtkTypeMacro(vtkVolumeFractionAbaqusWriter, vtkVolumeFractionMeshWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Write C3D20R, of reduced integration, instead of C3D20. Default: off.
   */
  vtkSetMacro(ReducedIntegration, bool);
  vtkGetMacro(ReducedIntegration, bool);
  vtkBooleanMacro(ReducedIntegration, bool);
  ///@}

protected:
  vtkVolumeFractionAbaqusWriter() = default;
  ~vtkVolumeFractionAbaqusWriter() override = default;

  void WriteMesh(const vfm::MeshData& mesh, const std::string& path, vfm::Ranks& ranks) override;

  bool ReducedIntegration = false;

private:
  vtkVolumeFractionAbaqusWriter(const vtkVolumeFractionAbaqusWriter&) = delete;
  void operator=(const vtkVolumeFractionAbaqusWriter&) = delete;
};

#endif
