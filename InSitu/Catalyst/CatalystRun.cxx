#include "CatalystRun.h"

#include <fstream>

namespace vfm
{
namespace
{

MPI_Comm Duplicate(MPI_Comm communicator)
{
  MPI_Comm duplicate = MPI_COMM_NULL;
  MPI_Comm_dup(communicator, &duplicate);
  return duplicate;
}

} // namespace

bool CatalystRun::HasStarted = false;

CatalystRun::CatalystRun(MPI_Comm communicator) :
  Communicator(Duplicate(communicator)), Group(this->Communicator)
{
}

CatalystRun::~CatalystRun()
{
  MPI_Comm_free(&this->Communicator);
}

void AddLine(std::string& text, const std::string& line)
{
  text += (text.empty() || line.empty() ? "" : "\n") + line;
}

bool CatalystRun::CanRead(const std::string& script)
{
  const auto read = [&script]
  {
    if (!std::ifstream(script).good())
    {
      throw InputError("Script " + script + " cannot be read.");
    }
  };
  return this->Agree(read, this->LeftOut);
}

void CatalystRun::RejectStart()
{
  this->LeftOut = "Catalyst cannot start: it runs or has run before in this process.";
}

} // namespace vfm
