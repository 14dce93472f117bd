import FreeCADGui


class MesherWorkbench(FreeCADGui.Workbench):
    """Meshes of exact solids and faces."""

    def __init__(self):
        from MesherWorkbench import resources

        self.__class__.MenuText = "Mesher"
        self.__class__.ToolTip = "Delaunay meshes directly from exact CAD geometry"
        self.__class__.Icon = resources.icon("MesherWorkbench")

    def Initialize(self):
        from MesherWorkbench import commands, resources

        FreeCADGui.addIconPath(resources.icon_directory())
        names = commands.register()
        self.appendMenu("&Mesher", names)
        self.appendToolbar("Mesher", names)

    def GetClassName(self):
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(MesherWorkbench())
FreeCAD.__unit_test__ += ["TestMesherGui"]
