#include "TetGen/CallTetGen.h"

#include <csetjmp>
#include <csignal>
#include <stdexcept>

namespace vfm
{
namespace
{

thread_local sigjmp_buf* Return = nullptr; // of the thread that runs TetGen

/// Leaves TetGen. In other threads abort() ends the process after this returns.
extern "C" void LeaveTetGen(int)
{
  if (Return)
  {
    siglongjmp(*Return, 1);
  }
}

/// Handles aborts of this thread while it exists.
class CatchAborts
{
public:
  explicit CatchAborts(sigjmp_buf& place)
  {
    Return = &place;
    struct sigaction action = {};
    action.sa_handler = LeaveTetGen;
    sigaction(SIGABRT, &action, &this->Before);
  }
  CatchAborts(const CatchAborts&) = delete;
  CatchAborts& operator=(const CatchAborts&) = delete;
  ~CatchAborts()
  {
    sigaction(SIGABRT, &this->Before, nullptr);
    Return = nullptr;
  }

private:
  struct sigaction Before;
};

} // namespace

void CallTetGen(tetgenbehavior& switches, tetgenio& input, tetgenio& output)
{
  sigjmp_buf place;
  const CatchAborts catches(place);
  if (sigsetjmp(place, 1) != 0)
  {
    throw std::runtime_error("one of its assertions failed");
  }
  tetrahedralize(&switches, &input, &output);
}

} // namespace vfm
