#include "brep/occt/occt_error.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>
#include <Standard_Type.hxx>

#include <mutex>
#include <new>

namespace mesher {

namespace {

std::mutex& occtMutex()
{
    static std::mutex mutex;
    return mutex;
}

}  // namespace

Error errorOfException(const std::string& entity, const std::string& remedy)
{
    std::string reason;
    try {
        throw;
    } catch (const Standard_Failure& failure) {
        reason = failure.DynamicType()->Name();
        const char* text = failure.GetMessageString();
        if (text != nullptr && *text != '\0') reason += std::string(": ") + text;
    } catch (const std::bad_alloc&) {
        reason = "out of memory";
    } catch (const std::exception& exception) {
        reason = exception.what();
    } catch (...) {
        reason = "an unknown failure";
    }
    return Error{ErrorCode::Unreadable, "the CAD kernel gave up (" + reason + ")", entity, {}, remedy};
}

struct OcctSilence::State
{
    std::unique_lock<std::mutex> lock{occtMutex()};
    Message_SequenceOfPrinters printers;
};

OcctSilence::OcctSilence() : state_(std::make_unique<State>())
{
    Message_SequenceOfPrinters& printers = Message::DefaultMessenger()->ChangePrinters();
    state_->printers = printers;
    printers.Clear();
}

OcctSilence::~OcctSilence()
{
    Message::DefaultMessenger()->ChangePrinters() = state_->printers;
}

}  // namespace mesher
