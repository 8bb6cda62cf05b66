/// State is the same, bit for bit, on any number of ranks.
#include "StateCases.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;
