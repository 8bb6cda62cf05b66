"""Meshes a segmentation of organs, such as TotalSegmentator's, as a deck.

usage: python Examples/organs.py [FILE.nii.gz] [--width MM] [--output organs.inp]
                                 [--scan CT.nii.gz] [--bone NAME]

TotalSegmentator --ml writes one NIfTI image with a label per organ, whose names are in its header;
they become the names of element sets and surfaces. Without a file an image of three organs in a
trunk is made, with such names. Voxels are replaced by wider cells of the given width, and small
regions join their surroundings. The ending of the output selects the program: .inp for Abaqus and
CalculiX, .k, .bdf, .e, and .feb for FEBio. One conforming mesh has all
organs, with a named surface between each two that touch.

The grey values of the scan, of the same voxels, divide the bone into ten materials of its file:
density rho = 0.1 + 0.0008 HU in g/cm3, Young's modulus 6850 rho^1.49 in MPa.

Prints the volume of each organ in the mesh and in the voxels. Requires volume_fraction_mesh and
nibabel.
"""
import argparse
import os

import numpy as np

import volume_fraction_mesh as vfm

# label, name, centre and half axes of an ellipsoid in mm; later ones are inside of earlier ones
ORGANS = ((1, "trunk", (60, 45, 60), (58, 43, 58)), (5, "liver", (42, 45, 70), (26, 24, 22)),
          (10, "spleen", (92, 50, 72), (12, 16, 14)), (26, "vertebrae_L1", (60, 70, 50),
                                                       (11, 10, 16)))
WIDTH = 3.0  # of voxels, mm
SMALLEST = 20  # cells of a region
BINS, LAW = 10, dict(a=6850, b=1.49, poisson=0.3, c0=0.1, c1=0.0008)


def make_files(path, scan):
    """Writes an image of organs, with names as TotalSegmentator stores them, and a scan."""
    import nibabel
    axes = [(np.arange(n) + 0.5) * WIDTH for n in (40, 30, 40)]
    x, y, z = np.meshgrid(*axes, indexing="ij")
    labels = np.zeros(x.shape, np.uint8)
    for label, _, (a, b, c), (p, q, r) in ORGANS:
        labels[((x - a) / p) ** 2 + ((y - b) / q) ** 2 + ((z - c) / r) ** 2 < 1] = label
    image = nibabel.Nifti1Image(labels, np.diag([WIDTH, WIDTH, WIDTH, 1]))
    names = "".join('<Label Key="%d" Red="1" Green="0" Blue="0" Alpha="1"><![CDATA[%s]]></Label>'
                    % (label, name) for label, name, _, _ in ORGANS)
    text = ('<?xml version="1.0" encoding="UTF-8"?><CaretExtension><VolumeInformation Index="0">'
            "<LabelTable>%s</LabelTable></VolumeInformation></CaretExtension>" % names)
    image.header.extensions.append(nibabel.nifti1.Nifti1Extension(0, text.encode()))
    nibabel.save(image, path)
    nibabel.save(nibabel.Nifti1Image(np.float32(200 + 8 * z), image.affine), scan)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", nargs="?", help="image of labels, .nii.gz")
    parser.add_argument("--width", type=float, default=2 * WIDTH, help="width of cells, mm")
    parser.add_argument("--output", default="out/organs/organs.inp", help="file of the mesh")
    parser.add_argument("--scan", help="image of grey values, .nii.gz")
    parser.add_argument("--bone", default="vertebrae_L1", help="organ that the scan divides")
    arguments = parser.parse_args()
    folder = os.path.dirname(arguments.output) or "."
    os.makedirs(folder, exist_ok=True)
    path, scan, state = arguments.file, arguments.scan, {}
    if path is None:
        path, scan = (os.path.join(folder, name) for name in ("organs.nii.gz", "scan.nii.gz"))
        make_files(path, scan)
    if scan is not None:
        import nibabel
        state["grey"] = nibabel.load(scan).get_fdata()
    mesh = vfm.tets(labels=vfm.read(path), cell_width=arguments.width, state=state,
                    state_kinds={name: "volume" for name in state}, state_transfer="conserve",
                    minimum_region_cells=SMALLEST)
    if state:
        mesh = mesh.bin_materials("grey", BINS, materials=arguments.bone, **LAW)
        bins = mesh.fields
        print("%s: %d bins, volume %.4f mm3, mean grey value %.2f, E %.0f to %.0f MPa" % (
            arguments.bone, len(bins["BinIds"]), bins["BinVolume"].sum(),
            np.average(bins["BinMean"], weights=bins["BinVolume"]), bins["BinModulus"].min(),
            bins["BinModulus"].max()))
    mesh.save(arguments.output)
    print("%d tetrahedra, scaled Jacobian at least %.2f" % (len(mesh), mesh.quality.min()))
    table = mesh.materials
    for name, volume, known in zip(table["Name"], table["MeshVolume"], table["TargetVolume"]):
        print("%s: %.4f mm3 in the mesh, %.4f in the voxels" % (name, volume, known))


if __name__ == "__main__":
    main()
