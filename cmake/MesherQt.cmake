# Sets MESHER_QT_FOUND to the major version of Qt that the widgets are built with, and finds it. Widgets of one version cannot live in
# a window of the other, and several may be installed: it has to be FreeCAD's own.
set(MESHER_QT "" CACHE STRING "Major version of Qt, 5 or 6; empty: that of the FreeCAD that is installed")

# mesher_qt_of_freecad(RESULT): the version that FreeCAD's library of widgets asks for; empty where there is no FreeCAD.
function(mesher_qt_of_freecad result)
  find_library(FREECAD_GUI_LIBRARY FreeCADGui
    PATHS /usr/lib /usr/local/lib /opt/freecad PATH_SUFFIXES freecad-python3/lib freecad/lib lib)
  set(${result} "" PARENT_SCOPE)
  if(FREECAD_GUI_LIBRARY)
    execute_process(COMMAND "${CMAKE_READELF}" --dynamic "${FREECAD_GUI_LIBRARY}" OUTPUT_VARIABLE needed COMMAND_ERROR_IS_FATAL ANY)
    if(needed MATCHES "\\[libQt([0-9]+)Widgets\\.so")
      set(${result} "${CMAKE_MATCH_1}" PARENT_SCOPE)
    endif()
  endif()
endfunction()

if(MESHER_QT)
  set(MESHER_QT_FOUND "${MESHER_QT}")
else()
  mesher_qt_of_freecad(MESHER_QT_FOUND)
endif()
if(NOT MESHER_QT_FOUND)
  find_package(QT NAMES Qt6 Qt5 QUIET REQUIRED COMPONENTS Widgets)
  set(MESHER_QT_FOUND "${QT_VERSION_MAJOR}")
  message(WARNING "FreeCAD was not found: the widgets are built with Qt ${MESHER_QT_FOUND}; -DMESHER_QT=5 or 6 chooses another")
endif()
find_package(Qt${MESHER_QT_FOUND} QUIET COMPONENTS Widgets)
if(NOT Qt${MESHER_QT_FOUND}_FOUND)
  message(FATAL_ERROR "FreeCAD uses Qt ${MESHER_QT_FOUND}, whose files for building are missing: "
    "install qtbase5-dev for Qt 5, qt6-base-dev for Qt 6, or leave the workbench out by -DMESHER_WITH_FREECAD=OFF")
endif()
message(STATUS "Widgets are built with Qt ${MESHER_QT_FOUND}")
