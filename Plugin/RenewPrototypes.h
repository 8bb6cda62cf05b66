/**
 * A client that loads the plugin after its server did has made of some proxies of the server a prototype, without the domains that it did
 * not know. By its prototype ParaView chooses a writer.
 */
#pragma once

namespace vfm
{

/// Called once, when the plugin is loaded; does nothing but on clients. ParaView makes the prototypes anew when they are asked for.
void RenewPrototypes();

} // namespace vfm
