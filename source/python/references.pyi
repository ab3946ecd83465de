"""Closed forms and theories of half-spaces, over numpy arrays."""

from typing import Tuple, Union

import numpy
from numpy.typing import ArrayLike, NDArray

Floats = Union[float, NDArray[numpy.float64]]

class HertzLine:
    """Hertz's line contact. Units: m, Pa."""

    @property
    def half_width(self) -> float: ...
    @property
    def max_pressure(self) -> float: ...
    def load_per_length(self) -> float: ...
    def pressure(self, x: ArrayLike) -> Floats: ...

class HertzEllipse:
    """Hertz's elliptic contact. Units: m, Pa."""

    @property
    def half_width_x(self) -> float: ...
    @property
    def half_width_y(self) -> float: ...
    @property
    def max_pressure(self) -> float: ...
    @property
    def approach(self) -> float: ...
    def load(self) -> float: ...
    def pressure(self, x: ArrayLike, y: ArrayLike) -> Floats: ...

class Carter:
    """Carter's line contact of alike half-planes in steady rolling."""

    def __init__(
        self,
        contact: HertzLine,
        relative_radius: float,
        friction_coefficient: float,
        creepage: float,
        flow_direction: int = 1,
    ) -> None: ...
    @property
    def saturation_creepage(self) -> float: ...
    @property
    def stick_interval(self) -> Tuple[float, float]: ...
    @property
    def force_ratio(self) -> float: ...
    def traction(self, x: ArrayLike) -> Floats: ...

def hertz_line(load_per_length: float, relative_radius: float, contact_modulus: float) -> HertzLine: ...
def hertz_ellipse(load: float, curvature_x: float, curvature_y: float, contact_modulus: float) -> HertzEllipse: ...
def contact_modulus(
    young_modulus_1: float, poisson_ratio_1: float, young_modulus_2: float, poisson_ratio_2: float
) -> float: ...
def relative_radius(radius_1: float, radius_2: float) -> float: ...
def kalker_coefficients(axis_ratio: float, poisson_ratio: float) -> Tuple[float, float, float, float]: ...
def kalker(
    creepage_x: ArrayLike,
    creepage_y: ArrayLike,
    spin: ArrayLike,
    contact: HertzEllipse,
    shear_modulus: float,
    poisson_ratio: float,
    flow_direction: int = 1,
) -> NDArray[numpy.float64]: ...
def shen_hedrick_elkins(
    creepage_x: ArrayLike,
    creepage_y: ArrayLike,
    spin: ArrayLike,
    contact: HertzEllipse,
    shear_modulus: float,
    poisson_ratio: float,
    friction_coefficient: float,
    flow_direction: int = 1,
) -> NDArray[numpy.float64]: ...
def fastsim(
    creepage_x: ArrayLike,
    creepage_y: ArrayLike,
    spin: ArrayLike,
    contact: HertzEllipse,
    shear_modulus: float,
    poisson_ratio: float,
    friction_coefficient: float,
    flow_direction: int = 1,
) -> NDArray[numpy.float64]: ...
def polach(
    creepage_x: ArrayLike,
    creepage_y: ArrayLike,
    spin: ArrayLike,
    contact: HertzEllipse,
    shear_modulus: float,
    poisson_ratio: float,
    friction_coefficient: float,
    flow_direction: int = 1,
) -> NDArray[numpy.float64]: ...
