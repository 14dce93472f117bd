from os import PathLike
from typing import Any, Callable, Literal, Mapping, Optional, Sequence, TypedDict, Union

import numpy
from numpy.typing import ArrayLike, NDArray

__version__: str

Path = Union[str, PathLike[str]]
Point = Sequence[float]
Progress = Callable[[str, float], Optional[bool]]

class Failure(TypedDict):
    entity: str
    point: Optional[Sequence[float]]
    reason: str
    remedy: str

class Estimate(TypedDict):
    elements: float
    bytes: float
    seconds: float
    at_least: bool

class MesherError(Exception):
    failures: list[Failure]
    report: Optional[dict[str, Any]]
    mesh: Optional["Mesh"]
    def __init__(
        self,
        message: str,
        failures: Sequence[Mapping[str, Any]] = (),
        report: Optional[dict[str, Any]] = None,
        mesh: Optional["Mesh"] = None,
    ) -> None: ...

class MesherWarning(UserWarning): ...
class ModelError(MesherError): ...
class MeshingError(MesherError): ...
class OptionError(MesherError, ValueError): ...
class Cancelled(MesherError): ...
class WriteError(MesherError): ...

class Model:
    """A B-rep model, read once and meshed as often as you like."""

    @property
    def format(self) -> str: ...
    @property
    def unit(self) -> str: ...
    @property
    def solid_count(self) -> int: ...
    @property
    def face_count(self) -> int: ...
    @property
    def edge_count(self) -> int: ...
    @property
    def vertex_count(self) -> int: ...
    @staticmethod
    def read(path: Path, heal: bool = False, tried: bool = True) -> Model: ...
    def info_json(self) -> str: ...

class Mesh:
    """Arrays are views of the mesh's own memory, read-only; nodes and entities count from 0."""

    report: dict[str, Any]
    @property
    def nodes(self) -> NDArray[numpy.float64]:
        """(n, 3), model units"""
    @property
    def node_dimension(self) -> NDArray[numpy.uint8]:
        """(n,): 0 on a vertex, 1 on an edge, 2 on a face, 3 inside of a solid"""
    @property
    def node_entity(self) -> NDArray[numpy.uint32]:
        """(n,): which vertex, edge, face or solid"""
    @property
    def points(self) -> NDArray[numpy.uint32]:
        """(n, 1): nodes on vertices"""
    @property
    def lines(self) -> NDArray[numpy.uint32]:
        """(n, 2)"""
    @property
    def triangles(self) -> NDArray[numpy.uint32]:
        """(n, 3)"""
    @property
    def tets(self) -> NDArray[numpy.uint32]:
        """(n, 4), positive as in VTK"""
    @property
    def point_vertex(self) -> NDArray[numpy.uint32]: ...
    @property
    def line_edge(self) -> NDArray[numpy.uint32]: ...
    @property
    def triangle_face(self) -> NDArray[numpy.uint32]: ...
    @property
    def tet_solid(self) -> NDArray[numpy.uint32]: ...
    @property
    def unit(self) -> str: ...
    @property
    def hash(self) -> int: ...
    @staticmethod
    def of_arrays(
        nodes: ArrayLike, triangles: ArrayLike, triangle_face: ArrayLike, tets: ArrayLike = ..., tet_solid: ArrayLike = ...
    ) -> Mesh:
        """A mesh that others have made, in arrays as those above; it has no report. Raises ValueError and IndexError."""
    def quality(self) -> dict[str, Any]: ...
    def check(self) -> list[str]: ...
    def write(self, path: Path, format: str = "", groups: Literal["bounding", "all"] = "bounding") -> None: ...
    def to_fem_mesh(self, lines: bool = False, names: Optional[Mapping[str, str]] = None) -> Any: ...

def mesh(
    source: Any,
    *,
    progress: Optional[Progress] = None,
    heal: bool = False,
    dimension: Literal[2, 3] = 3,
    faces: Optional[Sequence[str]] = None,
    size: Optional[float] = None,
    min_size: Optional[float] = None,
    curvature: float = 0.0,
    sag: float = 0.0,
    refinement: float | None = None,
    grading: float = 1.0,
    local_sizes: Optional[Mapping[str, float]] = None,
    size_distance: Optional[Mapping[str, Sequence[float]]] = None,
    size_box: Optional[Sequence[tuple[Any, ...]]] = None,
    size_ball: Optional[Sequence[tuple[Any, ...]]] = None,
    size_formula: Optional[str] = None,
    size_points: Union[None, Path, ArrayLike] = None,
    background: Union[None, Path, tuple[ArrayLike, ArrayLike, ArrayLike]] = None,
    min_angle: float = 30.0,
    max_turn: float = 90.0,
    measure: str = "q2",
    threshold: Optional[float] = None,
    max_dihedral: Optional[float] = None,
    lambda_: Optional[float] = None,
    improve: bool = True,
    order: Literal[1, 2] = 1,
    threads: int = 1,
    max_elements: int = 50_000_000,
    max_wall_elements: Optional[int] = None,
    overlap: Literal["separate", "refuse"] = "separate",
    timeout: Optional[float] = None,
    check: bool = False,
) -> Mesh: ...
def estimate(
    source: Any, *, heal: bool = False, progress: Optional[Progress] = None, **options: Any
) -> Estimate: ...
def info(source: Any, heal: bool = False) -> dict[str, Any]: ...
def model_of(source: Any, heal: bool = False) -> Model: ...
def validate(**options: Any) -> None: ...
