import FreeCAD

FreeCAD.__unit_test__ += ["TestMesherApp"]
