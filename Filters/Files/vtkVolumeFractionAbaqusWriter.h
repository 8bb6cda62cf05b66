/**
 * @class   vtkVolumeFractionAbaqusWriter
 * @brief   writes a mesh as an input file of Abaqus and CalculiX (.inp)
 *
 * One file, also from several processes: nodes, elements C3D8 or C3D4 with an element set a material (all: EALL), node sets
 * of the sides of the domain (X_MIN to Z_MAX, all nodes: NALL), surfaces of these sides and of each material against each other
 * and the void (BALL_TO_PLATE, BALL_TO_VOID). The mesh alone: sections, materials and steps are the user's, in a file that
 * includes this one.
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

protected:
  vtkVolumeFractionAbaqusWriter() = default;
  ~vtkVolumeFractionAbaqusWriter() override = default;

  void WriteMesh(const vfm::MeshData& mesh, const std::string& path, vfm::Ranks& ranks) override;

private:
  vtkVolumeFractionAbaqusWriter(const vtkVolumeFractionAbaqusWriter&) = delete;
  void operator=(const vtkVolumeFractionAbaqusWriter&) = delete;
};

#endif
