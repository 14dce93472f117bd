#include "brep/occt/exchange_module.h"

#include <dlfcn.h>

#include <array>
#include <filesystem>
#include <system_error>

namespace mesher {

namespace {

/// Where the modules are, seen from the program and from the extension module of Python, each as built and as installed.
constexpr std::array<const char*, 3> kFolders = {"../lib/mesher", "../../../lib/mesher", "../../.."};

Error notThere(const std::string& module, std::string reason)
{
    return Error{ErrorCode::Unreadable, std::move(reason), module, {}, "install Mesher again"};
}

/// The folder of the program or of the library that this function is a part of, links resolved.
std::filesystem::path ownFolder()
{
    Dl_info info{};
    if (dladdr(reinterpret_cast<void*>(&loadStepReader), &info) == 0) return {};
    std::error_code code;
    // The name of a program is what it was called by.
    std::filesystem::path own = std::filesystem::canonical("/proc/self/exe", code);
    const std::filesystem::path named = std::filesystem::canonical(info.dli_fname, code);
    if (!code && named.extension() == ".so") own = named;
    return own.parent_path();
}

Result<std::filesystem::path> findModule(const std::string& module)
{
    const std::filesystem::path own = ownFolder();
    for (const char* folder : kFolders) {
        std::error_code code;
        const std::filesystem::path path = std::filesystem::canonical(own / folder / module, code);
        if (!code) return path;
    }
    return notThere(module, "the module that reads this format is not beside the program");
}

Result<FileReader> load(const std::string& module)
{
    return findModule(module).andThen([&](const std::filesystem::path& path) -> Result<FileReader> {
        void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
        void* function = handle != nullptr ? dlsym(handle, kReadFile) : nullptr;
        if (function == nullptr) return notThere(path.string(), dlerror());
        return FileReader{reinterpret_cast<ReadFile>(function)};
    });
}

}  // namespace

Result<FileReader> loadStepReader() { return load("mesher_read_step.so"); }

Result<FileReader> loadIgesReader() { return load("mesher_read_iges.so"); }

}  // namespace mesher
