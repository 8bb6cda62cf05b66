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
    vtkNew<vtkMultiBlockDataSet> blocks;
    const char* const names[] = { "Surfaces", "Curves", "Vertices" };
    for (unsigned int block = 0; block < 3; ++block)
    {
      auto* port = vtkPolyData::SafeDownCast(mesher.GetOutputDataObject(block + 1));
      const vtkSmartPointer<vtkPolyData> whole = GatherGeometry(port, ranks);
      if (whole && time)
      {
        whole->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), *time);
      }
      blocks->SetBlock(block, whole);
      blocks->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), names[block]);
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
