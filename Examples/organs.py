"""Meshes a segmentation of organs, such as TotalSegmentator's, as a deck.

usage: python Examples/organs.py [FILE.nii.gz] [--width MM] [--output organs.inp]

TotalSegmentator --ml writes one NIfTI image with a label per organ, whose names are in its header;
they become the names of element sets and surfaces. Without a file an image of three organs in a
trunk is made, with such names. Voxels are replaced by wider cells of the given width, and small
regions join their surroundings. The ending of the output selects the program: .inp for Abaqus and
CalculiX, .k, .bdf, .e, and .feb for FEBio where the package writes it. One conforming mesh has all
organs, with a named surface between each two that touch.

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


def make_file(path):
    """Writes an image of organs, with names as TotalSegmentator stores them."""
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


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", nargs="?", help="image of labels, .nii.gz")
    parser.add_argument("--width", type=float, default=2 * WIDTH, help="width of cells, mm")
    parser.add_argument("--output", default="out/organs/organs.inp", help="file of the mesh")
    arguments = parser.parse_args()
    folder = os.path.dirname(arguments.output) or "."
    os.makedirs(folder, exist_ok=True)
    path = arguments.file
    if path is None:
        path = os.path.join(folder, "organs.nii.gz")
        make_file(path)
    mesh = vfm.tets(labels=vfm.read(path), cell_width=arguments.width,
                    minimum_region_cells=SMALLEST)
    mesh.save(arguments.output)
    print("%d tetrahedra, scaled Jacobian at least %.2f" % (len(mesh), mesh.quality.min()))
    table = mesh.materials
    for name, volume, known in zip(table["Name"], table["MeshVolume"], table["TargetVolume"]):
        print("%s: %.4f mm3 in the mesh, %.4f in the voxels" % (name, volume, known))


if __name__ == "__main__":
    main()
