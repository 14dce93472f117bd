import mesher_addon

exec(mesher_addon.code_of("InitGui.py"))
