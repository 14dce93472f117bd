"""Delaunay meshes directly from the exact B-rep geometry of CAD models.

    import mesher
    mesh = mesher.mesh("part.step", size=2.0)
    mesh.write("part.msh")
"""
import json
import warnings

from . import _core
from ._core import Mesh, Model
from .errors import Cancelled, MesherError, MesherWarning, MeshingError, ModelError, OptionError, WriteError, error_of
from .fem_mesh import to_fem_mesh
from .model_argument import model_of

__version__ = _core.__version__
__all__ = ["Cancelled", "Mesh", "MesherError", "MesherWarning", "MeshingError", "Model", "ModelError", "OptionError", "WriteError",
           "estimate", "info", "mesh", "model_of", "validate"]


def mesh(source, *, progress=None, heal=False, dimension=3, faces=None, size=None, min_size=None, curvature=0.0, sag=0.0,
         refinement=None, grading=1.0, local_sizes=None, size_distance=None, size_box=None, size_ball=None, size_formula=None,
         size_points=None, background=None, min_angle=30.0, max_turn=90.0, measure="q2", threshold=None,
         max_dihedral=None, lambda_=None, improve=True, order=1, threads=1, max_elements=50_000_000, max_wall_elements=None, overlap="separate", timeout=None,
         check=False):
    """Meshes a model: the path of a file (STEP, IGES, BREP), a Part.Shape, a document object that has a shape, or a Model.

    Lengths are in the model's unit, angles in degrees; None leaves a choice to the mesher. Of several sizes the smallest holds.

    progress        function (stage, fraction): told how far the run is, ends it by returning False; other threads run meanwhile
    heal            repair the shape first
    dimension       3 tetrahedra in the solids, 2 triangles on the faces
    faces           what is meshed in two dimensions: ["Face3"]; None is all
    size, min_size  the mean edge on surfaces where nothing asks for less; the least that any other option may ask for
    curvature       elements in a full turn of a curve; 0 is off
    sag             largest distance of an edge from its curve; 0 is off
    refinement      R: boundary size is local feature size / R; None is 1 on plane faces and no such size in space
    grading         G: sizes grow by at most distance / G
    local_sizes     {"Face6": 0.5} in solids, on faces, edges and vertices
    size_distance   {"Edge3": (size, growth[, plateau])}: by the distance from an entity
    size_box        [(corner, opposite corner, size[, growth])]
    size_ball       [(centre, radius, size[, growth])]
    size_formula    of x, y, z: "0.1 + 0.05*x"
    size_points     array with rows x, y, z, size, or the path of such a text file
    background      (nodes, elements, sizes): arrays of a mesh with a size at each node, or the path of a .msh or .vtu file
    min_angle, max_turn, measure, threshold, max_dihedral   quality: least angle of triangles; turn of the tangent along an edge;
                    the measure of tetrahedra, "q1" to "q8", and the score below which they are refined; the dihedral angle
                    above which they are, whatever they score
    lambda_         how far below the sizes around them bad tetrahedra may be refined before all else is done; 1 or more
    improve         improve the elements after the refinement
    order           1; elements of second order are not there yet
    threads         the mesh does not depend on them
    max_elements, timeout       limits; seconds
    max_wall_elements           that thin walls, gaps and cusps may take; those that take more get flat tetrahedra. None is about
                    as many as the sizes ask for
    overlap         "separate": solids that overlap are meshed each for itself, with a warning; "refuse": they fail the run
    check           check the mesh as a whole before it is returned

    Raises ModelError, MeshingError (with `failures`, `report` and what there is of a `mesh`), Cancelled; OptionError, which is a
    ValueError, for values that make no sense, and TypeError for those of another kind. Warns with MesherWarning of what was left
    out or changed; the mesh's `report` has the same under "warnings".
    """
    options = {name: value for name, value in locals().items() if name not in ("source", "progress", "heal")}
    result, text = _core.run(model_of(source, heal), options, progress)
    report = json.loads(text)
    if result is not None:
        result.report = report
    if report["status"] == "cancelled":
        raise Cancelled("the run was cancelled", report["failures"], report, result)
    if report["status"] != "done":
        raise error_of(report, result)
    for text in report["warnings"]:
        warnings.warn(text, MesherWarning, stacklevel=2)
    return result


def estimate(source, *, heal=False, progress=None, **options):
    """What mesh(source, **options) is going to take, within a factor of 1.5 on ordinary parts: {"elements", "bytes", "seconds",
    "at_least"}; with the last the shape may need far more.

    progress(stage, fraction) ends it by returning False, which raises Cancelled.
    """
    return _core.estimate(model_of(source, heal), options, progress)


def validate(**options):
    """Raises what mesh() would raise for options that make no sense whatever the model is: TypeError, OptionError."""
    _core.validate(options)


def info(source, heal=False):
    """What a mesher should know of a model before it begins, as a dictionary."""
    return json.loads(model_of(source, heal).info_json())


def _quality(self):
    """Of the elements, as in the report: smallest and largest angle in degrees, histogram, ratios."""
    if not hasattr(self, "report"):
        raise ValueError("a mesh that was made of arrays has no report of its quality")
    return self.report["quality"]


Mesh.to_fem_mesh = to_fem_mesh
Mesh.quality = _quality
