#pragma once

#include "base/assert.h"
#include "base/error.h"

#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

namespace mesher {

/// Either the value that was asked for or the Error that tells why there is none. Reading the one that is not
/// there breaks a precondition.
template <class T>
class [[nodiscard]] Result
{
    static_assert(!std::is_same_v<T, Error>, "a Result of an Error could not be told from a failure");
    static_assert(!std::is_reference_v<T>, "a Result owns its value");

public:
    using ValueType = T;

    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

    [[nodiscard]] bool hasValue() const { return state_.index() == 0; }
    [[nodiscard]] explicit operator bool() const { return hasValue(); }

    [[nodiscard]] T& value() &
    {
        MESHER_PRECONDITION(hasValue());
        return *std::get_if<0>(&state_);
    }
    [[nodiscard]] const T& value() const&
    {
        MESHER_PRECONDITION(hasValue());
        return *std::get_if<0>(&state_);
    }
    [[nodiscard]] T&& value() &&
    {
        MESHER_PRECONDITION(hasValue());
        return std::move(*std::get_if<0>(&state_));
    }
    [[nodiscard]] const Error& error() const
    {
        MESHER_PRECONDITION(!hasValue());
        return *std::get_if<1>(&state_);
    }

    [[nodiscard]] T& operator*() & { return value(); }
    [[nodiscard]] const T& operator*() const& { return value(); }
    [[nodiscard]] T&& operator*() && { return std::move(*this).value(); }
    [[nodiscard]] T* operator->() { return &value(); }
    [[nodiscard]] const T* operator->() const { return &value(); }

    /// The next step on the value, itself a Result; an error passes through unchanged.
    template <class Step>
    [[nodiscard]] auto andThen(Step&& step) && -> std::invoke_result_t<Step, T&&>
    {
        if (!hasValue()) return std::move(*std::get_if<1>(&state_));
        return std::forward<Step>(step)(std::move(*this).value());
    }

private:
    std::variant<T, Error> state_;
};

/// Success without a value, or the Error that tells why it failed.
template <>
class [[nodiscard]] Result<void>
{
public:
    using ValueType = void;

    Result() = default;
    Result(Error error) : error_(std::move(error)) {}

    [[nodiscard]] bool hasValue() const { return !error_.has_value(); }
    [[nodiscard]] explicit operator bool() const { return hasValue(); }
    [[nodiscard]] const Error& error() const
    {
        MESHER_PRECONDITION(!hasValue());
        return *error_;
    }

private:
    std::optional<Error> error_;
};

}  // namespace mesher
