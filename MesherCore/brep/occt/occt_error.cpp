#include "brep/occt/occt_error.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>
#include <Standard_Type.hxx>

#include <iostream>
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
        if (text != nullptr && *text != '\0') reason.append(": ").append(text);
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

OcctSilence::~OcctSilence() { Message::DefaultMessenger()->ChangePrinters() = state_->printers; }

/// Swallows what is written to it.
class StandardOutputSilence::NullBuffer final : public std::streambuf
{
protected:
    int_type overflow(int_type c) override { return traits_type::not_eof(c); }
    std::streamsize xsputn(const char*, std::streamsize count) override { return count; }
};

StandardOutputSilence::StandardOutputSilence()
    : nothing_(std::make_unique<NullBuffer>()), output_(std::cout.rdbuf(nothing_.get()))
{
}

StandardOutputSilence::~StandardOutputSilence() { std::cout.rdbuf(output_); }

}  // namespace mesher
