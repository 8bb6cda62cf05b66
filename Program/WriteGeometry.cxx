#include "WriteGeometry.h"

#include "ControllerRanks.h"
#include "FileSuffix.h"
#include "GatherGeometry.h"
#include "Ranks/WorkTogether.h"
#include "VtkMessages.h"

#include "vtkCompositeDataSet.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkVolumeFractionMeshAlgorithm.h"
#include "vtkXMLMultiBlockDataWriter.h"

namespace vfm
{
namespace
{

/// Collective: the blocks that have cells, on rank 0.
vtkSmartPointer<vtkMultiBlockDataSet> CollectBlocks(
  vtkVolumeFractionMeshAlgorithm& mesher, const double* time, Ranks& ranks)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  const char* const kinds[][2] = { { "Surfaces", "SurfaceId" }, { "Curves", "CurveId" },
    { "Vertices", "VertexId" } };
  for (int port = 1; port <= 3; ++port)
  {
    const auto& [name, numbers] = kinds[port - 1];
    const vtkSmartPointer<vtkPolyData> whole =
      GatherGeometry(vtkPolyData::SafeDownCast(mesher.GetOutputDataObject(port)), numbers, ranks);
    if (!whole)
    {
      continue;
    }
    if (time)
    {
      whole->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), *time);
    }
    const unsigned int block = blocks->GetNumberOfBlocks();
    blocks->SetBlock(block, whole);
    blocks->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), name);
  }
  return blocks;
}

/// The writer's own messages are less plain than its codes.
void WriteBlocks(vtkMultiBlockDataSet* blocks, const std::string& path, VtkMessages& messages)
{
  vtkNew<vtkXMLMultiBlockDataWriter> writer;
  writer->SetInputData(blocks);
  messages.Watch(writer);
  writer->SetFileName(path.c_str());
  writer->SetDataModeToBinary(); // inline: with Debian's newer expat VTK 9.2 reads no appended data
  const bool isGood = writer->Write();
  if (writer->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw InputError(vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode()));
  }
  if (!isGood || messages.HasErrors())
  {
    throw InputError(messages.GetErrorText());
  }
}

} // namespace

void CheckGeometrySuffix(const std::string& path)
{
  if (!HasSuffix(path, ".vtm"))
  {
    throw InputError(ErrorCode::WrongArguments,
      "The geometry " + path + " is of an unknown kind. Written is .vtm.");
  }
}

void WriteGeometry(vtkVolumeFractionMeshAlgorithm& mesher, const double* time,
  const std::string& path, vtkMultiProcessController* controller)
{
  ControllerRanks ranks(controller);
  VtkMessages messages;
  const VtkSilence silence(messages);
  const auto write = [&]
  {
    const auto blocks = CollectBlocks(mesher, time, ranks);
    if (ranks.Rank() == 0)
    {
      WriteBlocks(blocks, path, messages);
    }
  };
  PrefixErrors("Cannot write the geometry " + path + ": ",
    [&] { WorkInStage(ranks, ErrorCode::UnwritableOutput, write); });
}

} // namespace vfm
