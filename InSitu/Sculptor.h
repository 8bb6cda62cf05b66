/**
 * Sculptor.h: hexahedral and tetrahedral meshes from the volume fractions of a running simulation, for C and Fortran
 * (module sculptor in sculptor.f90). Link libsculptor; needs MPI and netCDF, no VTK, no ParaView.
 *
 * CMLPSculptor.c.h has the ten calls of Sculptor's report, for one material; these do more. Handles are the same for both.
 *
 * Every call returns one of SculptorCode; sculptor_error_text() tells more. No call ends the process.
 * "Collective": all ranks of the communicator must call, and what is wrong on one rank is refused on all, with the same
 * code and text. Alone is a wrong handle, which names no communicator: only its own rank learns of it.
 *
 * Arrays over cells hold those of this rank's box alone, x fastest, no ghost cells; they are not copied and must stay as
 * they are until the mesh is made. Coordinates are x y z a node, in the unit of the bounding box. Nodes of an element
 * are in the order of VTK and Exodus (HEX8, TET4). Node numbers count this rank's nodes, from 0. Nodes that ranks share occur
 * on each, with the same global id.
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

  enum SculptorCode
  {
    SCULPTOR_OK = 0,
    SCULPTOR_ERROR_HANDLE = 1,   /* no such sculptor: never created, or deleted */
    SCULPTOR_ERROR_ARGUMENT = 2, /* a null pointer, a number out of range, an unknown name */
    SCULPTOR_ERROR_INPUT =
      3, /* data that cannot be meshed: NaN, boxes or neighbours that do not match, ... */
    SCULPTOR_ERROR_NO_MESH = 4, /* asked for a mesh before one was made */
    SCULPTOR_ERROR_SIZE = 5, /* too large for the int of the report's calls: use sculptor_get_* */
    SCULPTOR_ERROR_FILE = 6, /* a file cannot be written */
    SCULPTOR_ERROR_MEMORY = 7,
    SCULPTOR_ERROR_INTERNAL = 8
  };

  /* ---- sculptors ---- */

  /* A new sculptor; its handle, from 1, goes to *sculptor. */
  SCULPTOR_EXPORT int sculptor_create(int* sculptor);

  /* Frees a sculptor and all arrays that it gave. Collective (a communicator is freed). */
  SCULPTOR_EXPORT int sculptor_delete(int sculptor);

  /* ---- before the mesh ---- */

  /* The ranks that work together: a Fortran communicator, from C MPI_Comm_c2f(communicator). Not called: MPI_COMM_WORLD if
   * MPI runs, else this process alone. It is duplicated when the mesh is made, so no message meets the host's. */
  SCULPTOR_EXPORT int sculptor_set_communicator(int sculptor, int communicator);

  /* A property of the filters by its name: IsoValue, MeshVoid, StairStep, Smoothing, SharpEdges, TargetScaledJacobian,
   * ConserveVolume, ComputeQuality, NumberOfThreads, Refinement, MaximumLevel, RefinementBoxes, MaximumAspectRatio,
   * FractionTolerance, ...; of tetrahedra alone Method, RelativeSize, ...; and IndexBase (0 or 1), where c_get_free_hexes and its
   * like begin to count nodes. All ranks must set the same. */
  SCULPTOR_EXPORT int sculptor_set_option(int sculptor, const char* name, const char* value);

  /* This rank's cells. bounding_box: xmin ymin zmin xmax ymax zmax; intervals: 3, how many cells, each at least 1. All boxes
   * must tile one box, with cells of one size. Forgets the blocks of sculptor_add_block. */
  SCULPTOR_EXPORT int sculptor_set_box(
    int sculptor, const double* bounding_box, const int* intervals);

  /* For several blocks a rank, blocks on several levels (AMR) and ranks without cells: begins a further block of this rank, to which
   * the materials or material ids and the states set after it belong. All blocks of all ranks must have the same, in the same
   * order. level: 0 for the coarsest cells of all ranks, L for those halved L times along each axis, at most 30; bounding_box,
   * intervals: as above. All blocks together must fill a box of whole cells of level 0. Those of one level must not overlap;
   * finer ones must cover whole cells of the level before, whose blocks may have values there or not: they are ignored.
   * Messages count a rank's blocks from 0. */
  SCULPTOR_EXPORT int sculptor_add_block(
    int sculptor, int level, const double* bounding_box, const int* intervals);

  /* Forgets the box and all blocks of this rank with their fields, before blocks are begun anew; a rank that begins none has no
   * cells. As long as the grid and the places of the arrays stay, nothing need be called before the next mesh: it is made of the
   * values that are there then. */
  SCULPTOR_EXPORT int sculptor_clear_blocks(int sculptor);

  /* The ranks across -x +x -y +y -z +z, -1 where the whole grid ends; null: not known, and this rank may get the elements of
   * others' cells. Only where every rank has one block, of level 0. */
  SCULPTOR_EXPORT int sculptor_set_neighbours(int sculptor, const int* neighbours);

  /* The next material, its number from 1 in the order of the calls: its volume fractions, in [0,1]. */
  SCULPTOR_EXPORT int sculptor_add_material(int sculptor, const char* name, const double* vfrac);

  /* Instead of volume fractions: the number of the material in each cell, 0 for void. */
  SCULPTOR_EXPORT int sculptor_set_material_ids(int sculptor, const int* ids);

  /* Values of the cells that go to the elements: velocity, density, ... components values a cell. Elements take those of one cell
   * each; where the option DensityArrays names states, mass, momentum, energy and all else of each material are kept: see the options
   * StateTransfer, StateKinds, StateOrder, VelocityArray, EnergyArray, NodalVelocity, LostKineticEnergy, UnmeshedMaterial. */
  SCULPTOR_EXPORT int sculptor_add_state(
    int sculptor, const char* name, int components, const double* values);

  /* For the next mesh alone: how many times each cell of the block last begun, or of the box, is to be halved along every axis,
   * a whole number from 0 to 10; null: none of them. Refinement is then Automatic, by these cells alone unless that option is Automatic by itself, with
   * a MaximumLevel other than 0. MaximumLevel above 0 bounds what they get. With the option FineInterfaces off each place gets what it
   * wants, else all interfaces what the neediest does. */
  SCULPTOR_EXPORT int sculptor_set_refinement(int sculptor, const int* halvings);

  /* Forgets materials and states, for the next time step; box, neighbours and options stay. Hosts with several blocks call
   * sculptor_clear_blocks instead. */
  SCULPTOR_EXPORT int sculptor_clear_fields(int sculptor);

  /* Makes the mesh of all materials. tet_mesh: 0 hexahedra, else tetrahedra. Collective. */
  SCULPTOR_EXPORT int sculptor_make_mesh(int sculptor, int tet_mesh);

  /* ---- the mesh: pointers into the sculptor, good until the next mesh or the end, not to be freed ---- */

  /* corners: 8 or 4, of each element. */
  SCULPTOR_EXPORT int sculptor_get_counts(
    int sculptor, int64_t* points, int64_t* elements, int* corners);
  SCULPTOR_EXPORT int sculptor_get_points(int sculptor, const double** coordinates);
  /* Always from 0, whatever the IndexBase: corners an element. */
  SCULPTOR_EXPORT int sculptor_get_elements(int sculptor, const int64_t** connectivity);
  /* Global ids from 1, with gaps; the same on any number of ranks. */
  SCULPTOR_EXPORT int sculptor_get_point_ids(int sculptor, const int64_t** ids);
  SCULPTOR_EXPORT int sculptor_get_element_ids(int sculptor, const int64_t** ids);
  /* Of each element. */
  SCULPTOR_EXPORT int sculptor_get_materials(int sculptor, const int** ids);
  SCULPTOR_EXPORT int sculptor_get_fragments(int sculptor, const int** ids);
  SCULPTOR_EXPORT int sculptor_get_state(
    int sculptor, const char* name, int* components, const double** values);
  /* Of the nodes: the VelocityArray with the option NodalVelocity. */
  SCULPTOR_EXPORT int sculptor_get_point_state(
    int sculptor, const char* name, int* components, const double** values);
  /* A number of the whole mesh by its name: TargetVolume, MeshVolume, VolumeError (index: 0 for the first material), NumberOfFragments,
   * MinimumScaledJacobian, MeanScaledJacobian, FlippedCells, ... (index 0). Of vectors the index counts components. */
  SCULPTOR_EXPORT int sculptor_get_number(int sculptor, const char* name, int index, double* value);

  /* ---- the geometry that the mesh resolves: pointers as above, points from 0 ----
   * Volumes (fragments), the surfaces between two of them, around them or on a side of the domain, the curves where surfaces
   * meet, the vertices where curves meet or end: each numbered from 1, the same on any number of ranks. */

  /* Of each point: 3 inside a volume, 2 on a surface, 1 on a curve, 0 a vertex; and the number of that volume, surface, .. */
  SCULPTOR_EXPORT int sculptor_get_geometry(int sculptor, const int** dimensions, const int** ids);
  /* This rank's facets, each on one rank alone. connectivity: corners points a facet, 4 or 3 (0 without facets); ids: the
   * surface of each. Null without facets. */
  SCULPTOR_EXPORT int sculptor_get_surfaces(
    int sculptor, int64_t* facets, int* corners, const int64_t** connectivity, const int** ids);
  /* The same of the edges of curves, two points each; and of vertices. */
  SCULPTOR_EXPORT int sculptor_get_curves(
    int sculptor, int64_t* edges, const int64_t** connectivity, const int** ids);
  SCULPTOR_EXPORT int sculptor_get_vertices(
    int sculptor, int64_t* vertices, const int64_t** points, const int** ids);
  /* What bounds what, the same on all ranks: a table by its name, rows of columns values. Each pair once, ascending:
   * VolumeSurfaces (a volume, a surface around it), SurfaceCurves, CurveVertices. A row a surface: SurfaceVolumes and
   * SurfaceMaterials (on its two sides; 0: not meshed, or outside; normals of facets point from the second to the first),
   * SurfaceSides (-1, or 0..5 for -x +x -y +y -z +z), SurfaceParts (0, or which smooth side of an interface with edges, from 1).
   * A row a curve: CurveEnds (how many ends it has at vertices, 0 closed). */
  SCULPTOR_EXPORT int sculptor_get_bounds(
    int sculptor, const char* table, int* rows, int* columns, const int** values);

  /* Writes the mesh of all ranks, the kind by the ending: .vtu, .pvtu, Exodus .e .exo .ex2, Abaqus and
   * CalculiX .inp. Collective. */
  SCULPTOR_EXPORT int sculptor_write(int sculptor, const char* path);

  /* ---- what went wrong ---- */

  /* The SculptorCode of the last call with that sculptor, 0 when it went well; of 0 that of this thread's last call without
   * one: to create, to delete, or with a wrong handle. Of a wrong handle SCULPTOR_ERROR_HANDLE. */
  SCULPTOR_EXPORT int sculptor_error_code(int sculptor);
  /* Of the last call with that sculptor that failed; of handle 0 or a wrong one, of the last such call of this thread.
   * Never null; good until the next call. */
  SCULPTOR_EXPORT const char* sculptor_error_text(int sculptor);
  /* Warnings of the last mesh, a line each; maybe empty. */
  SCULPTOR_EXPORT const char* sculptor_warning_text(int sculptor);

#ifdef __cplusplus
}
#endif

#endif
