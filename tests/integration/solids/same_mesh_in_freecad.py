"""Run by freecadcmd for test_same_mesh.py: tetrahedra of the workbench's mesh of a shape, and of the package's mesh of the file."""
import hashlib
import json
import os
import sys

QUESTION = json.loads(os.environ["MESHER_QUESTION"])
sys.path.insert(0, QUESTION["modules"])

import FreeCAD  # noqa: E402
import Part  # noqa: E402

import mesher  # noqa: E402
from MesherWorkbench import make_mesh  # noqa: E402


def signature(tets):
    """Of places, whatever the order of the tetrahedra and of their corners."""
    lines = sorted(repr(sorted(tuple(place) for place in corners)) for corners in tets)
    return [len(lines), hashlib.sha256("\n".join(lines).encode()).hexdigest()]


answers = {}
for name, (path, options) in QUESTION["models"].items():
    document = FreeCAD.newDocument("SameMesh")
    feature = document.addObject("Part::Feature", "Shape")
    feature.Shape = Part.read(path)
    document.recompute()
    fem = make_mesh(feature, dimension=3, **options).FemMesh
    nodes = fem.Nodes
    in_document = [[tuple(nodes[node]) for node in fem.getElementNodes(tet)] for tet in fem.Volumes]
    mesh = mesher.mesh(path, **options)
    of_file = mesh.nodes[mesh.tets].tolist()
    answers[name] = [signature(in_document), signature(of_file)]
    FreeCAD.closeDocument(document.Name)
with open(QUESTION["answer"], "w", encoding="utf-8") as file:
    json.dump(answers, file)
