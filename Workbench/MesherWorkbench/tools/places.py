"""Where parts are seen: objects by themselves, or through containers, links and assemblies, whose placements they have there."""
import re
from collections import namedtuple

import Part

_ELEMENT = re.compile(r"(?:Face|Edge|Vertex|Solid)\d+$")

# `top` is an object of the document, `path` leads from there to the object that is meant, as "Group.Box."; empty if it is `top`.
Place = namedtuple("Place", "top path")
# What is seen at a place: the object there, and its shape where it is seen.
Piece = namedtuple("Piece", "place obj shape")


def place_of(top, sub):
    """The place of what was clicked on, and the name of its element. A feature at the tip of a body stands for the body."""
    element = (_ELEMENT.search(sub) or [""])[0]
    path = sub[:len(sub) - len(element)]
    obj = _object_at(top, path)
    body = obj.getParentGeoFeatureGroup() if path else None
    if getattr(body, "Tip", None) == obj:
        path = path[:path[:-1].rfind(".") + 1]
    return Place(top, path), element


def place_in_containers(obj):
    """Of an object that is meant by itself, where its containers have it; a container is a place of its own."""
    for top, path in getattr(obj, "Parents", ()):
        if top.Document == obj.Document and not hasattr(top, "LinkedObject"):
            return Place(top, path)
    return Place(obj, "")


def object_at(place):
    """None where it is gone."""
    return _object_at(place.top, place.path)


def shown_by(place):
    """The object whose visibility is that of the place: where a link leads there, others may see the same object elsewhere."""
    chain = place.top.getSubObjectList(place.path) if place.path else [place.top]
    return place.top if any(hasattr(obj, "LinkedObject") for obj in chain) else chain[-1]


def pieces_at(place):
    """What is seen there, one by one."""
    if is_container(object_at(place)):
        return [piece for path in object_at(place).getSubObjects()
                for piece in pieces_at(Place(place.top, place.path + path))]
    shape = Part.getShape(place.top, place.path, needSubElement=False, transform=True)
    return [] if shape.isNull() else [Piece(place, object_at(place), shape)]


def piece_of(part):
    """Of an object that is meshed by itself, where its containers have it."""
    shape = Part.getShape(part, "", needSubElement=False)
    where = part.getGlobalPlacement() if hasattr(part, "getGlobalPlacement") else part.Placement
    if where != part.Placement:
        # Of another place, but of the same faces: what was read of these holds.
        shape.Placement = where
    return Piece(Place(part, ""), part, shape)


def name_at(place, element):
    """What an element of one of several pieces is called."""
    return f"{place.top.Name}.{place.path}{element}"


def _object_at(top, path):
    return top.getSubObject(path, retType=1) if path else top


def is_container(obj):
    """Bodies and compounds have a shape of their own."""
    linked = obj.getLinkedObject() if hasattr(obj, "getLinkedObject") else obj
    return linked.isDerivedFrom("App::Part") or linked.TypeId == "App::DocumentObjectGroup" or linked.TypeId == "App::LinkGroup"
