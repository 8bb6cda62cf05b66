#include "WorkTogether.h"

#include <climits>
#include <filesystem>
#include <stdexcept>

namespace impact
{

void WorkTogether(MPI_Comm communicator, const std::function<void()>& work)
{
  std::string error;
  try
  {
    work();
  }
  catch (const std::exception& e)
  {
    error = e.what();
  }
  int rank = 0, first = INT_MAX;
  MPI_Comm_rank(communicator, &rank);
  const int failed = error.empty() ? INT_MAX : rank;
  MPI_Allreduce(&failed, &first, 1, MPI_INT, MPI_MIN, communicator);
  if (first < INT_MAX)
  {
    int size = static_cast<int>(error.size());
    MPI_Bcast(&size, 1, MPI_INT, first, communicator);
    error.resize(size);
    MPI_Bcast(&error[0], size, MPI_CHAR, first, communicator);
    throw std::runtime_error(error);
  }
}

void MakeFolder(MPI_Comm communicator, const std::string& path)
{
  WorkTogether(communicator,
    [&path]
    {
      std::error_code problem, other;
      std::filesystem::create_directories(path, problem);
      if (!std::filesystem::is_directory(path, other))
      {
        throw std::runtime_error("cannot make the folder " + path +
          (problem ? ": " + problem.message() : ": a file has that name"));
      }
    });
}

} // namespace impact
