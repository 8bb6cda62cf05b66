/**
 * @class vtkVolumeFractionExodusWriter
 * @brief writes a mesh as Exodus with element blocks, side sets and node sets
 *
 * The file contains:
 * - one element block per material with its name and id; a meshed void gets the next id after the
 *   largest;
 * - side sets between adjacent materials and on free surfaces ("ball_to_plate", "ball_to_Void"),
 *   and side sets and node sets on the sides of the domain ("x_min" to "z_max"); see
 *   Summary/MeshSets.h;
 * - global ids as element and node maps;
 * - cell and point arrays as variables.
 *
 * On several ranks, each rank writes a file FileName.N.RANK with the communication maps of Nemesis,
 * or all ranks write a single file (SingleFile).
 */
#ifndef vtkVolumeFractionExodusWriter_h
#define vtkVolumeFractionExodusWriter_h

#include "vtkVolumeFractionMeshIOModule.h" // for export macro
#include "vtkVolumeFractionMeshWriter.h"

class VTKVOLUMEFRACTIONMESHIO_EXPORT vtkVolumeFractionExodusWriter :
  public vtkVolumeFractionMeshWriter
{
public:
  static vtkVolumeFractionExodusWriter* New();
  vtkTypeMacro(vtkVolumeFractionExodusWriter, vtkVolumeFractionMeshWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Write one file from several ranks; rank 0 needs memory for the whole mesh. Default: off.
   */
  vtkSetMacro(SingleFile, bool);
  vtkGetMacro(SingleFile, bool);
  vtkBooleanMacro(SingleFile, bool);
  ///@}

protected:
  vtkVolumeFractionExodusWriter() = default;
  ~vtkVolumeFractionExodusWriter() override = default;

  void WriteMesh(const vfm::MeshData& mesh, const std::string& path, vfm::Ranks& ranks) override;

  bool SingleFile = false;

private:
  vtkVolumeFractionExodusWriter(const vtkVolumeFractionExodusWriter&) = delete;
  void operator=(const vtkVolumeFractionExodusWriter&) = delete;
};

#endif
