/**
 * Sculptor.h: makes hexahedral and tetrahedral meshes from the volume fractions of a running
 * simulation, for C, C++ and Fortran (module sculptor in sculptor.f90). Link libsculptor, which
 * needs MPI and netCDF, but neither VTK nor ParaView.
 *
 * CMLPSculptor.c.h declares the ten calls of Sculptor's report, for one material. The calls below
 * offer more. Handles are valid for both headers.
 *
 * A typical sequence is sculptor_create, sculptor_set_box, sculptor_add_material,
 * sculptor_make_mesh, sculptor_get_*, sculptor_delete. Examples/sculptor has complete programs.
 *
 * Errors. Each call returns a SculptorCode; sculptor_error_text returns the message. Each call may
 * return SCULPTOR_ERROR_HANDLE, SCULPTOR_ERROR_MEMORY and SCULPTOR_ERROR_INTERNAL; further codes
 * are listed with each call. Null pointers give SCULPTOR_ERROR_ARGUMENT, unless they have a
 * meaning. No call ends the process.
 *
 * Collective calls must be made by all ranks of the communicator. An error on one rank is then
 * reported on all ranks, with the same code and message. Exception: an invalid handle, which has no
 * communicator, is reported only on the calling rank.
 *
 * Input arrays contain the cells of one box or block of this rank, x fastest, without ghost cells.
 * They are not copied and must not change or move until the mesh is made.
 *
 * Output arrays belong to the sculptor; the calls set pointers to them. They are valid until the
 * next call of sculptor_make_mesh, c_mesh_from_data or sculptor_delete. Do not free them.
 *
 * Coordinates are x, y, z per node, in the length unit of the bounding box. The nodes of an element
 * are in the order of VTK and Exodus (HEX8, TET4). Node numbers count the nodes of this rank, from
 * 0. Nodes that several ranks share are on each of them, with the same global id.
 *
 * Threads. A sculptor may be used by one thread at a time.
 */
#ifndef Sculptor_h
#define Sculptor_h

#include <stdint.h>

