#pragma once

#include "base/result.h"
#include "brep/brep_model.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>

class TopoDS_Shape;

namespace mesher {

struct ReadOptions
{
    /// Let the kernel repair the shape (ShapeFix) before it is looked at; the model's notes say what changed. DEFAULT: false,
    /// the shape stays as the file has it, up to what the STEP and IGES readers do on their own.
    bool heals = false;
    /// Read a file in a process of its own first, which tells of files on which the kernel crashes. Takes the time of reading once more;
    /// for those to leave out whose own end by a signal somebody is waiting for, and for shapes that the kernel itself has just written.
    bool isTried = true;
};

/// A model beside the kernel's shape that it was made from, which file writers and checks may want.
struct ReadModel
{
    BrepModel model;
    std::shared_ptr<const TopoDS_Shape> shape;
    std::string format;    ///< "STEP", "IGES", "BREP text", "BREP binary"
    std::string fileUnit;  ///< as the file states it, "" if it does not; the model is in millimetres
};

/// Reads STEP, IGES, BREP text and BREP binary, of OCCT or of FreeCAD's exportBinary, told apart by their content.
///
/// Guarantees   nothing that the CAD kernel throws or prints gets out; lengths of STEP and IGES come in millimetres, those of
///              BREP, which has no unit, as they are
/// Requires     a file that is there, whole and has faces; else one Error that names the file and the remedy
/// Threads      any; files are read one after the other, as the kernel's readers have settings per process
[[nodiscard]] Result<ReadModel> readModel(const std::filesystem::path& path, const ReadOptions& options = {});

/// The same from memory; not IGES, which the kernel reads from files only. `name` is what errors call it.
[[nodiscard]] Result<ReadModel> readModelFromMemory(std::span<const std::byte> content,
                                                    const std::string& name, const ReadOptions& options = {});

/// From the kernel's own shape, e.g. one made in memory.
[[nodiscard]] Result<ReadModel> readModelFromShape(const TopoDS_Shape& shape,
                                                   const ReadOptions& options = {});

}  // namespace mesher
