#include "brep/occt/occt_error.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>
#include <Standard_Type.hxx>

#include <cctype>
#include <iostream>
#include <mutex>
#include <new>
#include <string_view>

namespace mesher {

namespace {

std::mutex& occtMutex()
{
    static std::mutex mutex;
    return mutex;
}

/// In one line, without blanks at its ends.
std::string inOneLine(std::string_view text)
{
    std::string line;
    for (const char c : text) {
        const bool isBlank = c == ' ' || std::iscntrl(static_cast<unsigned char>(c)) != 0;
        if (!isBlank) {
            line += c;
        } else if (!line.empty() && line.back() != ' ') {
            line += ' ';
        }
    }
    while (!line.empty() && line.back() == ' ') line.pop_back();
    return line;
}

/// Of the exception in flight.
std::string reasonInFlight()
{
    std::string reason;
    try {
        throw;
    } catch (const Standard_Failure& failure) {
        reason = failure.DynamicType()->Name();
        const char* message = failure.GetMessageString();
        const std::string text = inOneLine(message == nullptr ? "" : message);
        if (!text.empty()) reason.append(": ").append(text);
    } catch (const std::bad_alloc&) {
        reason = "out of memory";
    } catch (const std::exception& exception) {
        reason = exception.what();
    } catch (...) {
        reason = "an unknown failure";
    }
    return "the CAD kernel gave up (" + reason + ")";
}

}  // namespace

Error errorOfException(const std::string& entity, const std::string& remedy)
{
    try {
        throw;
    } catch (const GeometryFailure& failure) {
        return Error{ErrorCode::Unreadable, failure.what(), failure.entity(), {}, remedy};
    } catch (...) {
        return Error{ErrorCode::Unreadable, reasonInFlight(), entity, {}, remedy};
    }
}

void throwAsGeometryFailure(const std::string& entity)
{
    try {
        throw;
    } catch (const std::bad_alloc&) {
        throw;  // no fault of the entity
    } catch (...) {
        throw GeometryFailure(entity, reasonInFlight());
    }
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
