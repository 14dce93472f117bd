import FreeCAD

FreeCAD.__unit_test__ += ["TestMesherApp"]


def _register_export():
    from MesherWorkbench.exporter import FILE_TYPES

    for kind in FILE_TYPES:
        FreeCAD.addExportType("Mesher: " + kind, "MesherWorkbench.exporter")


_register_export()
