/**
 * CatalystDouble: an implementation of Catalyst for tests, which hands what it gets to the program
 * that loaded it.
 */
#pragma once

#include <catalyst.h>

extern "C"
{
  /// In the program. call: "initialize", "execute" or "finalize".
  enum catalyst_status ReceiveFromCatalyst(const char* call, const conduit_node* node);
}
