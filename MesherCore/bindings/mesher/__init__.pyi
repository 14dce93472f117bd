from os import PathLike
from typing import Any, Callable, Literal, Mapping, Optional, Union

import numpy
from numpy.typing import NDArray

__version__: str

Failure = Mapping[str, Any]
Progress = Callable[[str, float], Optional[bool]]

class MesherError(Exception):
    failures: list[Failure]
    report: Optional[dict[str, Any]]
    mesh: Optional["Mesh"]

class ModelError(MesherError): ...
class MeshingError(MesherError): ...
class Cancelled(MesherError): ...
class WriteError(MesherError): ...

class Model:
    format: str
    unit: str
    solid_count: int
    face_count: int
    edge_count: int
    vertex_count: int
    @staticmethod
    def read(path: Union[str, PathLike[str]], heal: bool = False) -> Model: ...
    def info_json(self) -> str: ...

class Mesh:
    """Arrays are views of the mesh's own memory, read-only; entities count from 0."""

    nodes: NDArray[numpy.float64]
    """(n, 3), model units"""
    node_dimension: NDArray[numpy.uint8]
    """(n,): 0 on a vertex, 1 on an edge, 2 on a face, 3 inside of a solid"""
    node_entity: NDArray[numpy.uint32]
    points: NDArray[numpy.uint32]
    lines: NDArray[numpy.uint32]
    triangles: NDArray[numpy.uint32]
    tets: NDArray[numpy.uint32]
    point_vertex: NDArray[numpy.uint32]
    line_edge: NDArray[numpy.uint32]
    triangle_face: NDArray[numpy.uint32]
    tet_solid: NDArray[numpy.uint32]
    unit: str
    hash: int
    report: dict[str, Any]
    def quality(self) -> dict[str, Any]: ...
    def check(self) -> list[str]: ...
    def write(self, path: Union[str, PathLike[str]], format: str = "") -> None: ...
    def to_fem_mesh(self, lines: bool = False, names: Optional[Mapping[str, str]] = None) -> Any: ...

def mesh(
    source: Any,
    *,
    progress: Optional[Progress] = None,
    heal: bool = False,
    dimension: Literal[2, 3] = 3,
    size: Optional[float] = None,
    min_size: Optional[float] = None,
    curvature: float = 0.0,
    sag: float = 0.0,
    refinement: float = 1.0,
    grading: float = 1.0,
    local_sizes: Optional[Mapping[str, float]] = None,
    min_angle: float = 30.0,
    max_turn: float = 90.0,
    measure: str = "q2",
    threshold: Optional[float] = None,
    improve: bool = True,
    order: Literal[1, 2] = 1,
    threads: int = 1,
    max_elements: int = 50_000_000,
    timeout: Optional[float] = None,
    check: bool = False,
) -> Mesh: ...
def info(source: Any, heal: bool = False) -> dict[str, Any]: ...
