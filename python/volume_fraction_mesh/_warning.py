"""Defines the warning of the package."""


class VolumeFractionMeshWarning(UserWarning):
    """Warning about a mesh that may differ from what the input suggests.

    Examples are fractions that were clipped, a material without elements, and material that is left
    out of the mesh.

    Examples
    --------
    >>> import warnings
    >>> import numpy as np
    >>> fraction = np.zeros((5, 5, 5))  # nothing to mesh
    >>> with warnings.catch_warnings(record=True) as caught:
    ...     warnings.simplefilter("always", vfm.VolumeFractionMeshWarning)
    ...     mesh = vfm.hexes(fraction)
    >>> len(mesh), caught[0].category.__name__
    (0, 'VolumeFractionMeshWarning')
    """
