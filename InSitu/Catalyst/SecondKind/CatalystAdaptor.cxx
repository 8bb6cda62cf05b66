#include "CatalystAdaptor.h"

#include "AgreeOnErrors.h"
#include "DescribeGrid.h"
#include "MpiTransport.h"

#include <catalyst.hpp>

#include <cstdlib>

namespace vfm
{
namespace
{

using conduit_cpp::Node;

/// What went wrong, as far as libcatalyst knows it; implementations have numbers of their own.
std::string NameStatus(catalyst_status status)
{
  const char* name = std::getenv("CATALYST_IMPLEMENTATION_NAME");
  switch (status)
  {
    case catalyst_status_error_not_found:
      return "there is no implementation '" + std::string(name ? name : "") +
        "' (CATALYST_IMPLEMENTATION_NAME) in CATALYST_IMPLEMENTATION_PATHS.";
    case catalyst_status_error_not_catalyst:
    case catalyst_status_error_incomplete:
    case catalyst_status_error_unsupported_version:
      return "the implementation '" + std::string(name ? name : "") +
        "' (CATALYST_IMPLEMENTATION_NAME) does not fit libcatalyst.";
    default:
      return "status " + std::to_string(status) + " of its implementation.";
  }
}

void Check(catalyst_status status, const std::string& what)
{
  if (status != catalyst_status_ok)
  {
    throw InputError(what + ": " + NameStatus(status));
  }
}

/// Of the node catalyst/channels: what the scripts know the grid as.
constexpr const char* InputName = "input";

/// Whether libcatalyst has loaded nothing that would run scripts, and is not asked for dumps either.
bool IsIdle()
{
  Node about;
  return catalyst_about(conduit_cpp::c_node(&about)) == catalyst_status_ok &&
    about.has_path("catalyst/implementation") &&
    about["catalyst/implementation"].as_string() == "stub" &&
    !std::getenv("CATALYST_DATA_DUMP_DIRECTORY");
}

} // namespace

class CatalystAdaptor::Internals : public Failures
{
public:
  Internals(MPI_Comm communicator, const std::vector<std::string>& scripts);
  ~Internals();
  /// step: the node catalyst/state.
  bool Process(const HostGrid& grid, const Node& step, const std::vector<HostNumber>& numbers);

  int StepsMade = 0;

private:
  void Start(const std::vector<std::string>& scripts);

  MPI_Comm Communicator = MPI_COMM_NULL;
  bool IsStarted = false;  ///< so that it has to end
  bool TakesSteps = false; ///< the same on all ranks
};

CatalystAdaptor::Internals::Internals(
  MPI_Comm communicator, const std::vector<std::string>& scripts)
{
  static bool started = false; // ParaView cannot start again after it has ended
  MPI_Comm_dup(communicator, &this->Communicator);
  if (started)
  {
    this->LeftOut = "Catalyst cannot start: it runs or has run before in this process.";
    return;
  }
  MpiRanks ranks(this->Communicator);
  std::vector<std::string> kept;
  for (const std::string& script : scripts)
  {
    if (CanRead(script, ranks, this->LeftOut))
    {
      kept.push_back(script);
    }
  }
  if (scripts.empty() || !kept.empty())
  {
    started = true;
    this->TakesSteps = Agree(
      ranks, [&] { this->Start(kept); }, this->LeftOut);
  }
}

CatalystAdaptor::Internals::~Internals()
{
  if (this->IsStarted)
  {
    const Node nothing;
    catalyst_finalize(conduit_cpp::c_node(&nothing));
  }
  MPI_Comm_free(&this->Communicator);
}

void CatalystAdaptor::Internals::Start(const std::vector<std::string>& scripts)
{
  Node parameters;
  Node catalyst = parameters["catalyst"];
  catalyst["mpi_comm"].set_int64(MPI_Comm_c2f(this->Communicator));
  for (std::size_t s = 0; s < scripts.size(); ++s)
  {
    catalyst["scripts"]["script" + std::to_string(s)]["filename"].set_string(scripts[s]);
  }
  Check(catalyst_initialize(conduit_cpp::c_node(&parameters)), "Catalyst cannot start");
  this->IsStarted = true;
  if (!scripts.empty() && IsIdle())
  {
    throw InputError("No script is run: libcatalyst has no implementation that would. "
                     "CATALYST_IMPLEMENTATION_NAME must name one, as paraview.");
  }
}

bool CatalystAdaptor::Internals::Process(
  const HostGrid& grid, const Node& step, const std::vector<HostNumber>& numbers)
{
  if (!this->TakesSteps)
  {
    return true;
  }
  MpiRanks ranks(this->Communicator);
  Node parameters;
  const auto describe = [&]
  {
    Node catalyst = parameters["catalyst"];
    catalyst["state"].set_node(step);
    Node channel = catalyst["channels"][InputName], meshes = channel["data"];
    channel["type"].set_string("multimesh");
    DescribeGrid(grid, numbers, ranks, meshes);
  };
  if (!Agree(ranks, describe, this->Failed))
  {
    return false;
  }
  ++this->StepsMade;
  // An implementation does not call a failed script again, but on other ranks it would: they would wait for this one.
  this->TakesSteps = Agree(
    ranks,
    [&]
    {
      Check(catalyst_execute(conduit_cpp::c_node(&parameters)),
        "Catalyst failed at step " + std::to_string(step["timestep"].to_int64()));
    },
    this->LeftOut);
  return this->TakesSteps;
}

CatalystAdaptor::CatalystAdaptor(MPI_Comm communicator, const std::vector<std::string>& scripts) :
  Self(std::make_unique<Internals>(communicator, scripts))
{
}

CatalystAdaptor::~CatalystAdaptor() = default;

bool CatalystAdaptor::Process(
  const HostGrid& grid, double time, int step, const std::vector<HostNumber>& numbers, bool last)
{
  Node state;
  state["timestep"].set_int64(step);
  state["cycle"].set_int64(step);
  state["time"].set_float64(time);
  state["last"].set_int64(last);
  this->Self->Failed.clear();
  const bool processed = this->Self->Process(grid, state, numbers);
  return processed && this->GetError().empty();
}

const std::string& CatalystAdaptor::GetError() const
{
  return this->Self->Tell();
}

int CatalystAdaptor::GetNumberOfStepsMade() const
{
  return this->Self->StepsMade;
}

} // namespace vfm
