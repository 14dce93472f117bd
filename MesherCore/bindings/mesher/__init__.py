"""Delaunay meshes directly from the exact B-rep geometry of CAD models.

    import mesher
    mesh = mesher.mesh("part.step", size=2.0)
    mesh.write("part.msh")
"""
import json

from . import _core
from ._core import Mesh, Model
from .errors import Cancelled, MesherError, MeshingError, ModelError, WriteError
from .fem_mesh import to_fem_mesh
from .model_argument import model_of

__version__ = _core.__version__
__all__ = ["Cancelled", "Mesh", "MesherError", "MeshingError", "Model", "ModelError", "WriteError", "info", "mesh"]


def mesh(source, *, progress=None, heal=False, **options):
    """Meshes a model: the path of a file (STEP, IGES, BREP), a Part.Shape, or a document object that has a shape.

    Options are those of the command line with underscores: dimension (2 or 3), size, min_size, curvature, sag, refinement,
    grading, local_sizes ({"Face6": 0.5}), min_angle, max_turn, measure ("q1" ... "q8"), threshold, improve, order, threads,
    max_elements, timeout (seconds), check. Lengths are in the model's unit, angles in degrees.

    `progress(stage, fraction)` is told how far the run is and ends it by returning False. Other threads run meanwhile.

    Raises ModelError, MeshingError (with `failures`, `report` and what there is of a `mesh`), Cancelled; TypeError and
    ValueError for options that make no sense.
    """
    result, text = _core.run(model_of(source, heal), options, progress)
    report = json.loads(text)
    if report["status"] == "cancelled":
        raise Cancelled("the run was cancelled", report["failures"], report, result)
    if report["status"] != "done":
        raise _failure_of(report, result)
    result.report = report
    return result


def info(source, heal=False):
    """What a mesher should know of a model before it begins, as a dictionary."""
    return json.loads(model_of(source, heal).info_json())


def _sentence(failure):
    parts = [f"{failure['entity']}: {failure['reason']}" if failure["entity"] else failure["reason"]]
    if failure["remedy"]:
        parts.append(failure["remedy"])
    return "; ".join(parts) + "."


def _failure_of(report, partial):
    failures = report["failures"]
    text = "\n".join(_sentence(failure) for failure in failures)
    if failures and failures[0]["entity"].startswith("--"):
        return ValueError(text)
    return MeshingError(text, failures, report, partial)


Mesh.to_fem_mesh = to_fem_mesh
Mesh.quality = lambda self: self.report["quality"]
