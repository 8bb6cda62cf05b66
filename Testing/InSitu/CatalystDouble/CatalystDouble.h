/**
 * CatalystDouble: an implementation of Catalyst for tests. It passes all data
 * to the program that loaded it.
 */
#pragma once

#include <catalyst.h>

extern "C"
{
  /// Defined by the program. call: "initialize", "execute" or "finalize".
  enum catalyst_status ReceiveFromCatalyst(const char* call, const conduit_node* node);
}