#if defined(_WIN32)
#define SCULPTOR_EXPORT
#else
#define SCULPTOR_EXPORT __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C"
{
#endif

  /** Result of a call. */
  enum SculptorCode
  {
    /** Success. */
    SCULPTOR_OK = 0,
    /** The handle is invalid: the sculptor was never created, or it was deleted. */
    SCULPTOR_ERROR_HANDLE = 1,
    /** An argument is invalid: a null pointer, a number out of range, an unknown name. */
    SCULPTOR_ERROR_ARGUMENT = 2,
    /** The data cannot be meshed: NaN, or boxes or neighbours that do not match, for example. */
    SCULPTOR_ERROR_INPUT = 3,
    /** There is no mesh: none was made, or the last one failed. */
    SCULPTOR_ERROR_NO_MESH = 4,
    /** The mesh is too large for the int of the report's calls: use sculptor_get_*. */
    SCULPTOR_ERROR_SIZE = 5,
    /** A file cannot be written. */
    SCULPTOR_ERROR_FILE = 6,
    /** There is not enough memory. */
    SCULPTOR_ERROR_MEMORY = 7,
    /** An internal error. */
    SCULPTOR_ERROR_INTERNAL = 8
  };

  /** @name Sculptors
   * @{ */

  /**
   * Creates a sculptor.
   * @param[out] sculptor  handle, from 1; unchanged on failure
   * @return SCULPTOR_ERROR_ARGUMENT for a null pointer, with the message in sculptor_error_text(0)
   */
  SCULPTOR_EXPORT int sculptor_create(int* sculptor);

  /**
   * Deletes a sculptor and all arrays that it has returned.
   * @return SCULPTOR_ERROR_HANDLE for an invalid handle; sculptor_error_text(0) returns the message
   * @pre Collective, because a communicator is freed
   */
  SCULPTOR_EXPORT int sculptor_delete(int sculptor);

  /** @}
   * @name Input
   * @{ */

  /**
   * Sets the ranks that work together. Without this call they are the ranks of MPI_COMM_WORLD, or
   * only this process if MPI is not running.
   * @param communicator  Fortran handle; in C, MPI_Comm_c2f(communicator). It is duplicated when
   *   the mesh is made, so that messages do not interfere with messages of the simulation
   * @return SCULPTOR_ERROR_ARGUMENT for MPI_COMM_NULL, or if MPI is not running
   * @pre Collective if a mesh was made on another communicator, whose duplicate is freed
   */
  SCULPTOR_EXPORT int sculptor_set_communicator(int sculptor, int communicator);

  /**
   * Sets an option by name. All ranks must set the same options; sculptor_make_mesh checks this.
   * Options stay set until they are changed. Documentation/reference/options.md lists them:
   * IsoValue, MeshVoid, StairStep, Smoothing, SharpEdges, TargetScaledJacobian, ConserveVolume,
   * ComputeQuality, NumberOfThreads, Refinement, MaximumLevel, RefinementBoxes, MaximumAspectRatio,
   * FractionTolerance and others; for tetrahedra also Method and RelativeSize. The option
   * IndexBase, 0 or 1, is the number of the first node in the arrays of c_get_free_hexes and of
   * similar calls of CMLPSculptor.c.h.
   * @param name  name of the option; case matters only for IndexBase
   * @param value  value as text: a number, "on" or "off", a word such as "Automatic", or a list of
   *   names with commas between them
   * @return SCULPTOR_ERROR_ARGUMENT if the option does not exist or cannot have this value
   */
  SCULPTOR_EXPORT int sculptor_set_option(int sculptor, const char* name, const char* value);

  /**
   * Sets the box of cells of this rank. The boxes of all ranks must fill one box, and all cells
   * must have the same size. sculptor_make_mesh checks the numbers. The box replaces an earlier one
   * and all blocks of sculptor_add_block; fields that were set for the first of them are kept.
   * @param bounding_box  xmin, ymin, zmin, xmax, ymax, zmax; copied
   * @param intervals  3 numbers of cells along x, y and z, each at least 1; copied
   */
  SCULPTOR_EXPORT int sculptor_set_box(
    int sculptor, const double* bounding_box, const int* intervals);

  /**
   * Adds a block of cells to this rank, for several blocks per rank, for blocks on several levels
   * (AMR), and if there are ranks without cells. Materials or material ids, states and refinement
   * that are set after this call belong to the block. All blocks of all ranks must have the same
   * fields in the same order. Error messages count the blocks of a rank from 0.
   *
   * All blocks together must fill a box of whole cells of level 0. Blocks of one level must not
   * overlap. Blocks of a finer level must cover whole cells of the next coarser level. Blocks of
   * coarser levels may or may not exist below them; their values there are ignored.
   * @param level  0 for the coarsest cells of all ranks, L for cells halved L times along each
   *   axis, at most 30
   * @param bounding_box  xmin, ymin, zmin, xmax, ymax, zmax; copied
   * @param intervals  3 numbers of cells along x, y and z, each at least 1; copied
   */
  SCULPTOR_EXPORT int sculptor_add_block(
    int sculptor, int level, const double* bounding_box, const int* intervals);

  /**
   * Removes the box and all blocks of this rank with their fields, so that new blocks can be added.
   * A rank that adds none has no cells. This call is not necessary before the next mesh if the grid
   * and the addresses of the arrays stay the same: the mesh is made from the current values.
   */
  SCULPTOR_EXPORT int sculptor_clear_blocks(int sculptor);

  /**
   * Sets the ranks across the faces of this rank's box. Each rank then gets the elements of its own
   * cells, or with the options CellWidth and MaterialWidths those of the new cells whose centres
   * are in its box. Neighbours must be set on all ranks or on none, and each rank must have exactly
   * one block, of level 0. sculptor_make_mesh checks this.
   * @param neighbours  6 ranks across -x, +x, -y, +y, -z, +z, -1 at the ends of the whole grid;
   *   copied. Null: not known; the cells are redistributed, and this rank may receive elements of
   *   cells of other ranks
   */
  SCULPTOR_EXPORT int sculptor_set_neighbours(int sculptor, const int* neighbours);

  /**
   * Adds a material to the box or to the block added last. Materials have the numbers 1, 2, ... in
   * the order of the calls.
   * @param name  name of the material; copied
   * @param vfrac  volume fraction per cell, in [0, 1]
   */
  SCULPTOR_EXPORT int sculptor_add_material(int sculptor, const char* name, const double* vfrac);

  /**
   * Sets the material of each cell of the last box or block, instead of volume fractions.
   * @param ids  material number per cell, 0 for void
   */
  SCULPTOR_EXPORT int sculptor_set_material_ids(int sculptor, const int* ids);

  /**
   * Adds a state to the box or to the block added last, for instance velocity or density, that is
   * transferred to the elements. An element takes the values of one cell. If the option
   * DensityArrays names states, mass, momentum, energy and other state of each material are
   * conserved instead; see the options StateTransfer, StateKinds, StateOrder, VelocityArray,
   * EnergyArray, NodalVelocity, LostKineticEnergy and UnmeshedMaterial.
   * @param name  name of the state; copied
   * @param components  number of values per cell, at least 1
   * @param values  values, shape (cells, components), row-major
   */
  SCULPTOR_EXPORT int sculptor_add_state(
    int sculptor, const char* name, int components, const double* values);

  /**
   * Selects cells to refine, for the next mesh only, in the box or in the block added last. The
   * mesh is made with the option Refinement Automatic. If Refinement is not Automatic, or
   * MaximumLevel is 0, only the selected cells are refined. MaximumLevel above 0 limits the number
   * of halvings. With the option FineInterfaces off, each place gets its own level; otherwise all
   * interfaces get the finest level.
   * @param halvings  number of halvings along every axis per cell, 0 to 10; not copied. Null: no
   *   cells are selected
   */
  SCULPTOR_EXPORT int sculptor_set_refinement(int sculptor, const int* halvings);

  /**
   * Removes all materials and states, before the fields of the next time step are set. Box,
   * neighbours and options stay. With several blocks, call sculptor_clear_blocks instead.
   */
  SCULPTOR_EXPORT int sculptor_clear_fields(int sculptor);

  /**
   * Makes the mesh of all materials. The elements and ids do not depend on the number of ranks,
   * except for tetrahedra by TetGen.
   * @param tet_mesh  0: hexahedra, otherwise tetrahedra
   * @return SCULPTOR_ERROR_ARGUMENT if fields, boxes or options are missing, wrong or different on
   *   the ranks; SCULPTOR_ERROR_INPUT if they cannot be meshed. There is then no mesh
   * @pre Collective
   */
  SCULPTOR_EXPORT int sculptor_make_mesh(int sculptor, int tet_mesh);

  /** @}
   * @name Mesh
   * Arrays of the mesh of this rank. Each call returns SCULPTOR_ERROR_NO_MESH if there is no mesh.
   * @{ */

  /**
   * Returns the size of this rank's mesh.
   * @param[out] points,elements  number of nodes and of elements of this rank
   * @param[out] corners  nodes per element, 8 or 4; 0 without elements
   */
  SCULPTOR_EXPORT int sculptor_get_counts(
    int sculptor, int64_t* points, int64_t* elements, int* corners);
  /**
   * Returns the coordinates of the nodes.
   * @param[out] coordinates  shape (points, 3); null without nodes
   */
  SCULPTOR_EXPORT int sculptor_get_points(int sculptor, const double** coordinates);
  /**
   * Returns the nodes of the elements.
   * @param[out] connectivity  node numbers from 0 whatever the IndexBase, shape (elements,
   *   corners); null without elements
   */
  SCULPTOR_EXPORT int sculptor_get_elements(int sculptor, const int64_t** connectivity);
  /**
   * Returns the global ids of the nodes, which do not depend on the number of ranks.
   * @param[out] ids  id per node, from 1, ascending, with gaps; null without nodes
   */
  SCULPTOR_EXPORT int sculptor_get_point_ids(int sculptor, const int64_t** ids);
  /**
   * Returns the global ids of the elements, which do not depend on the number of ranks.
   * @param[out] ids  id per element, from 1, ascending, with gaps; null without elements
   */
  SCULPTOR_EXPORT int sculptor_get_element_ids(int sculptor, const int64_t** ids);
  /**
   * Returns the global ids that nodes had before the option SplitInterfaces gave both sides of
   * interfaces their own nodes. Copies of a node have the same.
   * @param[out] ids  id per node; null if no interface was split
   */
  SCULPTOR_EXPORT int sculptor_get_original_ids(int sculptor, const int64_t** ids);
  /**
   * Returns the cohesive elements of this rank between both sides of split interfaces, if the
   * option SplitConnection is Cohesive. Each element is on the rank of its first side, where the
   * nodes of both sides exist.
   * @param[out] elements  number of cohesive elements
   * @param[out] corners  nodes per element, 8 or 6; 0 without cohesive elements
   * @param[out] connectivity  node numbers from 0, shape (elements, corners): the nodes of the
   * first side, counterclockwise seen from the second side, then those of the second side; null
   * without cohesive elements
   * @param[out] ids  global id per element, above those of all elements; null likewise
   * @param[out] materials  materials of the first and the second side, shape (elements, 2); null
   *   likewise
   */
  SCULPTOR_EXPORT int sculptor_get_cohesive(int sculptor, int64_t* elements, int* corners,
    const int64_t** connectivity, const int64_t** ids, const int** materials);
  /**
   * Returns the materials of the elements.
   * @param[out] ids  material number per element, 0 for void; null without elements
   */
  SCULPTOR_EXPORT int sculptor_get_materials(int sculptor, const int** ids);
  /**
   * Returns the fragments of the elements. A fragment is a face-connected piece of a material over
   * all ranks.
   * @param[out] ids  fragment number per element, from 1 over all ranks; null without elements
   */
  SCULPTOR_EXPORT int sculptor_get_fragments(int sculptor, const int** ids);
  /**
   * Returns the layers of the elements along interfaces and sides, from the option Layers.
   * @param[out] layers  per element 1 next to the surface, 2, ..; 0 elsewhere; null without layers
   */
  SCULPTOR_EXPORT int sculptor_get_layers(int sculptor, const int** layers);
  /**
   * Returns a state of the elements.
   * @param name  name in sculptor_add_state
   * @param[out] components  number of values per element
   * @param[out] values  shape (elements, components)
   * @return SCULPTOR_ERROR_ARGUMENT if the mesh has no such state
   */
  SCULPTOR_EXPORT int sculptor_get_state(
    int sculptor, const char* name, int* components, const double** values);
  /**
   * Returns a state of the nodes: with the option NodalVelocity, the velocity.
   * @param name  name of the state that the option VelocityArray selects
   * @param[out] components  number of values per node
   * @param[out] values  shape (points, components)
   * @return SCULPTOR_ERROR_ARGUMENT if the mesh has no such state
   */
  SCULPTOR_EXPORT int sculptor_get_point_state(
    int sculptor, const char* name, int* components, const double** values);
  /**
   * Returns the particles of this rank: material without elements, if the option UnmeshedMaterial
   * is Particles. Each particle is on one rank; the particles do not depend on the number of ranks.
   * @param[out] particles  number of particles; 0 without the option
   * @param[out] positions  shape (particles, 3); null without particles, as the following
   * @param[out] ids  unique number per particle, from 0, ascending, with gaps
   * @param[out] materials  material number per particle
   * @param[out] radii,volumes  of material, as a sphere
   * @param[out] masses  also null without the option DensityArrays
   */
  SCULPTOR_EXPORT int sculptor_get_particles(int sculptor, int64_t* particles,
    const double** positions, const int64_t** ids, const int** materials, const double** radii,
    const double** volumes, const double** masses);
  /**
   * Returns a state of the particles.
   * @param name  name in sculptor_add_state
   * @param[out] components  number of values per particle
   * @param[out] values  shape (particles, components)
   * @return SCULPTOR_ERROR_ARGUMENT if the particles have no such state
   */
  SCULPTOR_EXPORT int sculptor_get_particle_state(
    int sculptor, const char* name, int* components, const double** values);
  /**
   * Returns a number of the whole mesh, equal on all ranks: TargetVolume, MeshVolume and
   * VolumeError, one per material; NumberOfFragments, MinimumScaledJacobian, MeanScaledJacobian,
   * FlippedCells and others, which Documentation/reference/mesh-data.md lists with their units.
   * RankFragments and RankTargetVolume, if they exist, are of this rank only.
   * @param name  name of the number
   * @param index  from 0: 0 for a single number; m for numbers per material, 3 * m + axis for
   * vectors per material, where m is 0 for the first material
   * @param[out] value  the number
   * @return SCULPTOR_ERROR_ARGUMENT if there is no such number
   */
  SCULPTOR_EXPORT int sculptor_get_number(int sculptor, const char* name, int index, double* value);

  /** @}
   * @name Geometry
   * Geometry that the mesh resolves. It consists of volumes (the fragments), surfaces (between two
   * volumes, around a volume, or on a side of the domain), curves where surfaces meet, and vertices
   * where curves meet or end. Each kind is numbered from 1; numbers do not depend on the number of
   * ranks. Each call returns SCULPTOR_ERROR_NO_MESH if there is no mesh.
   * @{ */

  /**
   * Returns the position of each node in the geometry.
   * @param[out] dimensions  3 for a node in a volume, 2 on a surface, 1 on a curve, 0 at a vertex
   * @param[out] ids  number of that volume, surface, curve or vertex, one per node
   */
  SCULPTOR_EXPORT int sculptor_get_geometry(int sculptor, const int** dimensions, const int** ids);
  /**
   * Returns the facets of surfaces on this rank. Each facet is on one rank. At a split interface
   * its nodes may be those of either side.
   * @param[out] facets  number of facets
   * @param[out] corners  nodes per facet, 4 or 3; 0 without facets
   * @param[out] connectivity  node numbers from 0, shape (facets, corners); null without facets
   * @param[out] ids  surface per facet; null without facets
   */
  SCULPTOR_EXPORT int sculptor_get_surfaces(
    int sculptor, int64_t* facets, int* corners, const int64_t** connectivity, const int** ids);
  /**
   * Returns the edges of curves on this rank. Each edge is on one rank.
   * @param[out] edges  number of edges
   * @param[out] connectivity  node numbers from 0, shape (edges, 2); null without edges
   * @param[out] ids  curve per edge; null without edges
   */
  SCULPTOR_EXPORT int sculptor_get_curves(
    int sculptor, int64_t* edges, const int64_t** connectivity, const int** ids);
  /**
   * Returns the vertices on this rank. Each vertex is on one rank.
   * @param[out] vertices  number of vertices
   * @param[out] points  node number per vertex, from 0; null without vertices
   * @param[out] ids  number per vertex; null without vertices
   */
  SCULPTOR_EXPORT int sculptor_get_vertices(
    int sculptor, int64_t* vertices, const int64_t** points, const int** ids);
  /**
   * Returns a table of adjacency. It is equal on all ranks for up to 100,000 surfaces, or curves
   * and vertices (option WholeTables). Above that number a rank of several gets the rows of the
   * surfaces and curves that it touches; the tables SurfaceIds and CurveIds have their numbers.
   *
   * Tables with one row per pair, each pair once, ascending:
   * - VolumeSurfaces: a volume and a surface around it
   * - SurfaceCurves: a surface and a curve on it
   * - CurveVertices: a curve and a vertex at its end
   *
   * Tables with one row per surface, in the order of their numbers:
   * - SurfaceVolumes and SurfaceMaterials: the volumes, or materials, on its two sides; 0: not
   *   meshed, or outside. Normals of facets point from the second to the first
   * - SurfaceSides: side of the domain, 0 to 5 for -x, +x, -y, +y, -z, +z; otherwise -1
   * - SurfaceParts: number of the smooth side of an interface with edges, from 1; otherwise 0
   *
   * Table with one row per curve:
   * - CurveEnds: number of its ends at vertices; 0: closed
   * @param table  name of the table
   * @param[out] rows,columns  shape of the table
   * @param[out] values  shape (rows, columns), row-major
   * @return SCULPTOR_ERROR_ARGUMENT if there is no such table
   */
  SCULPTOR_EXPORT int sculptor_get_bounds(
    int sculptor, const char* table, int* rows, int* columns, const int** values);

  /** @}
   * @name Files
   * @{ */

  /**
   * Writes the mesh of all ranks, files of Gmsh as text. The suffix selects the format:
   * - .vtu (VTK): all arrays and field data
   * - .pvtu (VTK): the same, with one piece per rank in a folder next to it
   * - .e, .ex2, .exo (Exodus): named blocks, side sets, node sets, ids, variables and particles; N
   *   ranks write one file each, FILE.N.RANK
   * - .inp (Abaqus and CalculiX): sets of elements and nodes, surfaces; velocities of nodes as
   *   initial conditions; particles as point masses
   * - .k, .key (LS-DYNA): parts, sets of nodes and segments, velocities, stresses, particles
   * - .rad (OpenRadioss): parts, groups of nodes, surfaces, velocities, state of elements,
   *   particles
   * - .bdf, .nas (Nastran): properties, sets of nodes, a unit pressure on each surface, particles
   *   as point masses
   * - .feb (FEBio): version 4.0: elements of each material, sets of nodes, surfaces, element data
   * - .msh (Gmsh): version 2.2 or 4.1, text or binary: named volumes, domain sides and interfaces
   * - .xdmf (XDMF): for dolfinx: materials, and a second file of tagged facets, FILE_facets.xdmf
   * - .foam (OpenFOAM): the folder of the file is a case with patches, zones and a cloud of
   *   particles; N ranks write a folder processorRANK each
   * - .stl (STL): only the closed surface of each material; with {} in the name one file per
   *   material, as in bones_{}.stl
   * - .obj (OBJ): the same surfaces, one group per material, with common vertices
   * - .vtp (VTK particles): only the particles, with all arrays
   * - .data (LAMMPS): only the particles, as spheres with diameter, density and velocity
   * @param path  path of the file, equal on all ranks
   * @return SCULPTOR_ERROR_NO_MESH without a mesh, SCULPTOR_ERROR_ARGUMENT if the path is null or
   *   the suffix unknown, SCULPTOR_ERROR_FILE if the file cannot be written
   * @pre Collective
   */
  SCULPTOR_EXPORT int sculptor_write(int sculptor, const char* path);

  /** @}
   * @name Errors
   * @{ */

  /**
   * Returns the code of the last call with a sculptor.
   * @param sculptor  handle; 0 for the last call of this thread without a valid handle:
   *   sculptor_create, sculptor_delete, or any call with an invalid one
   * @return SculptorCode; SCULPTOR_ERROR_HANDLE for an invalid handle other than 0
   */
  SCULPTOR_EXPORT int sculptor_error_code(int sculptor);
  /**
   * Returns the message of the last call with a sculptor that failed.
   * @param sculptor  handle; 0 or an invalid one for the last failed call of this thread without a
   *   valid handle
   * @return text, never null, valid until the next call; empty if no call has failed
   */
  SCULPTOR_EXPORT const char* sculptor_error_text(int sculptor);
  /**
   * Returns the warnings of the last mesh, and since then of sculptor_write: the file with the
   * particles beside a file that holds none.
   * @return text, one line per warning, possibly empty, never null; valid until the next mesh
   *   or file
   */
  SCULPTOR_EXPORT const char* sculptor_warning_text(int sculptor);

  /** @} */

#ifdef __cplusplus
}
#endif

#endif
