"""The mesh object of a document. Properties are named as those of FEM's own mesh objects where they mean the same."""

_DIMENSIONS = ["From Shape", "2D", "3D"]
_ORDERS = ["1st", "2nd"]
_OVERLAPS = ["separate", "refuse"]
_MEASURES = ["q2", "q1", "q3", "q4", "q5", "q6", "q7", "q8"]  # the first one is the default

# type, name, group, what it means, default; links are global because a part may be inside of a body
_PROPERTIES = (
    ("App::PropertyLinkGlobal", "Part", "FEM Mesh", "Object whose exact shape is meshed", None),
    ("App::PropertyLinkGlobal", "Shape", "FEM Mesh", "The Part, as FEM calls it from FreeCAD 1.0 on", None),
    ("App::PropertyLinkListGlobal", "Containers", "FEM Mesh", "Objects through which parts are seen where they are meshed", None),
    ("App::PropertyStringList", "ContainerPaths", "FEM Mesh", "From each of them to what is meshed: Group.Box.", None),
    ("App::PropertyLinkSubListGlobal", "References", "FEM Mesh", "Faces to mesh; without any, the whole part", None),
    ("App::PropertyLength", "CharacteristicLengthMax", "FEM Mesh", "Mean edge on surfaces where nothing asks for less; 0 is no limit", 0.0),
    ("App::PropertyLength", "CharacteristicLengthMin", "FEM Mesh", "Smallest size of elements; 0 is no limit", 0.0),
    ("App::PropertyEnumeration", "ElementDimension", "FEM Mesh", "Faces or solids", _DIMENSIONS),
    ("App::PropertyEnumeration", "ElementOrder", "FEM Mesh", "Order of the elements", _ORDERS),
    ("App::PropertyInteger", "MeshSizeFromCurvature", "FEM Mesh", "Elements in a full turn; 0 is off", 0),
    ("App::PropertyLength", "SurfaceDeviation", "FEM Mesh", "Largest distance of edges from the shape; 0 is off", 0.0),
    ("App::PropertyFloat", "Refinement", "FEM Mesh", "R: boundary size is local feature size / R; 0 is off", 0.0),
    ("App::PropertyFloat", "Grading", "FEM Mesh", "G: sizes grow by at most distance / G", 1.0),
    ("App::PropertyBool", "OptimizeStd", "FEM Mesh", "Improve the mesh after it is refined", True),
    ("App::PropertyInteger", "Threads", "FEM Mesh", "Threads to use; the mesh does not depend on them", 1),
    ("App::PropertyMap", "LocalSizes", "FEM Mesh", "Sizes of solids, faces, edges and vertices: Face6 is 0.5 mm", None),
    ("App::PropertyLinkListGlobal", "MeshRegionList", "FEM Mesh", "Regions with sizes of their own", None),
    ("App::PropertyStringList", "SizeDistances", "Sizes", "Face6=SIZE,GROWTH[,PLATEAU]: by the distance from it", None),
    ("App::PropertyStringList", "SizeBoxes", "Sizes", "X0,Y0,Z0,X1,Y1,Z1=SIZE[,GROWTH]: in a box", None),
    ("App::PropertyStringList", "SizeBalls", "Sizes", "X,Y,Z,RADIUS=SIZE[,GROWTH]: in a ball", None),
    ("App::PropertyString", "SizeFormula", "Sizes", "Size by x, y, z: 0.1 + 0.05*x", ""),
    ("App::PropertyFile", "SizePoints", "Sizes", "Text file with lines x y z size", ""),
    ("App::PropertyFile", "BackgroundMesh", "Sizes", "Mesh with a size at each node", ""),
    ("App::PropertyEnumeration", "QualityMeasure", "Quality", "Of tetrahedra", _MEASURES),
    ("App::PropertyFloat", "QualityThreshold", "Quality", "Score below which tetrahedra are refined; 0 is the usual", 0.0),
    ("App::PropertyFloat", "MaxDihedral", "Quality", "Dihedral angle above which tetrahedra are refined; 0 is the usual", 0.0),
    ("App::PropertyFloat", "QualityLambda", "Quality", "How far below the sizes around them bad tetrahedra may be refined; 0 is the usual",
     0.0),
    ("App::PropertyFloat", "MinAngle", "Quality", "Smallest angle wanted of triangles, degrees", 30.0),
    ("App::PropertyFloat", "MaxTurn", "Quality", "Largest turn of a curve along an edge, degrees", 90.0),
    ("App::PropertyEnumeration", "Overlap", "Run", "Solids that overlap: each for itself, or refused", _OVERLAPS),
    ("App::PropertyBool", "HealShape", "Run", "Let the CAD kernel repair the shape first", False),
    ("App::PropertyBool", "CheckMesh", "Run", "Check the mesh as a whole before it is taken over", False),
    ("App::PropertyInteger", "MaxElements", "Run", "The run ends there", 50_000_000),
    ("App::PropertyInteger", "MaxWallElements", "Run", "That thin walls, gaps and cusps may take; -1 is about as many as the sizes ask for", -1),
    ("App::PropertyFloat", "Timeout", "Run", "Seconds after which the run ends; 0 is no limit", 0.0),
    ("App::PropertyString", "Report", "Result", "What the last run did, as JSON", ""),
    ("App::PropertyBool", "IsStale", "Result", "Whether the shape has changed since it was meshed", False),
    ("App::PropertyString", "ShapeHash", "Result", "Of the shape that was meshed", ""),
    ("App::PropertyInteger", "NodeCount", "Result", "Nodes of the mesh", 0),
    ("App::PropertyInteger", "ElementCount", "Result", "Elements of highest dimension", 0),
    ("App::PropertyFloat", "SmallestAngle", "Result", "Degrees; dihedral in solids", 0.0),
    ("App::PropertyFloat", "LargestAngle", "Result", "Degrees; dihedral in solids", 0.0),
)
_SAME = {"Part": "Shape", "Shape": "Part"}
_RESULTS = ("IsStale", "Report", "ShapeHash", "NodeCount", "ElementCount", "SmallestAngle", "LargestAngle")


