"""From a mesh object's properties to its mesh. Reading and filling in the document belong to the main thread; `run` and
`estimate` between them may be on any."""
import json
import re
import threading
import warnings

import FreeCAD

import mesher

from . import size_words
from .mesh_draft import MeshDraft
from .meshed_shape import meshed_shape, pieces_of
from .shape_hash import hash_of

# They are in the report, and told with it in words of the document.
warnings.filterwarnings("ignore", category=mesher.MesherWarning, module=__name__)

# The stage of a run in which the interpreter is not free: FreeCAD reads the mesh.
HANDING_OVER = "handing the mesh to FreeCAD"


class MeshTool:
    """One run of the mesher for one mesh object; `values` are in place of those of its properties. `known` is a tool that may have read
    the shape before."""

    def __init__(self, obj, values=None, known=None):
        self._obj = obj
        obj = MeshDraft(obj, values or {})
        pieces = pieces_of(obj)
        self._key = obj.HealShape, obj.References, [(piece.place, piece.shape.hashCode()) for piece in pieces]
        is_known = known is not None and known._key == self._key
        self._shape = known._shape if is_known else meshed_shape(obj, pieces)
        self._read = known._read if is_known else _ModelOnce(self._shape.shape, obj.HealShape)
        self._names = self._shape.names
        self._hash = ""
        self._ready = None, None
        self._options = options_of(obj, self._shape)

    def run(self, progress=None):
        """The mesh; raises what mesher.mesh raises. It is made ready for the document as well, which takes its time."""
        mesh = mesher.mesh(self._read.model(), progress=progress, **self._options)
        self._hash = hash_of(self._shape.whole)
        if progress is None or progress(HANDING_OVER, 1.0):
            self._ready = mesh, mesh.to_fem_mesh(names=self._names)
        return mesh

    def estimate(self, progress=None):
        """What a run is going to take; raises what mesher.estimate raises."""
        return mesher.estimate(self._read.model(), progress=progress, **self._options)

    @property
    def is_volume(self):
        return self._options["dimension"] == 3

    def name_in_part(self, entity):
        """What the part calls an entity that the mesher names."""
        return self._names.get(entity, entity)

    def place_of(self, entity):
        """Where an entity that the mesher names is seen, and what it is called there."""
        return self._shape.place_of(self.name_in_part(entity))

    def _in_part(self, text):
        return re.sub(r"\b(?:Vertex|Edge|Face|Solid)\d+\b", lambda name: self.name_in_part(name[0]), text)

    def _place_in_part(self, place):
        return {**place, "entities": [self.name_in_part(entity) for entity in place["entities"]], "reason": self._in_part(place["reason"])}

    def fill_in(self, mesh):
        obj = self._obj
        # It is made where its shape is seen.
        obj.Placement = FreeCAD.Placement()
        ready, fem_mesh = self._ready
        obj.FemMesh = fem_mesh if ready is mesh else mesh.to_fem_mesh(names=self._names)
        self._ready = None, None
        quality = mesh.quality()
        is_volume = len(mesh.tets) > 0
        obj.NodeCount = len(mesh.nodes)
        obj.ElementCount = len(mesh.tets) if is_volume else len(mesh.triangles)
        obj.SmallestAngle = quality["min_dihedral" if is_volume else "min_angle"]
        obj.LargestAngle = quality["max_dihedral" if is_volume else "max_angle"]
        report = {**mesh.report, "warnings": [self._in_part(text) for text in mesh.report["warnings"]]}
        report["left"] = {**report["left"], "places": [self._place_in_part(place) for place in report["left"]["places"]]}
        obj.Report = json.dumps(report)
        for text in report["warnings"]:
            FreeCAD.Console.PrintWarning(f"{obj.Label}: {text}\n")
        kind = "tetrahedra" if is_volume else "triangles"
        FreeCAD.Console.PrintMessage(f"{obj.Label}: {obj.ElementCount} {kind}, {obj.NodeCount} nodes, angles from {obj.SmallestAngle:.2f} "
                                     f"to {obj.LargestAngle:.2f} degrees\n")
        obj.ShapeHash = self._hash or hash_of(self._shape.whole)
        obj.IsStale = False
        obj.purgeTouched()


class _ModelOnce:
    """The mesher's model of a shape, read by the first thread that needs it."""

    def __init__(self, shape, heal):
        self._shape, self._heal = shape, heal
        self._lock = threading.Lock()
        self._model = None

    def model(self):
        with self._lock:
            if self._model is None:
                self._model = mesher.model_of(self._shape, self._heal)
            return self._model


def options_of(obj, shape):
    """The options of mesher.mesh that the properties stand for."""
    is_volume = obj.ElementDimension == "3D" or (obj.ElementDimension == "From Shape" and bool(shape.shape.Solids))
    return {
        "dimension": 3 if is_volume else 2,
        "size": obj.CharacteristicLengthMax.Value or None,
        "min_size": obj.CharacteristicLengthMin.Value or None,
        "curvature": float(obj.MeshSizeFromCurvature),
        "sag": obj.SurfaceDeviation.Value,
        "refinement": obj.Refinement or None,
        "grading": obj.Grading,
        "improve": obj.OptimizeStd,
        "order": 2 if obj.ElementOrder == "2nd" else 1,
        "threads": obj.Threads,
        "local_sizes": {shape.name_of(name): size for name, size in local_sizes_of(obj).items()},
        "size_distance": {shape.name_of(name): wish for name, wish in size_words.distances_in(obj.SizeDistances).items()},
        "size_box": size_words.boxes_in(obj.SizeBoxes),
        "size_ball": size_words.balls_in(obj.SizeBalls),
        "size_formula": obj.SizeFormula or None,
        "size_points": obj.SizePoints or None,
        "background": obj.BackgroundMesh or None,
        "measure": obj.QualityMeasure,
        "threshold": obj.QualityThreshold or None,
        "max_dihedral": obj.MaxDihedral or None,
        "lambda_": obj.QualityLambda or None,
        "min_angle": obj.MinAngle,
        "max_turn": obj.MaxTurn,
        "overlap": obj.Overlap,
        "check": obj.CheckMesh,
        "max_elements": obj.MaxElements,
        "max_wall_elements": obj.MaxWallElements if obj.MaxWallElements >= 0 else None,
        "timeout": obj.Timeout or None,
    }


def local_sizes_of(obj):
    """Millimetres by names of the part: those of the mesh object, and of FEM's mesh regions."""
    sizes = {name: FreeCAD.Units.Quantity(length).Value for name, length in obj.LocalSizes.items()}
    for region in obj.MeshRegionList:
        length = region.CharacteristicLength.Value
        for _, names in region.References:
            for name in names:
                sizes[name] = min(length, sizes.get(name, length))
    return sizes
