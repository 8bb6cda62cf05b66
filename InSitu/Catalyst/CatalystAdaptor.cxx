#include "CatalystAdaptor.h"

#include "CatalystRun.h"

namespace vfm
{

CatalystAdaptor::CatalystAdaptor(MPI_Comm communicator, const std::vector<std::string>& scripts) :
  Run(StartCatalyst(communicator, scripts)), Error(this->Run->LeftOut)
{
}

CatalystAdaptor::~CatalystAdaptor() = default;

bool CatalystAdaptor::Process(
  const HostGrid& grid, double time, int step, const std::vector<HostNumber>& numbers, bool last)
{
  this->Run->Failed.clear();
  const bool processed = this->Run->Process(grid, { time, step, last }, numbers);
  this->Error = this->Run->LeftOut;
  AddLine(this->Error, this->Run->Failed);
  return processed && this->Error.empty();
}

const std::string& CatalystAdaptor::GetError() const
{
  return this->Error;
}

int CatalystAdaptor::GetNumberOfStepsMade() const
{
  return this->Run->StepsMade;
}

} // namespace vfm