class MesherMesh:
    """Proxy of a Fem::FemMeshObjectPython."""

    Type = "Mesher::Mesh"

    def __init__(self, obj):
        obj.Proxy = self
        add_properties(obj)

    def onDocumentRestored(self, obj):
        is_touched = "Touched" in obj.State
        add_properties(obj)
        if not is_touched:
            obj.purgeTouched()

    def onChanged(self, obj, name):
        other = _SAME.get(name)
        if other in obj.PropertiesList and getattr(obj, other) != getattr(obj, name):
            setattr(obj, other, getattr(obj, name))

    def execute(self, obj):
        # Meshing is asked for by a command, as with FEM's own mesh objects: a recompute must not take minutes.
        import FreeCAD

        from ..tools.meshed_shape import differs_from_mesh

        is_stale = differs_from_mesh(obj)
        if is_stale and not obj.IsStale:
            FreeCAD.Console.PrintWarning(f"{obj.Label}: its shape has changed since it was meshed; mesh it again.\n")
        if is_stale != obj.IsStale:
            obj.IsStale = is_stale

    def __getstate__(self):
        return None

    def __setstate__(self, state):
        return None

    dumps = __getstate__
    loads = __setstate__


def is_mesh_object(obj):
    return getattr(getattr(obj, "Proxy", None), "Type", None) == MesherMesh.Type


def add_properties(obj):
    """Adds those that a new object, or one saved by an older version, has not."""
    for kind, name, group, text, default in _PROPERTIES:
        if name in obj.PropertiesList:
            continue
        obj.addProperty(kind, name, group, text)
        if default is not None:
            setattr(obj, name, default)
    if obj.Shape is None and obj.Part is not None:
        obj.Shape = obj.Part
    obj.setEditorMode("Shape", 2)
    for name in _RESULTS:
        obj.setEditorMode(name, 2 if name in ("Report", "ShapeHash") else 1)
