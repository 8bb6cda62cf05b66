/**
 * Catalyst2Run: runs Catalyst 2, libcatalyst.
 */
#include "CatalystRun.h"
#include "DescribeGrid.h"

#include <catalyst.hpp>

#include <cstdlib>

namespace vfm
{
namespace
{

using conduit_cpp::Node;

/// Describes a status of libcatalyst; implementations have additional numbers.
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
        "' (CATALYST_IMPLEMENTATION_NAME) is not compatible with libcatalyst.";
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

/// Name of the grid for scripts, a child of the node catalyst/channels.
constexpr const char* InputName = "input";

/// Returns whether libcatalyst has loaded no implementation that runs scripts, and dumps are not
/// requested either.
bool IsIdle()
{
  Node about;
  return catalyst_about(conduit_cpp::c_node(&about)) == catalyst_status_ok &&
    about.has_path("catalyst/implementation") &&
    about["catalyst/implementation"].as_string() == "stub" &&
    !std::getenv("CATALYST_DATA_DUMP_DIRECTORY");
}

class Catalyst2Run : public CatalystRun
{
public:
  Catalyst2Run(MPI_Comm communicator, const std::vector<std::string>& scripts);
  ~Catalyst2Run() override;
  bool Process(
    const HostGrid& grid, const HostStep& step, const std::vector<HostNumber>& numbers) override;

private:
  void Start(const std::vector<std::string>& scripts);

  bool IsStarted = false;  ///< catalyst_finalize must be called
  bool TakesSteps = false; ///< steps are passed; equal on all ranks
};

Catalyst2Run::Catalyst2Run(MPI_Comm communicator, const std::vector<std::string>& scripts) :
  CatalystRun(communicator)
{
  if (HasStarted)
  {
    this->RejectStart();
    return;
  }
  std::vector<std::string> kept;
  for (const std::string& script : scripts)
  {
    if (this->CanRead(script))
    {
      kept.push_back(script);
    }
  }
  if (scripts.empty() || !kept.empty())
  {
    HasStarted = true;
    this->TakesSteps = this->Agree([&] { this->Start(kept); }, this->LeftOut);
  }
}

Catalyst2Run::~Catalyst2Run()
{
  if (this->IsStarted)
  {
    const Node nothing;
    catalyst_finalize(conduit_cpp::c_node(&nothing));
  }
}

void Catalyst2Run::Start(const std::vector<std::string>& scripts)
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
    throw InputError(
      "No script is run: libcatalyst has loaded no implementation that runs scripts. "
      "Set CATALYST_IMPLEMENTATION_NAME, for instance to paraview.");
  }
}

bool Catalyst2Run::Process(
  const HostGrid& grid, const HostStep& step, const std::vector<HostNumber>& numbers)
{
  if (!this->TakesSteps)
  {
    return true;
  }
  Node parameters;
  const auto describe = [&]
  {
    Node catalyst = parameters["catalyst"], state = catalyst["state"];
    state["timestep"].set_int64(step.Number);
    state["cycle"].set_int64(step.Number);
    state["time"].set_float64(step.Time);
    state["last"].set_int64(step.IsLast);
    Node channel = catalyst["channels"][InputName], meshes = channel["data"];
    channel["type"].set_string("multimesh");
    DescribeGrid(grid, numbers, this->Group, meshes);
  };
  if (!this->Agree(describe, this->Failed))
  {
    return false;
  }
  ++this->StepsMade;
  // An implementation calls a failed script again only on ranks where it did not fail. They would
  // wait for this rank.
  this->TakesSteps = this->Agree(
    [&]
    {
      Check(catalyst_execute(conduit_cpp::c_node(&parameters)),
        "Catalyst failed at step " + std::to_string(step.Number));
    },
    this->LeftOut);
  return this->TakesSteps;
}

} // namespace

std::unique_ptr<CatalystRun> StartCatalyst(
  MPI_Comm communicator, const std::vector<std::string>& scripts)
{
  return std::make_unique<Catalyst2Run>(communicator, scripts);
}

} // namespace vfm
