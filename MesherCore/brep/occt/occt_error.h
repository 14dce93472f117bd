#pragma once

#include "base/result.h"
#include "brep/geometry_failure.h"

#include <exception>
#include <memory>
#include <streambuf>
#include <string>
#include <utility>

namespace mesher {

/// What an OCCT exception in flight says, as an Error; to be called from a catch block only.
[[nodiscard]] Error errorOfException(const std::string& entity, const std::string& remedy);

/// Runs a step that calls OCCT and returns a Result; whatever it throws becomes an Error about the entity.
template <class Step>
[[nodiscard]] auto guarded(const std::string& entity, const std::string& remedy, Step&& step)
    -> decltype(step())
{
    try {
        return std::forward<Step>(step)();
    } catch (...) {
        return errorOfException(entity, remedy);
    }
}

/// What an OCCT exception in flight says; to be called from a catch block only.
[[noreturn]] void throwAsGeometryFailure(const std::string& entity);

/// Asks OCCT about the geometry of an entity of a model; what it throws becomes a GeometryFailure that names the entity.
template <class Question>
[[nodiscard]] auto asked(const std::string& entity, Question&& question) -> decltype(question())
{
    try {
        return std::forward<Question>(question)();
    } catch (...) {
        throwAsGeometryFailure(entity);
    }
}

/// Keeps OCCT's messages to its messenger from the terminal while it lives. The messenger exists once per process, and OCCT's
/// readers keep settings there too, so that only one of these lives at a time: another thread waits.
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

/// Keeps from the terminal what OCCT's reader of BREP texts writes to std::cout about damaged files ("Not a Curve table"): it
/// takes neither another stream nor a switch, and where a file is damaged is known to it only. While this lives, what other
/// threads write to std::cout is lost, which is why it is made for that reader alone.
/// Requires     a living OcctSilence, so that there is one of these at a time
class StandardOutputSilence
{
public:
    StandardOutputSilence();
    ~StandardOutputSilence();
    StandardOutputSilence(const StandardOutputSilence&) = delete;
    StandardOutputSilence& operator=(const StandardOutputSilence&) = delete;

private:
    class NullBuffer;
    std::unique_ptr<NullBuffer> nothing_;
    std::streambuf* output_;
};

}  // namespace mesher
