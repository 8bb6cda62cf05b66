"""Types of the arguments of public functions."""

from __future__ import annotations

from typing import Any, Callable, Literal, Mapping, Sequence, Union

from numpy.typing import ArrayLike

FractionsLike = Union[ArrayLike, Sequence[ArrayLike], Mapping[str, ArrayLike], Any]  # Any: an image
StateLike = Union[Mapping[str, Any], Sequence[str], None]
OfMaterials = Union[ArrayLike, str, Sequence[Any], Mapping[Any, Any], None]
Names = Union[Sequence[str], Mapping[int, str], None]
Triple = Union[float, Sequence[float]]
Sizes = Union[str, Mapping[Union[str, int], float]]
Progress = Union[bool, Callable[[float, str], Any], None]
Ranges = Union[float, str, Sequence[Any], None]
Order = Literal["xyz", "zyx"]
