#pragma once

#include "brep/occt/exchange/read_file.h"

#include <IFSelect_ReturnStatus.hxx>

namespace mesher {

[[nodiscard]] inline std::string reasonOf(IFSelect_ReturnStatus status)
{
    switch (status) {
        case IFSelect_RetVoid: return "it has no content";
        case IFSelect_RetError: return "it is no valid file of its format";
        case IFSelect_RetFail: return "its entities cannot be read";
        case IFSelect_RetStop: return "reading was stopped";
        default: return "unknown status";
    }
}

/// The shapes of a file that one of the kernel's readers has read.
template <class Reader>
[[nodiscard]] Result<TopoDS_Shape> transfer(Reader& reader, const std::string& name)
{
    if (reader.TransferRoots() == 0)
        return unreadableFile(name, "nothing in it is a shape", "export solids, shells or faces");
    TopoDS_Shape shape = reader.OneShape();
    if (shape.IsNull()) return unreadableFile(name, "its shape is null");
    return shape;
}

}  // namespace mesher
