#pragma once

#include "base/result.h"

#include <boost/program_options.hpp>

#include <charconv>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace mesher {

[[nodiscard]] Error usageError(std::string message, std::string remedy = "see mesher --help");

/// The arguments of a command, taken apart by its options; with positional arguments under the name "input".
[[nodiscard]] Result<boost::program_options::variables_map>
parseArguments(std::span<const std::string> arguments, boost::program_options::options_description options);

/// Reads the values of options into variables; the first error is kept.
class OptionReader
{
public:
    /// `found` must outlive the reader.
    explicit OptionReader(const boost::program_options::variables_map& found) : found_(found) {}

    /// Numbers are read by from_chars, whatever the locale: "1,5" and "1.5x" are refused.
    template <class Number>
    void read(const char* option, Number& target)
    {
        if (const std::optional<Number> value = numberOf<Number>(option)) target = *value;
    }
    template <class Number>
    void read(const char* option, std::optional<Number>& target)
    {
        if (const std::optional<Number> value = numberOf<Number>(option)) target = *value;
    }
    void read(const char* option, std::string& target);
    /// Each text given for the option, by a function from a text to a Result.
    template <class Value, class Parse>
    void readAll(const char* option, std::vector<Value>& targets, Parse parse)
    {
        for (const std::string& text : texts(option)) {
            Result<Value> value = parse(text);
            if (!value) return fail(value.error());
            targets.push_back(std::move(value).value());
        }
    }
    [[nodiscard]] bool isSet(const char* option) const { return found_[option].as<bool>(); }
    [[nodiscard]] std::optional<std::filesystem::path> path(const char* option) const;
    [[nodiscard]] std::vector<std::string> texts(const char* option) const;
    /// The one positional argument, which is a file; `what` it is.
    [[nodiscard]] std::filesystem::path onlyInput(const std::string& what);

    void fail(Error error);
    [[nodiscard]] const std::optional<Error>& error() const { return error_; }

private:
    template <class Number>
    std::optional<Number> numberOf(const char* option)
    {
        if (found_.count(option) == 0) return std::nullopt;
        const std::string& text = found_[option].as<std::string>();
        Number value{};
        const char* last = text.data() + text.size();
        const auto [end, code] = std::from_chars(text.data(), last, value);
        if (code == std::errc() && end == last && !text.empty()) return value;
        fail(usageError(
            std::string("--").append(option).append(" wants a number, not '").append(text).append("'")));
        return std::nullopt;
    }

    const boost::program_options::variables_map& found_;
    std::optional<Error> error_;
};

}  // namespace mesher
