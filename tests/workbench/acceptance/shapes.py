"""Solids that the tests build in FreeCAD."""
import FreeCAD
import Part

_Vector = FreeCAD.Vector


def box():
    return Part.makeBox(10, 20, 30)


def cylinder():
    return Part.makeCylinder(5, 20)


def plate_with_hole(radius=10):
    return Part.makeBox(100, 50, 5).cut(Part.makeCylinder(radius, 5, _Vector(50, 25, 0)))


def box_without_a_ball():
    return Part.makeBox(20, 20, 20).cut(Part.makeSphere(8, _Vector(20, 20, 20)))


def torus():
    return Part.makeTorus(10, 3)


def frustum():
    return Part.makeCone(10, 4, 15)


def rounded_box():
    block = Part.makeBox(20, 15, 10)
    return block.makeFillet(2, block.Edges)


def loft():
    """From a circle to a square."""
    corners = [_Vector(x, y, 20) for x, y in ((-5, -5), (5, -5), (5, 5), (-5, 5), (-5, -5))]
    return Part.makeLoft([Part.Wire(Part.makeCircle(8)), Part.makePolygon(corners)], True)


def two_solids():
    """That share a face."""
    return Part.makeBox(10, 10, 10).generalFuse([Part.makeBox(10, 10, 6, _Vector(10, 0, 0))])[0]


def placed(shape):
    """Where no coordinate is a round number."""
    shape.Placement = FreeCAD.Placement(_Vector(31.7, -11.3, 7.9), FreeCAD.Rotation(_Vector(1, 2, 3), 37.3))
    return shape


ALL = {
    "box": box,
    "cylinder": cylinder,
    "plate with a hole": plate_with_hole,
    "box without a ball": box_without_a_ball,
    "torus": torus,
    "frustum": frustum,
    "rounded box": rounded_box,
    "loft": loft,
    "two solids": two_solids,
    "cylinder, placed": lambda: placed(cylinder()),
    "rounded box, placed": lambda: placed(rounded_box()),
}
