#include "WriteGeometry.h"

#include "ControllerRanks.h"
#include "FileSuffix.h"
#include "GatherGeometry.h"
#include "OutputStage.h"
#include "Stage.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkVolumeFractionMeshAlgorithm.h"
#include "vtkXMLMultiBlockDataWriter.h"

namespace vfm
{

void CheckGeometrySuffix(const std::string& path)
{
  if (!HasSuffix(path, ".vtm"))
  {
    throw ProgramError(ExitCode::WrongArguments,
      "The geometry " + path + " is of an unknown kind. Written is .vtm.");
  }
}

void WriteGeometry(vtkVolumeFractionMeshAlgorithm& mesher, const double* time,
  const std::string& path, vtkMultiProcessController* controller)
{
  ControllerRanks ranks(controller);
  const auto write = [&](VtkMessages& messages)
  {
    vtkNew<vtkMultiBlockDataSet> blocks; // of what there is alone
    const char* const names[] = { "Surfaces", "Curves", "Vertices" };
    for (int port = 1; port <= 3; ++port)
    {
      const vtkSmartPointer<vtkPolyData> whole =
        GatherGeometry(vtkPolyData::SafeDownCast(mesher.GetOutputDataObject(port)), ranks);
      if (!whole || whole->GetNumberOfCells() == 0)
      {
        continue;
      }
      if (time)
      {
        whole->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), *time);
      }
      const unsigned int block = blocks->GetNumberOfBlocks();
      blocks->SetBlock(block, whole);
      blocks->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), names[port - 1]);
    }
    if (ranks.Rank() > 0)
    {
      return true;
    }
    vtkNew<vtkXMLMultiBlockDataWriter> writer;
    writer->SetInputData(blocks);
    return RunWriter(writer, path.c_str(), messages);
  };
  WriteInStage("geometry", path, controller, write);
}

} // namespace vfm
