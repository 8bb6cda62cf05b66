/**
 * WatchMaterials: adds the names of materials to the legends of meshes, in the ParaView GUI and
 * in scripts.
 */
#pragma once

namespace vfm
{

/// Starts to add the names of materials to the colour maps of MaterialId and MaterialPair of shown
/// meshes (NameMaterials). Names are read when data get a representation, when ParaView makes such
/// a colour map, and after each update. Called once, when the plugin is loaded; does nothing except
/// on clients.
void WatchMaterials();

} // namespace vfm
