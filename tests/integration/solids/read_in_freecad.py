"""Run by freecadcmd for test_written_files.py: what FreeCAD's FEM reads of the files of a folder."""
import json
import os

import Fem

FOLDER = os.environ["MESHER_FOLDER"]


def volume_of(fem):
    nodes = fem.Nodes
    total = 0.0
    for element in fem.Volumes:
        a, b, c, d = (nodes[n] for n in fem.getElementNodes(element))
        total += abs((b - a).cross(c - a).dot(d - a)) / 6.0
    return total


answers = {}
for name in ("m.unv", "m.inp", "m.vtk"):
    fem = Fem.read(os.path.join(FOLDER, name))
    answers[name] = {"nodes": fem.NodeCount, "volumes": fem.VolumeCount, "volume": volume_of(fem),
                     "groups": [fem.getGroupName(group) for group in fem.Groups]}
with open(os.path.join(FOLDER, "answer.json"), "w", encoding="utf-8") as file:
    json.dump(answers, file)
