"""Triangles in the view of an object, beside what FreeCAD draws there: in the scene alone, and in no document."""
from pivy import coin

_LINE_COLOUR = (0.1, 0.1, 0.1)


def zoom_to(view3d, point, reach):
    """Brings what is within `reach` of a point into the middle of the view."""
    low, high = ([coordinate + sign * reach for coordinate in point] for sign in (-1.0, 1.0))
    region = view3d.getViewer().getSoRenderManager().getViewportRegion()
    view3d.getCameraNode().viewBoundingBox(coin.SbBox3f(*low, *high), region.getViewportAspectRatio(), 1.0)


class SceneMesh:
    """Flat triangles with their edges; `in_front` draws them over all else."""

    def __init__(self, view, name, colour, in_front=False):
        # The view itself may be gone before its nodes are.
        self._root = view.RootNode
        self._colour = colour
        self._node = coin.SoAnnotation() if in_front else coin.SoSeparator()
        self._node.setName(name)
        # Before the placement of the object, which the nodes of its mesh have already.
        self._root.insertChild(self._node, 0)

    def show(self, points, triangles):
        """In place of those before; none for None."""
        self._node.removeAllChildren()
        if triangles is None or not len(triangles):
            return
        coordinates = coin.SoCoordinate3()
        coordinates.point.setValues(0, len(points), points.tolist())
        self._node.addChild(coordinates)
        self._add_faces(triangles)
        self._add_lines(triangles)

    def leave(self):
        self._root.removeChild(self._node)

    def zoom(self, view3d):
        """Brings what is shown into the middle of the view, as large as it goes."""
        region = view3d.getViewer().getSoRenderManager().getViewportRegion()
        view3d.getCameraNode().viewAll(self._node, region, 4.0)

    def _add_faces(self, triangles):
        material = coin.SoMaterial()
        material.diffuseColor = self._colour
        hints = coin.SoShapeHints()
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        offset = coin.SoPolygonOffset()
        faces = coin.SoIndexedFaceSet()
        indices = [index for corners in triangles.tolist() for index in (*corners, -1)]
        faces.coordIndex.setValues(0, len(indices), indices)
        for node in (material, hints, offset, faces):
            self._node.addChild(node)

    def _add_lines(self, triangles):
        look = coin.SoBaseColor()
        look.rgb = _LINE_COLOUR
        model = coin.SoLightModel()
        model.model = coin.SoLightModel.BASE_COLOR
        lines = coin.SoIndexedLineSet()
        indices = [index for a, b, c in triangles.tolist() for index in (a, b, c, a, -1)]
        lines.coordIndex.setValues(0, len(indices), indices)
        for node in (model, look, lines):
            self._node.addChild(node)


class SceneVisibility:
    """Hides what FreeCAD draws of an object, without a change of its properties."""

    def __init__(self, view):
        self._switch = next(child for child in view.RootNode.getChildren() if child.isOfType(coin.SoSwitch.getClassTypeId()))
        self._shown = self._switch.whichChild.getValue()

    def hide(self, is_hidden):
        self._switch.whichChild = -1 if is_hidden else self._shown
