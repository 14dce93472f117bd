#pragma once

#include "base/result.h"

#include <exception>
#include <memory>
#include <string>
#include <utility>

namespace mesher {

/// What an OCCT exception in flight says, as an Error; to be called from a catch block only.
[[nodiscard]] Error errorOfException(const std::string& entity, const std::string& remedy);

/// Runs a step that calls OCCT and returns a Result; whatever it throws becomes an Error about the entity.
template <class Step>
[[nodiscard]] auto guarded(const std::string& entity, const std::string& remedy, Step&& step) -> decltype(step())
{
    try {
        return std::forward<Step>(step)();
    } catch (...) {
        return errorOfException(entity, remedy);
    }
}

/// Keeps OCCT's messages from the terminal while it lives: those to its messenger and those that old code writes to std::cout.
/// Both exist once per process, and its readers keep settings there too, so that only one of these lives at a time: another
/// thread waits.
class OcctSilence
{
public:
    OcctSilence();
    ~OcctSilence();
    OcctSilence(const OcctSilence&) = delete;
    OcctSilence& operator=(const OcctSilence&) = delete;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace mesher
