/**
 * RenewPrototypes: removes outdated prototypes of writers from a client.
 *
 * ParaView chooses writers by their prototypes. A client that loads the plugin after its server has
 * already made prototypes of the server's proxies, without the domains of this plugin.
 */
#pragma once

namespace vfm
{

/// Removes the prototypes; ParaView makes them again on request. Called once, when the plugin is
/// loaded; does nothing except on clients.
void RenewPrototypes();

} // namespace vfm
