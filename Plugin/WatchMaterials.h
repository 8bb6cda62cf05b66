/**
 * Meshes of this plugin are coloured by material with the names of the materials, in the window and in scripts.
 */
#pragma once

namespace vfm
{

/// Called once, when the plugin is loaded; does nothing but on clients. From then on the colour maps of MaterialId and MaterialPair get
/// the names of the materials (NameMaterials) where a mesh is shown, and again whenever it changed: what is shown is asked for them
/// when it gets a representation, when ParaView makes such a colour map, and after each update.
void WatchMaterials();

} // namespace vfm
