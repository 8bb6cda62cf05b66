/**
 * @class   vtkVolumeFractionGmshWriter
 * @brief   writes a mesh in the format of Gmsh (.msh)
 *
 * Writes one file, also from several ranks: elements in physical groups of the materials, faces in
 * physical groups of the sides of the domain and of the interfaces, with the global ids of the
 * mesh. See Meshes/Gmsh/WriteGmsh.h.
 */
#ifndef vtkVolumeFractionGmshWriter_h
#define vtkVolumeFractionGmshWriter_h

#include "vtkVolumeFractionMeshIOModule.h" // for export macro
#include "vtkVolumeFractionMeshWriter.h"

class VTKVOLUMEFRACTIONMESHIO_EXPORT vtkVolumeFractionGmshWriter :
  public vtkVolumeFractionMeshWriter
{
public:
  static vtkVolumeFractionGmshWriter* New();
  vtkTypeMacro(vtkVolumeFractionGmshWriter, vtkVolumeFractionMeshWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Versions of the format, as vfm::GmshVersion.
  enum
  {
    AUTOMATIC,
    VERSION_2_2,
    VERSION_4_1
  };

  ///@{
  /**
   * Version of the format. AUTOMATIC (default): 2.2, or 4.1 if an id exceeds 2^31 - 1.
   */
  vtkSetClampMacro(Version, int, AUTOMATIC, VERSION_4_1);
  vtkGetMacro(Version, int);
  ///@}

  ///@{
  /**
   * Write a binary file instead of a text. Default: off.
   */
  vtkSetMacro(Binary, bool);
  vtkGetMacro(Binary, bool);
  vtkBooleanMacro(Binary, bool);
  ///@}

  ///@{
  /**
   * Write the faces between elements of different materials. Default: on. deal.II refuses files
   * with them.
   */
  vtkSetMacro(Interfaces, bool);
  vtkGetMacro(Interfaces, bool);
  vtkBooleanMacro(Interfaces, bool);
  ///@}

protected:
  vtkVolumeFractionGmshWriter() = default;
  ~vtkVolumeFractionGmshWriter() override = default;

  void WriteMesh(const vfm::MeshData& mesh, const std::string& path, vfm::Ranks& ranks) override;

  int Version = AUTOMATIC;
  bool Binary = false;
  bool Interfaces = true;

private:
  vtkVolumeFractionGmshWriter(const vtkVolumeFractionGmshWriter&) = delete;
  void operator=(const vtkVolumeFractionGmshWriter&) = delete;
};

#endif
