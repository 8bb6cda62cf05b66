/// Meshes known shapes by the VTK filters and writes them as Exodus;
/// prints the number of hexahedra.
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVolumeFractionExodusWriter.h>
#include <vtkVolumeFractionShapes.h>
#include <vtkVolumeFractionToHex.h>

#include <cstdio>

int main(int, char** argv)
{
  vtkNew<vtkVolumeFractionShapes> shapes;
  shapes->SetDimensions(16, 16, 16);
  shapes->SetShapes("sphere material=1 center=0,0,0 radius=0.3");
  shapes->SetBounds(-0.5, 0.5, -0.5, 0.5, -0.5, 0.5);
  vtkNew<vtkVolumeFractionToHex> hexes;
  hexes->SetInputConnection(shapes->GetOutputPort());
  hexes->AddVolumeFractionArray("Material1");
  vtkNew<vtkVolumeFractionExodusWriter> writer;
  writer->SetInputConnection(hexes->GetOutputPort());
  writer->SetFileName(argv[1]);
  writer->Write();
  std::printf("%lld hexes\n", static_cast<long long>(hexes->GetOutput()->GetNumberOfCells()));
  return 0;
}
