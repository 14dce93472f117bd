"""From a mesh object's properties to its mesh. Reading and filling in the document belong to the main thread; `run` between
them may be on any."""
import json

import mesher


class MeshTool:
    """One run of the mesher for one mesh object."""

    def __init__(self, obj):
        self._obj = obj
        shape, self._face_names = _shape_of(obj)
        self._model = mesher.model_of(shape)
        self._options = _options_of(obj, shape)

    def run(self, progress=None):
        """The mesh; raises what mesher.mesh raises."""
        return mesher.mesh(self._model, progress=progress, **self._options)

    def fill_in(self, mesh):
        obj = self._obj
        obj.FemMesh = mesh.to_fem_mesh(names=self._face_names)
        quality = mesh.quality()
        is_volume = len(mesh.tets) > 0
        obj.NodeCount = len(mesh.nodes)
        obj.ElementCount = len(mesh.tets) if is_volume else len(mesh.triangles)
        obj.SmallestAngle = quality["min_dihedral" if is_volume else "min_angle"]
        obj.LargestAngle = quality["max_dihedral" if is_volume else "max_angle"]
        obj.Report = json.dumps(mesh.report)
        obj.purgeTouched()


def _shape_of(obj):
    """The shape to mesh, and what its entities are called in the part where that differs."""
    import Part

    if obj.Part is None:
        raise _refusal(obj, "the mesh has no part", "choose the object to mesh as its Part")
    shape = obj.Part.Shape
    if shape.isNull():
        raise _refusal(obj.Part, "the shape is empty", "recompute the document or choose another object")
    names = [name for _, subs in obj.References for name in subs if name]
    if names:
        others = [name for name in names if not name.startswith("Face")]
        if others:
            raise _refusal(obj, f"{others[0]} is no face", "select faces only")
        faces = [shape.getElement(name) for name in names]
        return Part.makeCompound(faces), {f"Face{i}": name for i, name in enumerate(names, 1)}
    if not shape.Faces and shape.Wires:
        try:
            return Part.makeFace(shape.Wires, "Part::FaceMakerBullseye"), {}
        except Exception as error:
            raise _refusal(obj.Part, f"its wires bound no plane face ({error})",
                           "close the wires and take away crossings") from error
    return shape, {}


def _options_of(obj, shape):
    is_volume = obj.ElementDimension == "3D" or (obj.ElementDimension == "From Shape" and bool(shape.Solids))
    return {
        "dimension": 3 if is_volume else 2,
        "size": obj.CharacteristicLengthMax.Value or None,
        "min_size": obj.CharacteristicLengthMin.Value or None,
        "curvature": float(obj.MeshSizeFromCurvature),
        "sag": obj.SurfaceDeviation.Value,
        "refinement": obj.Refinement,
        "grading": obj.Grading,
        "improve": obj.OptimizeStd,
        "order": 2 if obj.ElementOrder == "2nd" else 1,
        "threads": obj.Threads,
        "local_sizes": _local_sizes_of(obj),
    }


def _local_sizes_of(obj):
    sizes = {}
    for region in obj.MeshRegionList:
        length = region.CharacteristicLength.Value
        for _, names in region.References:
            for name in names:
                sizes[name] = min(length, sizes.get(name, length))
    return sizes


def _refusal(obj, reason, remedy):
    failure = {"entity": obj.Label, "point": None, "reason": reason, "remedy": remedy}
    return mesher.ModelError(f"{obj.Label}: {reason}; {remedy}.", [failure])
