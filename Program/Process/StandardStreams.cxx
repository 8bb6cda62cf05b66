#include "Process/StandardStreams.h"

#include <fcntl.h>
#include <unistd.h>

namespace vfm
{

void OpenStandardStreams()
{
  int file = 0;
  while (file >= 0 && file <= STDERR_FILENO) // the lowest number that is free
  {
    file = open("/dev/null", O_RDWR);
  }
  if (file > STDERR_FILENO)
  {
    close(file);
  }
}

} // namespace vfm
