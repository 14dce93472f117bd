#include "pipeline/stage_failure.h"

#include "brep/geometry_failure.h"

#include <exception>
#include <new>
#include <stdexcept>

namespace mesher {

namespace {

Error outOfMemory(const std::string& during)
{
    return {ErrorCode::OutOfRange,
            "the memory does not suffice" + during,
            "model",
            {},
            "choose a larger --size or a machine with more memory"};
}

}  // namespace

Error errorInFlight(const std::string& stage)
{
    const std::string during = stage.empty() ? "" : ", in the stage '" + stage + "'";
    try {
        throw;
    } catch (const GeometryFailure& failure) {
        return {ErrorCode::DegenerateInput,
                failure.what() + during,
                failure.entity(),
                {},
                "repair the shape in the CAD program or read it with healing"};
    } catch (const std::bad_alloc&) {
        return outOfMemory(during);
    } catch (const std::length_error&) {
        return outOfMemory(during);
    } catch (const std::exception& exception) {
        return {ErrorCode::DegenerateInput,
                std::string("the run failed (") + exception.what() + ")" + during,
                "model",
                {},
                "report this model as a fault of the mesher"};
    } catch (...) {
        return {ErrorCode::DegenerateInput,
                "the run failed for a reason unknown to it" + during,
                "model",
                {},
                "report this model as a fault of the mesher"};
    }
}

}  // namespace mesher
