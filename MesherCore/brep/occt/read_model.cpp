#include "brep/occt/read_model.h"

#include "brep/face_sewing.h"
#include "brep/name_list.h"
#include "brep/occt/model_builder.h"
#include "brep/occt/model_format.h"
#include "brep/occt/occt_error.h"
#include "brep/occt/shape_reader.h"
#include "brep/occt/shape_repair.h"
#include "brep/occt/trial_process.h"
#include "brep/shell_closing.h"

#include <TopoDS_Shape.hxx>

#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

namespace mesher {

namespace {

Error unreadable(const std::string& name, std::string message, std::string remedy)
{
    return Error{ErrorCode::Unreadable, std::move(message), name, {}, std::move(remedy)};
}

Result<std::string> readBytes(const std::filesystem::path& path)
{
    const std::string name = path.string();
    std::error_code code;
    const std::filesystem::file_status status = std::filesystem::status(path, code);
    if (!std::filesystem::exists(status)) return unreadable(name, "there is no such file", "check the path");
    if (std::filesystem::is_directory(status))
        return unreadable(name, "it is a folder", "name a model file in it");
    if (!std::filesystem::is_regular_file(status))
        return unreadable(name, "it is no regular file", "name a model file");
    std::ifstream file(path, std::ios::binary);
    if (!file) return unreadable(name, "the file cannot be opened", "check its permissions");
    std::string content{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (file.bad()) return unreadable(name, "the file cannot be read to its end", "check the disk");
    if (content.empty()) return unreadable(name, "the file is empty", "export the model again");
    return content;
}

/// An error about an entity of a file says which file.
Error inFile(Error error, const std::string& name)
{
    if (name.empty() || error.entity == name) return error;
    error.entity = error.entity.empty() ? name : name + ", " + error.entity;
    return error;
}

Result<ReadModel> makeModel(TopoDS_Shape shape, const ReadOptions& options)
{
    std::vector<std::string> changes;
    if (options.heals) {
        Result<RepairedShape> repaired = repairShape(shape);
        if (!repaired) return repaired.error();
        shape = repaired->shape;
        changes = std::move(repaired->changes);
    }
    Result<BrepModel> model = buildModel(shape);
    if (!model) return model.error();
    const Result<void> joined = guarded("the model", "repair it in the CAD program", [&]() -> Result<void> {
        sewFaces(*model);
        closeShells(*model);
        return {};
    });
    if (!joined) return joined.error();
    model->notes.insert(model->notes.begin(), changes.begin(), changes.end());
    return ReadModel{*std::move(model), std::make_shared<const TopoDS_Shape>(std::move(shape)), "", ""};
}

Result<ReadModel> readFormat(ModelFormat format, const std::string& content, const std::string& name,
                             const ReadOptions& options)
{
    Result<ShapeFromFile> read = readShape(format, content, name);
    if (!read) return read.error();
    Result<ReadModel> model = makeModel(read->shape, options);
    if (!model) return inFile(model.error(), name);
    if (read->parts.size() > 1) {
        model->model.notes.push_back("the names of its parts are not kept, their solids are numbered: " +
                                     listOf(read->parts));
    }
    model->format = nameOf(format);
    model->fileUnit = read->unit;
    return model;
}

Result<ReadModel> readContent(const std::string& content, const std::string& name, bool isFile,
                              const ReadOptions& options)
{
    const std::optional<ModelFormat> format = recogniseFormat(content);
    if (!format) {
        return unreadable(name, "it is neither STEP nor IGES nor BREP",
                          "export the model in one of these formats");
    }
    if (const auto missing = findTruncation(*format, content)) {
        return unreadable(
            name, "the " + std::string(nameOf(*format)) + " file is truncated: " + std::string(*missing),
            "export or copy the model again");
    }
    if (*format == ModelFormat::Iges && !isFile) {
        return unreadable(name, "IGES is read from files only", "write it to a file first");
    }
    const Result<void> ready = prepareReader(*format);
    if (!ready) return ready.error();
    const OcctSilence silence;
    const auto read = [&] { return readFormat(*format, content, name, options); };
    if (options.isTried && !endsByItself([&] { static_cast<void>(read()); })) {
        return unreadable(
            name, "the " + std::string(nameOf(*format)) + " file is damaged: the CAD kernel fails on it",
            "export the model again");
    }
    return read();
}

}  // namespace

Result<ReadModel> readModel(const std::filesystem::path& path, const ReadOptions& options)
{
    return readBytes(path).andThen(
        [&](const std::string& content) { return readContent(content, path.string(), true, options); });
}

Result<ReadModel> readModelFromMemory(std::span<const std::byte> content, const std::string& name,
                                      const ReadOptions& options)
{
    if (content.empty()) return unreadable(name, "it is empty", "export the model again");
    const std::string text(reinterpret_cast<const char*>(content.data()), content.size());
    return readContent(text, name, false, options);
}

Result<ReadModel> readModelFromShape(const TopoDS_Shape& shape, const ReadOptions& options)
{
    const OcctSilence silence;
    return makeModel(shape, options);
}

}  // namespace mesher
