"""A mesh object with other values of some properties, as a panel shows them: what a run and an estimate read."""


class MeshDraft:
    def __init__(self, obj, values):
        self._obj = obj
        self._values = values

    def __getattr__(self, name):
        values = self.__dict__["_values"]
        return values[name] if name in values else getattr(self.__dict__["_obj"], name)
