/**
 * @class vtkVolumeFractionExodusWriter
 * @brief writes a mesh as Exodus with element blocks, side sets and node sets
 *
 * One element block a material, named after it, its id the material's (the void, when it is meshed, gets the id after the
 * greatest); side sets where materials touch each other and the void, "ball_to_plate", "ball_to_Void", and on the sides of the domain,
 * "x_min" to "z_max"; node sets of these sides; global ids as element and node maps; cell and point arrays as variables. Under MPI
 * each process writes a file FileName.N.RANK with the communication maps of Nemesis, or all one, see SingleFile.
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
   * One file of the whole mesh from several processes; the first needs memory for it. Default: off.
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
