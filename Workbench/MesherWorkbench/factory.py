"""The one place that makes mesh objects."""
import os

import FreeCAD
import Part

import mesher

from .objects.mesh import MesherMesh
from .tools import size_words
from .tools.mesh_tool import MeshTool
from .tools.places import is_container, place_in_containers

_PROPERTY_OF_OPTION = {
    "size": "CharacteristicLengthMax",
    "min_size": "CharacteristicLengthMin",
    "curvature": "MeshSizeFromCurvature",
    "sag": "SurfaceDeviation",
    "refinement": "Refinement",
    "grading": "Grading",
    "improve": "OptimizeStd",
    "threads": "Threads",
    "size_formula": "SizeFormula",
    "measure": "QualityMeasure",
    "threshold": "QualityThreshold",
    "max_dihedral": "MaxDihedral",
    "lambda_": "QualityLambda",
    "min_angle": "MinAngle",
    "max_turn": "MaxTurn",
    "overlap": "Overlap",
    "check": "CheckMesh",
    "max_elements": "MaxElements",
    "max_wall_elements": "MaxWallElements",
    "timeout": "Timeout",
}
_FILES = {"size_points": "SizePoints", "background": "BackgroundMesh"}
_WORDS = {
    "size_distance": ("SizeDistances", size_words.of_distances),
    "size_box": ("SizeBoxes", size_words.of_boxes),
    "size_ball": ("SizeBalls", size_words.of_balls),
}
_OPTIONS = {*_PROPERTY_OF_OPTION, *_FILES, *_WORDS, "dimension", "order", "local_sizes", "heal"}


def make_mesh(source, *, name="Mesh", progress=None, **options):
    """Makes a mesh object in the document of `source`, meshes it and returns it.

    `source` is a document object, one with the names of its faces (box, ["Face1", "Face6"]), a selection object of the GUI, or
    a list of these: several objects become one mesh, each solid in a group of its label. Options are those of mesher.mesh but for
    `faces`, which are those of the source; `size_points` and `background` are paths, since the object keeps them.
    `progress(stage, fraction)` ends the run by returning False.

    Raises what mesher.mesh raises; the document has no mesh object then.
    """
    obj = make_mesh_object(source, name=name, **options)
    try:
        update(obj, progress)
    except BaseException:
        obj.Document.removeObject(obj.Name)
        raise
    return obj


# What panels have meshed in threads of their own, for the next update of the object: (tool, mesh) by document and name.
_meshed = {}


def update(obj, progress=None):
    """Meshes a mesh object again, of its part as it is now. Raises what mesher.mesh raises; the object keeps its mesh then."""
    tool, mesh = _meshed.pop((obj.Document.Name, obj.Name), (None, None))
    if tool is None:
        tool = MeshTool(obj)
        mesh = tool.run(progress)
    tool.fill_in(mesh)
    if FreeCAD.GuiUp:
        from .viewproviders.view_mesh import show_mesh_instead_of_part

        show_mesh_instead_of_part(obj)


def keep_for_update(obj, tool, mesh):
    """A mesh that is made already, for the next update of the object."""
    _meshed[obj.Document.Name, obj.Name] = tool, mesh


def make_mesh_object(source, *, name="Mesh", **options):
    """The object alone, not meshed yet; options are those of make_mesh."""
    unknown = sorted(set(options) - _OPTIONS)
    if unknown:
        raise TypeError(f"make_mesh() has no option '{unknown[0]}'")
    # Properties of lengths would make nothing of what is below zero, and say nothing.
    mesher.validate(**{option: value for option, value in options.items() if option != "heal"})
    part, names = _part_and_names(source)
    obj = part.Document.addObject("Fem::FemMeshObjectPython", name)
    try:
        MesherMesh(obj)
        obj.Part = part
        parts = [_part_and_names(one)[0] for one in source] if isinstance(source, list) else [part]
        places = [place_in_containers(one) for one in parts]
        if len(places) > 1 or places[0].path or is_container(part):
            obj.Containers = [place.top for place in places]
            obj.ContainerPaths = [place.path for place in places]
        if names:
            obj.References = [(part, tuple(names))]
        _set_options(obj, is_faces=bool(names), **options)
    except BaseException:
        obj.Document.removeObject(obj.Name)
        raise
    if FreeCAD.GuiUp:
        from .viewproviders.view_mesh import ViewMesherMesh

        ViewMesherMesh(obj.ViewObject)
    return obj


def _set_options(obj, is_faces, dimension=None, order=1, local_sizes=None, heal=False, **options):
    if dimension is not None or is_faces:
        obj.ElementDimension = "3D" if dimension == 3 else "2D"
    obj.ElementOrder = "2nd" if order == 2 else "1st"
    obj.LocalSizes = {entity: f"{float(size)!r} mm" for entity, size in (local_sizes or {}).items()}
    obj.HealShape = heal
    for option, value in options.items():
        if value is None:
            continue
        if option in _WORDS:
            name, words = _WORDS[option]
            setattr(obj, name, words(value))
        elif option in _FILES:
            if not isinstance(value, (str, os.PathLike)):
                raise TypeError(f"make_mesh() wants the path of a file for {option}: the object keeps it")
            setattr(obj, _FILES[option], os.fspath(value))
        else:
            setattr(obj, _PROPERTY_OF_OPTION[option], value)


def _part_and_names(source):
    if isinstance(source, list):
        if not source:
            raise ValueError("there is nothing to mesh in an empty list")
        parts_and_names = [_part_and_names(one) for one in source]
        if len(source) > 1 and any(names for _, names in parts_and_names):
            raise ValueError("faces are those of one object; several are meshed as wholes")
        return parts_and_names[0]
    if isinstance(source, tuple):
        part, names = source
        return part, list(names)
    if hasattr(source, "SubElementNames"):
        return source.Object, [name for name in source.SubElementNames if name.startswith("Face")]
    if not is_container(source) and not isinstance(getattr(source, "Shape", None), Part.Shape):
        raise TypeError(f"{getattr(source, 'Label', type(source).__name__)} has no shape that could be meshed")
    return source, []
