/// A sched_yield that sleeps. Loaded before all other libraries (LD_PRELOAD), it takes the place of
/// the C library's, which Open MPI calls again and again while a rank waits for another
/// (mpi_yield_when_idle). Ranks that wait then leave the cores to ranks that work.
#include <ctime>

#include <sched.h>

int sched_yield() noexcept
{
  const timespec pause{ 0, 20000 }; // nanoseconds
  nanosleep(&pause, nullptr);
  return 0;
}
