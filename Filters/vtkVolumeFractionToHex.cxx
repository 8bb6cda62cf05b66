#include "vtkVolumeFractionToHex.h"

#include "Agreement.h"
#include "FilterRuntime.h"
#include "HexMeshOutput.h"
#include "HexPipeline.h"
#include "InputFields.h"

#include "vtkLogger.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkVolumeFractionToHex);

void vtkVolumeFractionToHex::MakeMesh(const vfm::CartesianGrid& grid, const vfm::InputField& field,
  const vfm::HexMeshOptions& options, vfm::FilterRuntime& runtime, vtkUnstructuredGrid* mesh,
  vtkPolyData* surfaces)
{
  vfm::HexMeshReport report;
  vfm::HexMesh hexes = vfm::MakeHexMesh(grid, field.Fractions, options, runtime, report);
  for (const vfm::HexMeshReport::Stage& stage : report.Stages)
  {
    vtkLogF(TRACE, "%s: %.3f s", stage.Name, stage.Seconds);
  }
  runtime.Progress(0.98, "Filling output");
  vfm::WorkTogether(runtime.Group(),
    [&]
    {
      vfm::SetHexMeshOutput(hexes, field.Table, mesh, surfaces);
      vfm::SetReportOutput(report, field.Table, options, field.NormalisedCells, mesh);
    });
}
