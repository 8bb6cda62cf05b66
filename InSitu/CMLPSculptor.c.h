/**
 * CMLPSculptor.c.h: the C interface of Sculptor as its report declares it: Owen, Staten: "Parallel octree-based hexahedral
 * mesh generation for Eulerian to Lagrangian conversion", SAND2010-6400, appendix A. Link libsculptor. Fortran: module
 * cml_psculptor in cmlpsculptor.f90; C++: CMLPSculptor.hpp.
 *
 * What the report leaves open:
 * - Values of cells are given x fastest; node numbers count this rank's nodes, from 0; coordinates are x y z, in the unit of the box;
 *   nodes of an element are in the order of VTK and Exodus (HEX8, TET4). Nodes that ranks share occur on each, with the same coordinates.
 * - An int that is no handle and no number is a SculptorCode, 0 for success. sculptor_error_code(handle) is that of
 *   the last call, also where it returns nothing; sculptor_error_text(handle) tells more. No call ends the process.
 * - Create, delete and mesh on all ranks of MPI_COMM_WORLD, or of sculptor_set_communicator: what is wrong on one is refused on all.
 *
 * A handle is good for the calls of Sculptor.h too, which do more: other ranks, several materials, options (node numbers from 1:
 * sculptor_set_option(handle, "IndexBase", "1")), global ids, files.
 */
#ifndef CMLPSculptor_c_h
#define CMLPSculptor_c_h

#include "Sculptor.h"

#ifdef __cplusplus
extern "C"
{
#endif

  /* The handle of a new sculptor, from 1; 0 on failure, of which sculptor_error_text(0) tells. */
  SCULPTOR_EXPORT int c_create_cml_psculptor(void);

  /* Frees it. After success sculptor_error_code(0) is 0. */
  SCULPTOR_EXPORT void c_delete_cml_psculptor(int handle);

  /* Makes the mesh of one material.
   * xmin ... zmax: the box of this rank's cells. All boxes must tile one box, with cells of one size.
   * xint, yint, zint: how many cells, at least 1 along each axis.
   * vfrac: xint * yint * zint volume fractions in [0,1], which are only read, and not needed after the call.
   * neighbor_*: the ranks across the faces of the box, -1 where the whole grid ends.
   * auto_refine: how many times cells are halved where the shape needs it, 0 to 10; 0 nowhere.
   * stair_step: not 0: cells become elements and nothing moves.
   * smooth: 0 off, 1 quadric surfaces, 2 geometry based.
   * tet_mesh: 0 hexahedra, else tetrahedra.
   * Options set by name before stay, but for Refinement, MaximumLevel, StairStep, Smoothing; materials and states are forgotten. */
  SCULPTOR_EXPORT int c_mesh_from_data(int handle, double xmin, double ymin, double zmin,
    double xmax, double ymax, double zmax, int xint, int yint, int zint, double* vfrac,
    int neighbor_plus_i, int neighbor_negative_i, int neighbor_plus_j, int neighbor_negative_j,
    int neighbor_plus_k, int neighbor_negative_k, int auto_refine, int stair_step, int smooth,
    int tet_mesh);

  /* Of this rank's mesh; all 0 on failure. */
  SCULPTOR_EXPORT void c_get_free_totals(int handle, int* num_nodes, int* num_hexes, int* num_tets);

  /* This rank's mesh. coords: 3 a node; hexes: 8 a hexahedron; tets: 4 a tetrahedron; allocated by the caller from the totals.
   * A pointer may be null where its total is 0. */
  SCULPTOR_EXPORT int c_get_free_hexes(int handle, double* coords, int* hexes);
  SCULPTOR_EXPORT int c_get_free_tets(int handle, double* coords, int* tets);

  /* Face-connected pieces of the material over all ranks, the same number on each; -1 on failure. */
  SCULPTOR_EXPORT int c_get_num_fragments(int handle);

  /* This rank's part of fragment ifrag, counted from 1; maybe nothing. Its nodes are numbered on their own, in the order of all nodes. */
  SCULPTOR_EXPORT int c_get_fragment_totals(
    int handle, int ifrag, int* num_nodes, int* num_hexes, int* num_tets);
  SCULPTOR_EXPORT int c_get_fragment_hexes(int handle, int ifrag, double* coords, int* hexes);
  SCULPTOR_EXPORT int c_get_fragment_tets(int handle, int ifrag, double* coords, int* tets);

#ifdef __cplusplus
}
#endif

#endif
