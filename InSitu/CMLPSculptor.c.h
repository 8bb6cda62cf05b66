/**
 * CMLPSculptor.c.h: the C interface of Sculptor as its report declares it: Owen, Staten, "Parallel
 * octree-based hexahedral mesh generation for Eulerian to Lagrangian conversion", SAND2010-6400,
 * appendix A. Link libsculptor. C++: CMLPSculptor.hpp. Fortran: module cml_psculptor in
 * cmlpsculptor.f90.
 *
 * The handles are valid for the calls of Sculptor.h, too, which offer more: communicators, several
 * materials, options, global ids, files.
 *
 * The following is not specified by the report. Values of cells are stored x fastest. Node numbers
 * count the nodes of this rank, from 0, or from 1 after sculptor_set_option(handle, "IndexBase",
 * "1"). Coordinates are x, y, z per node, in the length unit of the box. The nodes of an element
 * are in the order of VTK and Exodus (HEX8, TET4). Nodes that several ranks share are on each of
 * them, with the same coordinates.
 *
 * Errors. A call that returns an int other than a handle or a number returns a SculptorCode. After
 * any call sculptor_error_code returns its code, and sculptor_error_text the message. No call ends
 * the process.
 *
 * Collective calls must be made by all ranks of MPI_COMM_WORLD, or of the communicator of
 * sculptor_set_communicator. An error on one rank is then reported on all ranks, except for an
 * invalid handle.
 */
#ifndef CMLPSculptor_c_h
#define CMLPSculptor_c_h

#include "Sculptor.h"

#ifdef __cplusplus
extern "C"
{
#endif

  /**
   * Creates a sculptor.
   * @return handle, from 1; 0 on failure, and sculptor_error_text(0) returns the message
   */
  SCULPTOR_EXPORT int c_create_cml_psculptor(void);

  /**
   * Deletes a sculptor. sculptor_error_code(0) returns the code.
   * @pre Collective, because a communicator is freed
   */
  SCULPTOR_EXPORT void c_delete_cml_psculptor(int handle);

  /**
   * Makes the mesh of one material. The boxes of all ranks must fill one box, and all cells must
   * have the same size. Replaces the box and blocks of the sculptor and removes its materials and
   * states. Sets the options Refinement, MaximumLevel, StairStep and Smoothing; other options stay.
   * @param handle  sculptor
   * @param xmin,ymin,zmin,xmax,ymax,zmax  box of the cells of this rank
   * @param xint,yint,zint  number of cells along each axis, at least 1
   * @param vfrac  xint * yint * zint volume fractions, in [0, 1]; only read, and not needed after
   *   the call
   * @param neighbor_plus_i,neighbor_negative_i  ranks across the faces +x and -x of the box, -1 at
   *   the ends of the whole grid
   * @param neighbor_plus_j,neighbor_negative_j  ranks across the faces +y and -y
   * @param neighbor_plus_k,neighbor_negative_k  ranks across the faces +z and -z
   * @param auto_refine  maximum number of times that cells are halved where the shape needs it,
   *   0 to 10
   * @param stair_step  0: the mesh is smoothed; otherwise cells become elements, no node is moved
   * @param smooth  0: off, 1: quadric surfaces, 2: geometry based
   * @param tet_mesh  0: hexahedra, otherwise tetrahedra
   * @return SCULPTOR_ERROR_ARGUMENT if an argument is wrong; SCULPTOR_ERROR_INPUT if boxes,
   *   neighbours or fractions cannot be meshed. There is then no mesh
   * @pre Collective
   */
  SCULPTOR_EXPORT int c_mesh_from_data(int handle, double xmin, double ymin, double zmin,
    double xmax, double ymax, double zmax, int xint, int yint, int zint, double* vfrac,
    int neighbor_plus_i, int neighbor_negative_i, int neighbor_plus_j, int neighbor_negative_j,
    int neighbor_plus_k, int neighbor_negative_k, int auto_refine, int stair_step, int smooth,
    int tet_mesh);

  /**
   * Returns the size of this rank's mesh, or zeros on failure. sculptor_error_code returns the
   * code of a failure.
   * @param handle  sculptor
   * @param[out] num_nodes,num_hexes,num_tets  number of nodes, hexahedra and tetrahedra
   */
  SCULPTOR_EXPORT void c_get_free_totals(int handle, int* num_nodes, int* num_hexes, int* num_tets);

  /**
   * Copies the nodes and hexahedra of this rank to arrays of the caller, with the sizes of
   * c_get_free_totals. An array may be null if its total is 0. Of a mesh of tetrahedra only the
   * nodes are copied.
   * @param handle  sculptor
   * @param[out] coords  coordinates, shape (num_nodes, 3)
   * @param[out] hexes  node numbers, shape (num_hexes, 8)
   * @return SCULPTOR_ERROR_NO_MESH, SCULPTOR_ERROR_ARGUMENT for a null pointer, or
   *   SCULPTOR_ERROR_SIZE if a node number exceeds int
   */
  SCULPTOR_EXPORT int c_get_free_hexes(int handle, double* coords, int* hexes);
  /**
   * Copies the nodes and tetrahedra of this rank, as c_get_free_hexes does for hexahedra.
   * @param handle  sculptor
   * @param[out] coords  coordinates, shape (num_nodes, 3)
   * @param[out] tets  node numbers, shape (num_tets, 4)
   * @return as for c_get_free_hexes
   */
  SCULPTOR_EXPORT int c_get_free_tets(int handle, double* coords, int* tets);

  /**
   * Returns the number of fragments, the face-connected pieces of the material over all ranks.
   * @return number, equal on all ranks; -1 on failure, and sculptor_error_code returns the code
   */
  SCULPTOR_EXPORT int c_get_num_fragments(int handle);

  /**
   * Returns the size of the local fragment: the elements of a fragment on this rank, possibly none.
   * @param handle  sculptor
   * @param ifrag  fragment, from 1
   * @param[out] num_nodes,num_hexes,num_tets  number of nodes, hexahedra and tetrahedra
   * @return SCULPTOR_ERROR_NO_MESH, or SCULPTOR_ERROR_ARGUMENT if there is no such fragment
   */
  SCULPTOR_EXPORT int c_get_fragment_totals(
    int handle, int ifrag, int* num_nodes, int* num_hexes, int* num_tets);
  /**
   * Copies the nodes and hexahedra of the local fragment, as c_get_free_hexes does for the mesh.
   * Its nodes have their own numbers, in the order of the nodes of the mesh.
   * @param handle  sculptor
   * @param ifrag  fragment, from 1
   * @param[out] coords  coordinates, shape (num_nodes, 3)
   * @param[out] hexes  node numbers, shape (num_hexes, 8)
   * @return as for c_get_free_hexes and c_get_fragment_totals
   */
  SCULPTOR_EXPORT int c_get_fragment_hexes(int handle, int ifrag, double* coords, int* hexes);
  /**
   * Copies the nodes and tetrahedra of the local fragment, as c_get_fragment_hexes copies its
   * hexahedra.
   * @param handle  sculptor
   * @param ifrag  fragment, from 1
   * @param[out] coords  coordinates, shape (num_nodes, 3)
   * @param[out] tets  node numbers, shape (num_tets, 4)
   * @return as for c_get_fragment_hexes
   */
  SCULPTOR_EXPORT int c_get_fragment_tets(int handle, int ifrag, double* coords, int* tets);

#ifdef __cplusplus
}
#endif

#endif
