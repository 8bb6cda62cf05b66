/// A sched_yield that sleeps. Loaded before all other libraries (LD_PRELOAD), it replaces the
/// function of the C library. Open MPI calls it repeatedly while a rank waits for another
/// (mpi_yield_when_idle). Waiting ranks then leave the cores to working ranks.
#include <ctime>

#include <sched.h>

int sched_yield() noexcept
{
  const timespec pause{ 0, 20000 }; // nanoseconds
  nanosleep(&pause, nullptr);
  return 0;
}
